// Small distorted bodies of every cell kind and dense assembly, for the tests of solid.
#pragma once
#include <doctest/doctest.h>
#include <random>

#include "material/samples.hpp"
#include "solid/cells.hpp"
#include "solid/grids.hpp"

namespace stiction::test {

using solid::Kinematics;

/// [1, 3] x [0, 1.5] (x [0, 1]) m in n cells a direction whose inner corners are shifted at random; sides
/// stay straight.
inline mesh::Mesh distorted(mesh::CellKind kind, std::array<int, 3> const& n) {
  Point const size(2, 1.5, 1);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  auto mesh = grid(kind, n, [&](Point const& at) {
    Point shift = Point::Zero();
    bool inner = true;
    for (int d = 0; d < mesh::info(kind).dim; ++d) {
      shift[d] = uniform(random) / n[static_cast<std::size_t>(d)];
      inner = inner && at[d] > 1e-9 && at[d] < 1 - 1e-9;
    }
    Point const moved = inner ? Point(at + shift) : at;
    return Point(Point(1, 0, 0) + size.cwiseProduct(moved));
  });
  straighten(mesh);
  return mesh;
}

/// One way of computing a body: every kind with each kinematics of its dimension and each interpolation, and
/// in the plane as a sheet.
struct Case {
  mesh::CellKind kind;
  Kinematics kinematics;
  solid::Interpolation interpolation;
  bool sheet = false; ///< in plane stress
  [[nodiscard]] int dim() const { return solid::dimension(kinematics); }
  [[nodiscard]] bool axisymmetric() const { return kinematics == Kinematics::axisymmetric; }
  [[nodiscard]] bool mean() const { return interpolation == solid::Interpolation::mean_dilatation; }
  [[nodiscard]] std::string words() const {
    return std::string(mesh::info(kind).name) + (axisymmetric() ? " axisymmetric" : "") +
           (mean() ? " mean dilatation" : "") + (sheet ? " in plane stress" : "");
  }
  /// Distorted, with n cells a direction.
  [[nodiscard]] solid::Body body(material::Material const& law, int n) const {
    return {"b", distorted(kind, {n, n, n}), law, 1, interpolation, {}, {}, sheet};
  }
};

inline std::vector<Case> all_cases() {
  using solid::Interpolation;
  std::vector<Case> cases;
  for (auto const kinematics :
       {Kinematics::plane_strain, Kinematics::axisymmetric, Kinematics::three_dimensional})
    for (auto const& cell : mesh::cell_table(solid::dimension(kinematics))) {
      cases.push_back({cell.kind, kinematics, Interpolation::plain});
      if (kinematics == Kinematics::plane_strain)
        cases.push_back({cell.kind, kinematics, Interpolation::plain, true});
      if (mesh::stiffness_rule(cell.kind).weights.size() > 1)
        cases.push_back({cell.kind, kinematics, Interpolation::mean_dilatation});
    }
  return cases;
}

template<class Act> void each_case(Act const& act) {
  for (auto const& each : all_cases()) {
    CAPTURE(each.words());
    act(each);
  }
}
template<class Act> void each_case_and_law(Act const& act) {
  each_case([&](Case const& each) {
    for (auto const& [name, law] : sample_materials()) {
      CAPTURE(name);
      act(each, law);
    }
  });
}

inline bool small_strain(material::Material const& law) {
  return std::visit([](auto const& l) { return std::decay_t<decltype(l)>::small_strain; }, law);
}

inline Vector random_vector(Eigen::Index n, double size, unsigned seed = 11) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  Vector v(n);
  for (Eigen::Index i = 0; i < n; ++i)
    v[i] = uniform(random);
  return v;
}

inline std::vector<bool> inner_nodes(mesh::Mesh const& mesh) {
  std::vector<bool> inner(ix(mesh.node_count()), true);
  for (auto const& facet : mesh::boundary(mesh))
    for (Index const node : facet.nodes)
      inner[ix(node)] = false;
  return inner;
}

/// The entries of v that belong to a node; unused components are zero.
inline Point at_node(Vector const& v, Index node, int dim) {
  Point point = Point::Zero();
  for (int i = 0; i < dim; ++i)
    point[i] = v[dim * node + i];
  return point;
}
inline void add_at_node(Vector& v, Index node, int dim, Point const& point) {
  for (int i = 0; i < dim; ++i)
    v[dim * node + i] += point[i];
}

/// u(X) at every node, [dim * nodes].
template<class Field> Vector nodal(mesh::Mesh const& mesh, Field const& field) {
  Vector u = Vector::Zero(mesh.dim * mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i)
    add_at_node(u, i, mesh.dim, field(node_position(mesh, i)));
  return u;
}

inline std::span<double const> view(Vector const& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}
inline std::span<double> view(Vector& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

inline Vector force(solid::Cells const& cells, Vector const& u) {
  Vector f = Vector::Zero(u.size());
  auto const pass = cells.add_force(view(u), view(f));
  return pass.sound() ? f : Vector::Constant(u.size(), std::numeric_limits<double>::quiet_NaN()).eval();
}

inline double energy(solid::Cells const& cells, Vector const& u) {
  Vector f = Vector::Zero(u.size());
  return cells.add_force(view(u), view(f)).energy;
}

/// Calls visit(row, column) for each entry of each cell's lower triangle, in the order of the map.
template<class Visit> void each_entry(solid::Cells const& cells, int dim, Visit&& visit) {
  cells.each_cell([&](std::span<Index const> nodes) {
    Indices dofs;
    for (Index const node : nodes)
      for (int i = 0; i < dim; ++i)
        dofs.push_back(dim * node + i);
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        visit(dofs[i], dofs[j]);
  });
}

/// Where each cell's lower triangle goes in a dense matrix of n x n values: entry row n + column, row >=
/// column.
inline solid::ScatterMap dense_map(solid::Cells const& cells, Index n, int dim) {
  solid::ScatterMap map;
  each_entry(cells, dim, [&](Index row, Index column) {
    map.push_back(std::max(row, column) * n + std::min(row, column));
  });
  return map;
}

/// What `add(map, values)` assembles, full and symmetric.
template<class Add> Dense assembled(solid::Cells const& cells, Index n, int dim, Add const& add) {
  std::vector<double> values(ix(n) * ix(n), 0.0);
  add(dense_map(cells, n, dim), std::span<double>(values));
  Eigen::Map<Dense const> const upper(values.data(), n, n); // columns of the map are our rows
  return upper.selfadjointView<Eigen::Upper>();
}

/// K(u), N/m.
inline Dense stiffness(solid::Cells const& cells, Vector const& u, int dim) {
  return assembled(cells, static_cast<Index>(u.size()), dim, [&](auto const& map, std::span<double> values) {
    cells.add_stiffness(view(u), 1, map, values);
  });
}

} // namespace stiction::test
