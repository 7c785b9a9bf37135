// Areas by quadrature over facets, and the walk along their edges.
#include "mesh/topology/surface.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "mesh/topology/hats.hpp"

namespace stiction::mesh {

namespace {

/// The share of every node of a facet in its area, m^2.
Vector facet_shares(Mesh const& mesh, Facet const& facet) {
  CellKind const kind = facet_kind(facet);
  if (info(kind).nodes > info(kind).corners)
    return hat_products(mesh.nodes, facet, false).rowwise().sum();
  auto const& rule = mass_rule(kind);
  Matrix positions(static_cast<Eigen::Index>(facet.nodes.size()), 3);
  for (std::size_t i = 0; i < facet.nodes.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = mesh.nodes.row(facet.nodes[i]);
  Vector shares = Vector::Zero(positions.rows());
  double area = 0;
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    Eigen::Matrix<double, 3, 2> const tangents =
        positions.transpose() * rule.gradients[static_cast<std::size_t>(q)];
    double const part = rule.weights[q] * tangents.col(0).cross(tangents.col(1)).norm();
    area += part;
    shares += part * rule.shape.row(q).transpose();
  }
  return shares * (area / shares.sum());
}

/// One run along an edge of a facet, between its corners in ascending order.
struct Run {
  std::pair<Index, Index> edge;
  std::size_t facet;
  bool forward;
  [[nodiscard]] bool operator<(Run const& other) const {
    return std::tie(edge, facet) < std::tie(other.edge, other.facet);
  }
};

std::vector<Run> sorted_runs(Set const& set) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < set.facets.size(); ++i) {
    auto const& nodes = set.facets[i].nodes;
    auto const corners = static_cast<std::size_t>(info(facet_kind(set.facets[i])).corners);
    for (std::size_t k = 0; k < corners; ++k) {
      Index const from = nodes[k], to = nodes[(k + 1) % corners];
      runs.push_back({std::minmax(from, to), i, from < to});
    }
  }
  std::sort(runs.begin(), runs.end());
  return runs;
}

std::string edge_words(Mesh const& mesh, std::pair<Index, Index> edge) {
  Eigen::RowVector3d const middle = (mesh.nodes.row(edge.first) + mesh.nodes.row(edge.second)) / 2;
  return fmt::format("the edge at ({:.6g}, {:.6g}, {:.6g}) m", middle[0], middle[1], middle[2]);
}

/// What is wrong with the facets [first, last) that share an edge, or nothing.
std::string fault(Mesh const& mesh, std::vector<Run>::const_iterator first,
                  std::vector<Run>::const_iterator last) {
  auto const& second = *std::next(first);
  if (last - first > 2)
    return fmt::format("{} facets share {}; a contact surface has two at an edge: split the set where it "
                       "branches",
                       last - first, edge_words(mesh, first->edge));
  if (last - first == 2 && first->forward == second.forward)
    return fmt::format("facets {} and {} run the same way along {}, so that one of them faces inwards; "
                       "turn the order of its nodes round",
                       first->facet + 1, second.facet + 1, edge_words(mesh, first->edge));
  return "";
}

} // namespace

CellKind facet_kind(Facet const& facet) {
  for (auto const kind : {CellKind::tri3, CellKind::tri6, CellKind::quad4, CellKind::quad8})
    if (static_cast<std::size_t>(info(kind).nodes) == facet.nodes.size())
      return kind;
  core::fail_expectation("a facet of 3, 4, 6 or 8 nodes", std::source_location::current());
}

Vector nodal_areas(Mesh const& mesh, Set const& set) {
  core::expect(mesh.dim == 3, "areas of nodes on the surface of a mesh in 3D");
  Vector areas = Vector::Zero(static_cast<Eigen::Index>(set.nodes.size()));
  for (auto const& facet : set.facets) {
    Vector const shares = facet_shares(mesh, facet);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      auto const found = std::lower_bound(set.nodes.begin(), set.nodes.end(), facet.nodes[i]);
      core::expect(found != set.nodes.end() && *found == facet.nodes[i], "facets within the set's nodes");
      areas[found - set.nodes.begin()] += shares[static_cast<Eigen::Index>(i)];
    }
  }
  return areas;
}

void check_surface(Mesh const& mesh, Set const& set, std::string const& name) {
  if (set.facets.empty())
    throw core::InputError(fmt::format("set \"{}\" has no facets, only {} nodes; a contact surface must be a "
                                       "part of the boundary, of several sides by the "
                                       "body's joined = {{ NAME = {{ \"SIDE\", \"SIDE\" }} }}",
                                       name, set.nodes.size()));
  if (mesh.dim != 3)
    return;
  constexpr std::size_t shown = 3;
  core::Complaints complaints;
  auto const runs = sorted_runs(set);
  for (auto first = runs.begin(); first != runs.end() && complaints.size() < shown;) {
    auto const last =
        std::find_if(first, runs.end(), [&](Run const& run) { return run.edge != first->edge; });
    if (auto const words = last - first > 1 ? fault(mesh, first, last) : ""; !words.empty())
      complaints.push_back({"", fmt::format("set \"{}\"", name), words});
    first = last;
  }
  if (!complaints.empty())
    throw core::InputError(complaints);
}

} // namespace stiction::mesh
