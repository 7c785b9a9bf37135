// Corner angles and Jacobians of every cell.
#include "mesh/topology/quality.hpp"

#include <Eigen/LU>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <numbers>

#include "core/error.hpp"

namespace stiction::mesh {

namespace {

constexpr std::size_t shown = 3; // problems of one sort spelled out, the rest counted

/// One cell of a mesh: `number` counts from 1 over all blocks.
struct Cell {
  Index number;
  CellInfo const* info;
  Index const* nodes;
};

using CornerNumbers = std::vector<int>;
/// Of one corner, [dim, dim], m.
using EdgeVectors = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, 3, 3>;

std::vector<CornerNumbers> neighbours_of(CellInfo const& cell) {
  Matrix const& nodes = reference_nodes(cell.kind);
  std::vector<CornerNumbers> result(static_cast<std::size_t>(cell.corners));
  for (auto const& [a, b] : cell.edges) {
    result[static_cast<std::size_t>(a)].push_back(b);
    result[static_cast<std::size_t>(b)].push_back(a);
  }
  for (int i = 0; i < cell.corners; ++i) {
    auto& ends = result[static_cast<std::size_t>(i)];
    Matrix edges(cell.dim, cell.dim);
    for (int k = 0; k < cell.dim; ++k)
      edges.row(k) = nodes.row(ends[static_cast<std::size_t>(k)]) - nodes.row(i);
    if (edges.determinant() < 0)
      std::swap(ends[0], ends[1]);
  }
  return result;
}

void for_each_cell(Mesh const& mesh, std::function<void(Cell const&)> const& act) {
  Index number = 0;
  for (auto const& block : mesh.blocks) {
    CellInfo const& cell = info(block.kind);
    for (std::size_t first = 0; first < block.nodes.size(); first += static_cast<std::size_t>(cell.nodes))
      act({++number, &cell, &block.nodes[first]});
  }
}

/// Corners joined to each corner of a kind, ordered so that their edges have a positive determinant.
std::vector<CornerNumbers> const& neighbours(CellKind kind) {
  static auto const all = [] {
    std::vector<std::vector<CornerNumbers>> result;
    for (auto const& cell : cell_table())
      result.push_back(neighbours_of(cell));
    return result;
  }();
  return all.at(static_cast<std::size_t>(kind));
}

/// Without a factorization.
double determinant(EdgeVectors const& edges) {
  return edges.rows() == 2 ? edges.topLeftCorner<2, 2>().determinant()
                           : edges.topLeftCorner<3, 3>().determinant();
}

/// Edges that leave one corner.
EdgeVectors edges_at(Mesh const& mesh, Cell const& cell, int corner) {
  auto const& ends = neighbours(cell.info->kind)[static_cast<std::size_t>(corner)];
  EdgeVectors edges(mesh.dim, mesh.dim);
  for (int i = 0; i < mesh.dim; ++i)
    edges.row(i) =
        mesh.nodes.row(cell.nodes[ends[static_cast<std::size_t>(i)]]) - mesh.nodes.row(cell.nodes[corner]);
  return edges;
}

/// Volume of the unit edges of the worst corner over that of the ideal one.
double scaled_jacobian(Mesh const& mesh, Cell const& cell) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < cell.info->corners; ++i) {
    EdgeVectors const edges = edges_at(mesh, cell, i);
    double const lengths = edges.rowwise().norm().prod();
    least = std::min(least, lengths > 0 ? determinant(edges) / lengths : 0.0);
  }
  bool const simplex = cell.info->corners == mesh.dim + 1;
  double const regular = mesh.dim == 2 ? std::sqrt(0.75) : std::sqrt(0.5);
  return least / (simplex ? regular : 1.0);
}

/// Takes the angles at one corner into account: in 2D beyond 180 degrees too, in 3D between every two edges.
void add_angles(Quality& result, EdgeVectors const& edges) {
  double const degree = 180 / std::numbers::pi;
  for (Eigen::Index i = 0; i < edges.rows(); ++i)
    for (Eigen::Index j = i + 1; j < edges.rows(); ++j) {
      auto const a = edges.row(i), b = edges.row(j);
      double const across =
          std::sqrt(std::max(0.0, a.squaredNorm() * b.squaredNorm() - std::pow(a.dot(b), 2)));
      double const sine = edges.rows() == 2 ? determinant(edges) : across;
      double const angle = std::atan2(sine, a.dot(b)) * degree;
      result.min_angle = std::min(result.min_angle, angle);
      result.max_angle = std::max(result.max_angle, angle < 0 ? angle + 360 : angle);
    }
}

/// Smallest Jacobian determinant over the quadrature points and corners, over the cell's mean, so that curved
/// sides count.
double mapped_jacobian(Mesh const& mesh, Cell const& cell, Interpolation const& rule) {
  Matrix coordinates(cell.info->nodes, mesh.dim);
  for (int i = 0; i < cell.info->nodes; ++i)
    coordinates.row(i) = mesh.nodes.row(cell.nodes[i]);
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for (auto const& gradient : rule.gradients) {
    double const change = determinant(EdgeVectors(coordinates.transpose() * gradient));
    least = std::min(least, change);
    sum += std::abs(change);
  }
  return sum > 0 ? least * static_cast<double>(rule.gradients.size()) / sum : 0.0;
}

/// Quadrature points and nodes of a kind, where its Jacobian must be positive.
Interpolation const& sample_points(CellKind kind) {
  static auto const all = [] {
    std::vector<Interpolation> result;
    for (auto const& cell : cell_table()) {
      Matrix const &rule = stiffness_rule(cell.kind).points, &nodes = reference_nodes(cell.kind);
      Matrix points(rule.rows() + nodes.rows(), cell.dim);
      points << rule, nodes;
      result.push_back(interpolate(cell.kind, points, Vector::Zero(points.rows())));
    }
    return result;
  }();
  return all.at(static_cast<std::size_t>(kind));
}

/// At corners and quadrature points.
double least_jacobian(Mesh const& mesh, Cell const& cell) {
  return std::min(scaled_jacobian(mesh, cell), mapped_jacobian(mesh, cell, sample_points(cell.info->kind)));
}

/// Collects complaints of one sort: the first few in words, the rest as a count.
class Problems {
public:
  Problems(core::Complaints& complaints, std::string name)
      : complaints_(&complaints), name_(std::move(name)) {}
  ~Problems() {
    if (count_ > shown)
      complaints_->back().text += fmt::format(" (and {} more of this sort)", count_ - shown);
  }
  Problems(Problems const&) = delete;
  Problems& operator=(Problems const&) = delete;
  void add(std::string const& text) {
    if (++count_ <= shown)
      complaints_->push_back({"", name_, text});
  }

private:
  core::Complaints* complaints_;
  std::string name_;
  std::size_t count_ = 0;
};

std::string centre_words(Mesh const& mesh, Cell const& cell) {
  Vector centre = Vector::Zero(mesh.dim);
  for (int i = 0; i < cell.info->corners; ++i)
    centre += mesh.nodes.row(cell.nodes[i]).transpose() / cell.info->corners;
  return mesh.dim == 2 ? fmt::format("({:.6g}, {:.6g}) m", centre[0], centre[1])
                       : fmt::format("({:.6g}, {:.6g}, {:.6g}) m", centre[0], centre[1], centre[2]);
}

void check_numbering(Mesh const& mesh, std::string const& name, core::Complaints& complaints) {
  Problems problems(complaints, name);
  for_each_cell(mesh, [&](Cell const& cell) {
    Indices nodes(cell.nodes, cell.nodes + cell.info->nodes);
    std::sort(nodes.begin(), nodes.end());
    if (nodes.front() < 0 || nodes.back() >= mesh.node_count())
      problems.add(fmt::format("cell {} ({}) names a node outside 1..{}", cell.number, cell.info->name,
                               mesh.node_count()));
    else if (std::adjacent_find(nodes.begin(), nodes.end()) != nodes.end())
      problems.add(fmt::format("cell {} ({}) at {} has node {} twice", cell.number, cell.info->name,
                               centre_words(mesh, cell),
                               *std::adjacent_find(nodes.begin(), nodes.end()) + 1));
  });
}

void check_nodes(Mesh const& mesh, std::string const& name, core::Complaints& complaints) {
  std::vector<bool> used(static_cast<std::size_t>(mesh.node_count()));
  for (auto const& block : mesh.blocks)
    for (Index const node : block.nodes)
      used[static_cast<std::size_t>(node)] = true;
  Problems infinite(complaints, name);
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (!mesh.nodes.row(i).allFinite())
      infinite.add(fmt::format("node {} has a coordinate that is not a finite number", i + 1));
  Problems unused(complaints, name);
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (!used[static_cast<std::size_t>(i)])
      unused.add(fmt::format("node {} belongs to no cell; remove it or mesh its surroundings", i + 1));
}

void check_shapes(Mesh const& mesh, std::string const& name, core::Complaints& complaints) {
  Problems problems(complaints, name);
  for_each_cell(mesh, [&](Cell const& cell) {
    double const jacobian = least_jacobian(mesh, cell);
    if (jacobian > degenerate)
      return;
    problems.add(fmt::format("cell {} ({}) at {} is {}: its scaled Jacobian is {:.3g}, it must be > {:g}",
                             cell.number, cell.info->name, centre_words(mesh, cell),
                             jacobian < -degenerate ? "inverted" : "degenerate", jacobian, degenerate));
  });
}

} // namespace

Quality quality(Mesh const& mesh) {
  Quality result;
  result.nodes = mesh.node_count();
  result.cells = mesh.cell_count();
  result.min_angle = 180;
  result.min_edge = std::numeric_limits<double>::infinity();
  std::vector<double> jacobians;
  for_each_cell(mesh, [&](Cell const& cell) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (int i = 0; i < cell.info->corners; ++i) {
      EdgeVectors const edges = edges_at(mesh, cell, i);
      add_angles(result, edges);
      shortest = std::min(shortest, edges.rowwise().norm().minCoeff());
      longest = std::max(longest, edges.rowwise().norm().maxCoeff());
    }
    result.min_edge = std::min(result.min_edge, shortest);
    result.max_aspect = std::max(result.max_aspect, longest / shortest);
    jacobians.push_back(scaled_jacobian(mesh, cell));
  });
  if (jacobians.empty())
    return result;
  std::sort(jacobians.begin(), jacobians.end());
  result.min_jacobian = jacobians.front();
  result.median_jacobian = jacobians[jacobians.size() / 2];
  return result;
}

double least_jacobian(Mesh const& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for_each_cell(mesh, [&](Cell const& cell) { least = std::min(least, least_jacobian(mesh, cell)); });
  return least;
}

std::string report(Mesh const& mesh, std::string const& name) {
  Quality const q = quality(mesh);
  std::string text =
      fmt::format("{}: {} cells, {} nodes\n"
                  "  scaled Jacobian {:.3f} to 1, median {:.3f}; angles {:.1f} to {:.1f} degrees\n"
                  "  longest over shortest side at most {:.2f}; shortest side {:.4g} m\n",
                  name, q.cells, q.nodes, q.min_jacobian, q.median_jacobian, q.min_angle, q.max_angle,
                  q.max_aspect, q.min_edge);
  for (auto const& [set, part] : mesh.sets)
    text += fmt::format("  set {}: {} nodes, {} facets\n", set, part.nodes.size(), part.facets.size());
  return text;
}

void check(Mesh const& mesh, std::string const& name) {
  core::Complaints complaints;
  if (mesh.cell_count() == 0)
    complaints.push_back({"", name, "the mesh has no cells"});
  check_numbering(mesh, name, complaints);
  if (complaints.empty()) {
    check_nodes(mesh, name, complaints);
    if (mesh.nodes.allFinite())
      check_shapes(mesh, name, complaints);
  }
  for (auto const& [set, part] : mesh.sets)
    if (part.nodes.empty())
      complaints.push_back({"", name, fmt::format("set \"{}\" is empty", set)});
  if (!complaints.empty())
    throw core::InputError(complaints);
}

} // namespace stiction::mesh
