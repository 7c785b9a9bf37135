// Lagrange and serendipity functions of facets, written out for speed, and their reference domains.
#include "contact/surface/cell_facet.hpp"

#include <utility>

#include "contact/surface/facet.hpp"
#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"

namespace stiction::contact {

namespace {

constexpr int nodes_of[] = {2, 3, 3, 4, 6, 8};
constexpr int corner_counts[] = {2, 2, 3, 4, 3, 4};
constexpr double square_nodes[8][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};

std::size_t row(FacetKind kind) {
  return static_cast<std::size_t>(kind);
}

FacetShape line2(Vec2 const& at) {
  FacetShape s;
  s.N.head<2>() << 0.5 * (1 - at.x()), 0.5 * (1 + at.x());
  s.by[0].head<2>() << -0.5, 0.5;
  return s;
}

FacetShape line3(Vec2 const& at) {
  double const x = at.x();
  FacetShape s;
  s.N.head<3>() << 0.5 * x * (x - 1), 0.5 * x * (x + 1), 1 - x * x;
  s.by[0].head<3>() << x - 0.5, x + 0.5, -2 * x;
  s.by2[0].head<3>() << 1, 1, -2;
  return s;
}

FacetShape tri3(Vec2 const& at) {
  FacetShape s;
  s.N.head<3>() << 1 - at.x() - at.y(), at.x(), at.y();
  s.by[0].head<3>() << -1, 1, 0;
  s.by[1].head<3>() << -1, 0, 1;
  return s;
}

/// L (2 L - 1) at the corners, 4 La Lb on the sides.
FacetShape tri6(Vec2 const& at) {
  auto const L = tri3(at);
  auto const slope = [&](int a, int corner) { return L.by[ix(a)][corner]; };
  FacetShape s;
  for (int k = 0; k < 3; ++k) {
    int const next = (k + 1) % 3, m = 3 + k;
    s.N[k] = L.N[k] * (2 * L.N[k] - 1);
    s.N[m] = 4 * L.N[k] * L.N[next];
    for (int a = 0; a < 2; ++a) {
      s.by[ix(a)][k] = (4 * L.N[k] - 1) * slope(a, k);
      s.by[ix(a)][m] = 4 * (L.N[k] * slope(a, next) + L.N[next] * slope(a, k));
    }
    for (auto const& [a, b] : {std::pair{0, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
      s.by2[ix(a + b)][k] = 4 * slope(a, k) * slope(b, k);
      s.by2[ix(a + b)][m] = 4 * (slope(a, k) * slope(b, next) + slope(a, next) * slope(b, k));
    }
  }
  return s;
}

FacetShape quad4(Vec2 const& at) {
  FacetShape s;
  for (int k = 0; k < 4; ++k) {
    double const x = square_nodes[k][0], y = square_nodes[k][1], u = 1 + x * at.x(), v = 1 + y * at.y();
    s.N[k] = 0.25 * u * v;
    s.by[0][k] = 0.25 * x * v;
    s.by[1][k] = 0.25 * y * u;
    s.by2[1][k] = 0.25 * x * y;
  }
  return s;
}

/// Corners: (1 + x xi)(1 + y eta)(x xi + y eta - 1)/4. Sides: (1 - xi^2)(1 + y eta)/2 and its mirror image.
FacetShape quad8(Vec2 const& at) {
  FacetShape s;
  for (int k = 0; k < 4; ++k) {
    double const x = square_nodes[k][0], y = square_nodes[k][1], p = x * at.x(), q = y * at.y();
    s.N[k] = 0.25 * (1 + p) * (1 + q) * (p + q - 1);
    s.by[0][k] = 0.25 * x * (1 + q) * (2 * p + q);
    s.by[1][k] = 0.25 * y * (1 + p) * (2 * q + p);
    s.by2[0][k] = 0.5 * (1 + q);
    s.by2[1][k] = 0.25 * x * y * (2 * p + 2 * q + 1);
    s.by2[2][k] = 0.5 * (1 + p);
  }
  for (int k = 4; k < 8; ++k) {
    int const a = square_nodes[k][0] == 0 ? 0 : 1, b = 1 - a; // along the side and across it
    double const y = square_nodes[k][b], hump = 1 - at[a] * at[a], v = 1 + y * at[b];
    s.N[k] = 0.5 * hump * v;
    s.by[ix(a)][k] = -at[a] * v;
    s.by[ix(b)][k] = 0.5 * y * hump;
    s.by2[ix(2 * a)][k] = -v;
    s.by2[1][k] = -at[a] * y;
  }
  return s;
}

FacetRule rule_from(mesh::Rule const& rule) {
  FacetRule result;
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    result.points.emplace_back(rule.points(q, 0), rule.points.cols() > 1 ? rule.points(q, 1) : 0.0);
    result.weights.push_back(rule.weights[q]);
  }
  return result;
}

} // namespace

int node_count(FacetKind kind) {
  return nodes_of[row(kind)];
}
int corner_count(FacetKind kind) {
  return corner_counts[row(kind)];
}

FacetKind kind_of(int dim, std::size_t nodes) {
  if (dim == 2)
    return nodes == 2 ? FacetKind::line2 : FacetKind::line3;
  for (auto const kind : {FacetKind::tri3, FacetKind::quad4, FacetKind::tri6, FacetKind::quad8})
    if (ix(node_count(kind)) == nodes)
      return kind;
  core::fail_expectation("a facet of 3, 4, 6 or 8 nodes", std::source_location::current());
}

FacetKind linear_kind(FacetKind kind) {
  switch (kind) {
  case FacetKind::line3:
    return FacetKind::line2;
  case FacetKind::tri6:
    return FacetKind::tri3;
  case FacetKind::quad8:
    return FacetKind::quad4;
  default:
    return kind;
  }
}

FacetShape facet_shape(FacetKind kind, Vec2 const& at) {
  static constexpr FacetShape (*functions[])(Vec2 const&) = {line2, line3, tri3, quad4, tri6, quad8};
  return functions[row(kind)](at);
}

Vec2 corner_coordinates(FacetKind kind, int corner) {
  int const corners = corner_count(kind);
  return corners == 2 ? Vec2(2.0 * corner - 1, 0) : node_coordinates(corners, corner);
}

Vec2 middle_coordinates(FacetKind kind) {
  return corner_count(kind) == 3 ? Vec2(1.0 / 3, 1.0 / 3) : Vec2(0, 0);
}

double domain_size(FacetKind kind) {
  static constexpr double sizes[] = {2, 0.5, 4};
  return sizes[ix(corner_count(kind) - 2)];
}

double inside_of(FacetKind kind, int side, Vec2 const& at) {
  int const corners = corner_count(kind);
  if (corners == 2)
    return 0.5 * (side == 0 ? 1 + at.x() : 1 - at.x());
  return inside(corners, side, at);
}

Vec2 coordinates_on_side(FacetKind kind, int side, double part) {
  int const corners = corner_count(kind);
  return corners == 2 ? corner_coordinates(kind, side) : side_coordinates(corners, side, part);
}

double part_of_side(FacetKind kind, int side, Vec2 const& at) {
  int const corners = corner_count(kind);
  return corners == 2 ? 0 : side_part(corners, side, at);
}

FacetRule const& facet_rule(int corners, bool fine) {
  static FacetRule const rules[3][2] = {{rule_from(mesh::cube_rule(1, 2)), rule_from(mesh::cube_rule(1, 3))},
                                        {rule_from(mesh::triangle_3()), rule_from(mesh::triangle_6())},
                                        {rule_from(mesh::cube_rule(2, 2)), rule_from(mesh::cube_rule(2, 3))}};
  return rules[corners - 2][fine ? 1 : 0];
}

} // namespace stiction::contact
