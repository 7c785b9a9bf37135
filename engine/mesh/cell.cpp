// The rows of the table of cell kinds: node order of VTK, shape functions, quadrature rules.
#include "mesh/cell.hpp"

#include <array>
#include <cmath>

#include "core/error.hpp"

namespace stiction::mesh {

namespace {

using RowVector = Eigen::RowVectorXd;
/// Values N [nodes] and derivatives dN [nodes, dim] at reference point x [dim].
using Shape = void (*)(RowVector const& x, Eigen::Ref<RowVector> N, Matrix& dN);

struct Rule {
  Matrix points;
  Vector weights;
};

struct Row {
  CellInfo info;
  Matrix reference_nodes;
  Shape shape;
  Rule stiffness, mass;
};

void shape_tri3(RowVector const& x, Eigen::Ref<RowVector> N, Matrix& dN) {
  N << 1 - x[0] - x[1], x[0], x[1];
  dN << -1, -1, 1, 0, 0, 1;
}

void shape_tri6(RowVector const& x, Eigen::Ref<RowVector> N, Matrix& dN) {
  double const a = 1 - x[0] - x[1], b = x[0], c = x[1];
  N << a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a;
  dN << 1 - 4 * a, 1 - 4 * a, //
      4 * b - 1, 0,           //
      0, 4 * c - 1,           //
      4 * (a - b), -4 * b,    //
      4 * c, 4 * b,           //
      -4 * c, 4 * (a - c);
}

constexpr std::array<std::array<double, 2>, 4> square_corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

void shape_quad4(RowVector const& x, Eigen::Ref<RowVector> N, Matrix& dN) {
  for (int i = 0; i < 4; ++i) {
    auto const [s, t] = square_corners[static_cast<std::size_t>(i)];
    double const u = 1 + s * x[0], v = 1 + t * x[1];
    N[i] = u * v / 4;
    dN.row(i) << s * v / 4, t * u / 4;
  }
}

void shape_quad8(RowVector const& x, Eigen::Ref<RowVector> N, Matrix& dN) {
  double const p = x[0], q = x[1];
  for (int i = 0; i < 4; ++i) {
    auto const [s, t] = square_corners[static_cast<std::size_t>(i)];
    double const u = 1 + s * p, v = 1 + t * q;
    N[i] = u * v * (s * p + t * q - 1) / 4;
    dN.row(i) << s * v * (2 * s * p + t * q) / 4, t * u * (s * p + 2 * t * q) / 4;
  }
  for (int i = 4; i < 8; i += 2) { // sides 4 (q = -1) and 6 (q = 1), then 5 (p = 1) and 7 (p = -1)
    double const t = i == 4 ? -1 : 1, s = -t;
    N[i] = (1 - p * p) * (1 + t * q) / 2;
    dN.row(i) << -p * (1 + t * q), t * (1 - p * p) / 2;
    N[i + 1] = (1 - q * q) * (1 + s * p) / 2;
    dN.row(i + 1) << s * (1 - q * q) / 2, -q * (1 + s * p);
  }
}

Matrix rows(std::vector<std::array<double, 2>> const& points) {
  Matrix result(static_cast<Eigen::Index>(points.size()), 2);
  for (std::size_t i = 0; i < points.size(); ++i)
    result.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1];
  return result;
}

/// Gauss rule with n = 2 or 3 points a direction on [-1, 1]^2.
Rule square_rule(int n) {
  double const outer = n == 2 ? 1 / std::sqrt(3.0) : std::sqrt(0.6);
  std::vector<double> const x = n == 2 ? std::vector{-outer, outer} : std::vector{-outer, 0.0, outer};
  std::vector<double> const w = n == 2 ? std::vector{1.0, 1.0} : std::vector{5.0 / 9, 8.0 / 9, 5.0 / 9};
  Rule rule{Matrix(n * n, 2), Vector(n * n)};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      auto const a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      rule.points.row(j * n + i) << x[a], x[b];
      rule.weights[j * n + i] = w[a] * w[b];
    }
  return rule;
}

/// Orbits {b, weight}: three points with barycentric coordinates (1 - 2 b, b, b); b = 1/3 is the centroid.
Rule triangle_rule(std::vector<std::array<double, 2>> const& orbits) {
  std::vector<std::array<double, 2>> points;
  std::vector<double> weights;
  for (auto const& [b, weight] : orbits) {
    double const a = 1 - 2 * b;
    bool const centroid = std::abs(a - b) < 1e-12;
    points.push_back({b, b});
    if (!centroid) {
      points.push_back({a, b});
      points.push_back({b, a});
    }
    weights.insert(weights.end(), centroid ? 1 : 3, weight / 2); // the reference triangle has area 1/2
  }
  return {rows(points), Eigen::Map<Vector>(weights.data(), static_cast<Eigen::Index>(weights.size()))};
}

/// Degrees 1, 2 and 4 (Dunavant, Int. J. Numer. Meth. Engng 21, 1985).
Rule triangle_1() {
  return triangle_rule({{1.0 / 3, 1.0}});
}
Rule triangle_3() {
  return triangle_rule({{1.0 / 6, 1.0 / 3}});
}
Rule triangle_6() {
  double const b1 = (8 - std::sqrt(10.0) + std::sqrt(38 - 44 * std::sqrt(0.4))) / 18;
  double const b2 = (8 - std::sqrt(10.0) - std::sqrt(38 - 44 * std::sqrt(0.4))) / 18;
  double const spread = std::sqrt(213125 - 53320 * std::sqrt(10.0));
  return triangle_rule({{b1, (620 + spread) / 3720}, {b2, (620 - spread) / 3720}});
}

std::vector<Row> make_rows() {
  using Facets = std::vector<std::vector<int>>;
  Facets const tri3{{0, 1}, {1, 2}, {2, 0}}, tri6{{0, 1, 3}, {1, 2, 4}, {2, 0, 5}};
  Facets const quad4{{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  Facets const quad8{{0, 1, 4}, {1, 2, 5}, {2, 3, 6}, {3, 0, 7}};
  Matrix const tri = rows({{0, 0}, {1, 0}, {0, 1}, {.5, 0}, {.5, .5}, {0, .5}});
  Matrix const quad = rows({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  return {
      {{CellKind::tri3, "tri3", 2, 3, 3, tri3, 5, 2}, tri.topRows(3), shape_tri3, triangle_1(), triangle_3()},
      {{CellKind::tri6, "tri6", 2, 6, 3, tri6, 22, 9}, tri, shape_tri6, triangle_3(), triangle_6()},
      {{CellKind::quad4, "quad4", 2, 4, 4, quad4, 9, 3},
       quad.topRows(4),
       shape_quad4,
       square_rule(2),
       square_rule(2)},
      {{CellKind::quad8, "quad8", 2, 8, 4, quad8, 23, 16}, quad, shape_quad8, square_rule(3), square_rule(3)},
  };
}

Row const& row(CellKind kind) {
  static std::vector<Row> const table = make_rows();
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

std::vector<std::string> cell_names() {
  std::vector<std::string> names;
  for (auto const& cell : cell_table())
    names.emplace_back(cell.name);
  return names;
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
  Row const& cell = row(kind);
  core::expect(points.cols() == cell.info.dim && points.rows() == weights.size(),
               "reference points [points, dim] and weights [points]");
  Interpolation result{points, weights, Matrix(points.rows(), cell.info.nodes), {}};
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    Matrix gradient(cell.info.nodes, cell.info.dim);
    cell.shape(points.row(i), result.shape.row(i), gradient);
    result.gradients.push_back(std::move(gradient));
  }
  return result;
}

} // namespace stiction::mesh
