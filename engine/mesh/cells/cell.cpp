// The rows of the table of cell kinds: node order of VTK, facets, gmsh's order, quadrature rules.
#include "mesh/cells/cell.hpp"

#include <numeric>

#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"
#include "mesh/cells/shapes.hpp"

namespace stiction::mesh {

namespace {

struct Traits {
  CellInfo info;
  Matrix reference_nodes;
  Shape shape;
  Rule stiffness, mass;
};

using Locals = std::vector<std::vector<int>>;
using Edges = std::vector<std::array<int, 2>>;

/// A kind whose node order is also gmsh's.
CellInfo plane(CellKind kind, std::string_view name, Locals facets, std::array<int, 2> vtk_gmsh) {
  bool const triangle = facets.size() == 3, second_order = facets.front().size() == 3;
  int const corners = triangle ? 3 : 4;
  Edges const edges = triangle ? Edges{{0, 1}, {1, 2}, {2, 0}} : Edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  std::vector<int> order(static_cast<std::size_t>(second_order ? 2 * corners : corners));
  std::iota(order.begin(), order.end(), 0);
  return {kind,        name,        2,    static_cast<int>(order.size()), corners, edges, std::move(facets),
          vtk_gmsh[0], vtk_gmsh[1], order};
}

std::vector<Traits> plane_rows() {
  Locals const tri3{{0, 1}, {1, 2}, {2, 0}}, tri6{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}};
  Locals const quad4{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  Locals const quad8{{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
  Matrix const &tri = triangle_nodes(), &quad = square_nodes();
  return {
      {plane(CellKind::tri3, "tri3", tri3, {5, 2}), tri.topRows(3), shape_tri3, triangle_1(), triangle_3()},
      {plane(CellKind::tri6, "tri6", tri6, {22, 9}), tri, shape_tri6, triangle_3(), triangle_6()},
      {plane(CellKind::quad4, "quad4", quad4, {9, 3}), quad.topRows(4), shape_quad4, cube_rule(2, 2),
       cube_rule(2, 2)},
      {plane(CellKind::quad8, "quad8", quad8, {23, 16}), quad, shape_quad8, cube_rule(2, 3), cube_rule(2, 3)},
  };
}

/// Corners of the facets, so that every facet is a tri3, tri6, quad4 or quad8 seen from outside.
std::vector<Traits> solid_rows() {
  Edges const tet{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  Edges const hex{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                  {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  Locals const tet4{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  Locals const tet10{{0, 2, 1, 6, 5, 4}, {0, 1, 3, 4, 8, 7}, {1, 2, 3, 5, 9, 8}, {0, 3, 2, 7, 9, 6}};
  Locals const hex8{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  Locals const hex20{{0, 3, 2, 1, 11, 10, 9, 8},  {4, 5, 6, 7, 12, 13, 14, 15}, {0, 1, 5, 4, 8, 17, 12, 16},
                     {1, 2, 6, 5, 9, 18, 13, 17}, {2, 3, 7, 6, 10, 19, 14, 18}, {3, 0, 4, 7, 11, 16, 15, 19}};
  std::vector<int> const tet10_gmsh{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  std::vector<int> const hex20_gmsh{0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
  std::vector<int> const tet4_gmsh(tet10_gmsh.begin(), tet10_gmsh.begin() + 4);
  std::vector<int> const hex8_gmsh(hex20_gmsh.begin(), hex20_gmsh.begin() + 8);
  Matrix const &T = tetrahedron_nodes(), &H = cube_nodes();
  return {
      {{CellKind::tet4, "tet4", 3, 4, 4, tet, tet4, 10, 4, tet4_gmsh},
       T.topRows(4),
       shape_tet4,
       tetrahedron_1(),
       tetrahedron_4()},
      {{CellKind::tet10, "tet10", 3, 10, 4, tet, tet10, 24, 11, tet10_gmsh},
       T,
       shape_tet10,
       tetrahedron_4(),
       tetrahedron_14()},
      {{CellKind::hex8, "hex8", 3, 8, 8, hex, hex8, 12, 5, hex8_gmsh},
       H.topRows(8),
       shape_hex8,
       cube_rule(3, 2),
       cube_rule(3, 2)},
      {{CellKind::hex20, "hex20", 3, 20, 8, hex, hex20, 25, 17, hex20_gmsh},
       H,
       shape_hex20,
       cube_rule(3, 3),
       cube_rule(3, 3)},
  };
}

std::vector<Traits> make_rows() {
  auto rows = plane_rows();
  for (auto& solid : solid_rows())
    rows.push_back(std::move(solid));
  return rows;
}

Traits const& row(CellKind kind) {
  static std::vector<Traits> const table = make_rows();
  return table.at(static_cast<std::size_t>(kind));
}

/// One value per kind, made at first use.
template<class Make> auto per_kind(Make make) {
  std::vector<decltype(make(CellKind::tri3))> result;
  for (auto const& cell : cell_table())
    result.push_back(make(cell.kind));
  return result;
}

} // namespace

CellInfo const& info(CellKind kind) {
  return row(kind).info;
}

std::vector<CellInfo> const& cell_table() {
  static std::vector<CellInfo> const table = [] {
    std::vector<CellInfo> infos;
    for (auto const& each : make_rows())
      infos.push_back(each.info);
    return infos;
  }();
  return table;
}

std::vector<CellInfo> cell_table(int dim) {
  std::vector<CellInfo> kinds;
  for (auto const& cell : cell_table())
    if (cell.dim == dim)
      kinds.push_back(cell);
  return kinds;
}

core::Choices<CellKind> cell_choices(int dim) {
  auto const kinds = cell_table(dim);
  core::Choices<CellKind> choices{kinds.front().kind, {}};
  for (auto const& cell : kinds)
    choices.names.emplace_back(cell.name);
  return choices;
}

std::optional<CellKind> kind_named(std::string_view name) {
  for (auto const& cell : cell_table())
    if (cell.name == name)
      return cell.kind;
  return std::nullopt;
}

Matrix const& reference_nodes(CellKind kind) {
  return row(kind).reference_nodes;
}

Interpolation const& stiffness_rule(CellKind kind) {
  static auto const rules =
      per_kind([](CellKind k) { return interpolate(k, row(k).stiffness.points, row(k).stiffness.weights); });
  return rules.at(static_cast<std::size_t>(kind));
}

Interpolation const& mass_rule(CellKind kind) {
  static auto const rules =
      per_kind([](CellKind k) { return interpolate(k, row(k).mass.points, row(k).mass.weights); });
  return rules.at(static_cast<std::size_t>(kind));
}

Interpolation interpolate(CellKind kind, Matrix const& points, Vector const& weights) {
  Traits const& cell = row(kind);
  core::expect(points.cols() == cell.info.dim && points.rows() == weights.size(),
               "reference points [points, dim] and weights [points]");
  Interpolation result{points, weights, Matrix(points.rows(), cell.info.nodes), {}};
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    auto [N, dN] = cell.shape(points.row(i));
    result.shape.row(i) = N;
    result.gradients.push_back(std::move(dN));
  }
  return result;
}

} // namespace stiction::mesh
