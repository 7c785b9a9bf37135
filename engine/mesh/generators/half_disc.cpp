// The half disc: a bulged half square inside, rings of quadrilaterals around it, optionally coarsened 3 to 1.
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

#include "core/error.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/generators/quads.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

using Point = std::array<double, 2>;

constexpr double half_square = 0.5; // half width of the inner square over the radius
constexpr double bulge = 0.1;       // of its sides: corners of about 112 degrees instead of 90
constexpr double inner_ratio =
    0.64;                         // inner cell size over arc cell size without coarsening: 4 half_square / pi
constexpr int rows_per_level = 3; // rings of equal cell count before the next 3 to 1 transition

/// One ring of cells, counted from the arc inwards.
struct Row {
  double thickness;
  bool transition; ///< three cells outside meet one inside
};

/// How many cells, and where: all lengths over the radius, the arc at depth 0.
struct Layout {
  Index inner = 1;       ///< cells along half a side of the inner square
  std::vector<Row> rows; ///< from the arc inwards, thicknesses sum to 1 (of the ring)
};

void check(HalfDiscOptions const& options) {
  core::Complaints complaints;
  check_numbers(complaints, {"half_disc.centre", options.centre, "m", core::any_number});
  check_numbers(complaints, {"half_disc.radius", {options.radius}, "m", core::positive, 1});
  check_numbers(complaints, {"half_disc.grading", {options.grading}, "1", {1, 9}, 1});
  double const finest = options.radius * std::sqrt(3 / most_cells_2d);
  if (complaints.empty())
    check_numbers(complaints, {"half_disc.size", {options.size}, "m", {finest, options.radius}, 1});
  if (!complaints.empty())
    throw core::InputError(complaints);
}

/// Point of the inner square's outline; w in [-2, 2] runs from its lower left end over the top to the right.
Point outline(double w) {
  double const c = half_square;
  if (std::abs(w) <= 1)
    return {c * w, c * (1 + bulge * (1 - w * w))};
  double const v = 2 - std::abs(w);
  return {std::copysign(c * (1 + bulge * (1 - v * v)), w), c * v};
}

/// Point of the ring: t = 0 on the inner square, 1 on the arc; i of n counts from the right end.
Point ring_point(double t, Index i, Index n) {
  double const w = 2.0 * (n - 2 * i) / n; // 0 at the crown, exactly antisymmetric
  double const angle = w * std::numbers::pi / 4;
  auto const [x, y] = outline(w);
  bool const flat = i == 0 || i == n;
  return {(1 - t) * x + t * std::sin(angle), flat ? 0.0 : (1 - t) * y + t * std::cos(angle)};
}

/// Rows of about square cells; nothing when the ring has no room for that many transitions.
std::optional<Layout> layout(Index inner, int transitions) {
  double const ring = 0.4; // mean thickness
  double count = 4.0 * inner * std::pow(3.0, transitions);
  Layout result{inner, {}};
  double depth = 0;
  int left = transitions, same = 0;
  while (result.rows.empty() || depth < ring - std::numbers::pi * (1 - depth) / count / 2) {
    bool const transition = left > 0 && same == rows_per_level;
    double const size = std::numbers::pi * (1 - depth) / count;
    result.rows.push_back({transition ? 2 * size : size, transition});
    depth += result.rows.back().thickness;
    same = transition ? 0 : same + 1;
    left -= transition ? 1 : 0;
    count /= transition ? 3.0 : 1.0;
  }
  if (left > 0 || depth > 1.3 * ring)
    return std::nullopt;
  for (auto& row : result.rows)
    row.thickness /= depth;
  return result;
}

/// As many transitions as `grading` allows and the ring has room for; `size` is over the radius.
Layout choose_layout(double size, double grading) {
  double const along_octant = std::numbers::pi / (4 * size);
  auto const inner = [&](int transitions) {
    return static_cast<Index>(std::ceil(along_octant / std::pow(3.0, transitions) - 1e-9));
  };
  int transitions = static_cast<int>(std::floor(std::log(grading / inner_ratio) / std::log(3.0)));
  for (; transitions >= 0; --transitions)
    if (auto const found = layout(inner(transitions), transitions))
      return *found;
  return {inner(0), {{1.0, false}}}; // one row, thicker than wide
}

Indices add_ring(Quads& quads, double t, Index count) {
  Indices ring;
  for (Index i = 0; i <= count; ++i) {
    auto const [x, y] = ring_point(t, i, count);
    ring.push_back(quads.add(x, y));
  }
  return ring;
}

/// A row of equal counts outside and inside.
void add_row(Quads& quads, Indices const& outer, Indices const& inner) {
  for (std::size_t i = 0; i + 1 < inner.size(); ++i)
    quads.cells.push_back({inner[i], outer[i], outer[i + 1], inner[i + 1]});
}

/// A row where three outer cells meet one inner cell, by four cells; `t` is its middle.
void add_transition(Quads& quads, Indices const& outer, Indices const& inner, double t) {
  auto const count = static_cast<Index>(outer.size()) - 1;
  for (std::size_t i = 0; i + 1 < inner.size(); ++i) {
    Index const* o = &outer[3 * i];
    auto const position = [&](int k) { return ring_point(t, static_cast<Index>(3 * i) + k, count); };
    auto const a = position(1), b = position(2);
    Index const first = quads.add(a[0], a[1]), second = quads.add(b[0], b[1]);
    quads.cells.push_back({inner[i], o[0], o[1], first});
    quads.cells.push_back({first, o[1], o[2], second});
    quads.cells.push_back({second, o[2], o[3], inner[i + 1]});
    quads.cells.push_back({inner[i], first, second, inner[i + 1]});
  }
}

/// The bulged half square, 2 n x n cells, whose outline nodes `ring` exist already.
void add_inner(Quads& quads, Indices const& ring, Index n) {
  auto const node = [&](Index i, Index j) -> Index {
    Index const at = i == 2 * n ? j : j == n ? 3 * n - i : i == 0 ? 4 * n - j : -1;
    if (at >= 0)
      return ring[static_cast<std::size_t>(at)];
    double const u = static_cast<double>(i - n) / n, v = static_cast<double>(j) / n;
    return quads.add(half_square * u * (1 + bulge * (1 - v * v)),
                     half_square * v * (1 + bulge * (1 - u * u)));
  };
  std::vector<Indices> grid;
  for (Index j = 0; j <= n; ++j) {
    grid.emplace_back();
    for (Index i = 0; i <= 2 * n; ++i)
      grid.back().push_back(node(i, j));
  }
  for (std::size_t j = 0; j + 1 < grid.size(); ++j)
    for (std::size_t i = 0; i + 1 < grid[j].size(); ++i)
      quads.cells.push_back({grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]});
}

/// The half disc of radius 1 about the origin.
Quads unit_half_disc(Layout const& plan) {
  Index count = 4 * plan.inner;
  for (auto const& row : plan.rows)
    count *= row.transition ? 3 : 1;
  Quads quads;
  Indices outer = add_ring(quads, 1.0, count);
  double t = 1.0;
  for (auto const& row : plan.rows) {
    bool const last = &row == &plan.rows.back();
    double const next = last ? 0.0 : t - row.thickness;
    count /= row.transition ? 3 : 1;
    Indices const inner = add_ring(quads, next, count);
    if (row.transition)
      add_transition(quads, outer, inner, (t + next) / 2);
    else
      add_row(quads, outer, inner);
    outer = inner;
    t = next;
  }
  add_inner(quads, outer, plan.inner);
  return quads;
}

} // namespace

core::Schema const& HalfDiscOptions::schema() {
  using core::Need;
  using Options = HalfDiscOptions;
  static auto const result =
      core::Describe<Options>("half_disc", "upper half of a disc, flat side down; sets flat, arc, all")
          .numbers("centre", &Options::centre, "m", Need::optional, "middle of the flat side {x, y}")
          .number("radius", &Options::radius, "m", core::positive, Need::required, "radius")
          .number("size", &Options::size, "m", core::positive, Need::required,
                  "cell size along the arc; a node lies at the crown")
          .number("grading", &Options::grading, "1", {1, 9}, Need::optional,
                  "interior cells are at most this many times larger than the arc's; from 1.92 and 5.76 on "
                  "one and two 3 to 1 transitions")
          .choice("kind", &Options::kind, cell_choices(2), Need::optional, "kind of cells")
          .build();
  return result;
}

Mesh half_disc(HalfDiscOptions const& options) {
  check(options);
  double const radius = options.radius, x0 = options.centre[0], y0 = options.centre[1];
  Quads quads = unit_half_disc(choose_layout(options.size / radius, options.grading));
  for (auto& [x, y] : quads.nodes) {
    x = x0 + radius * x;
    y = y0 + radius * y;
  }
  Eigen::RowVector2d const centre(x0, y0);
  auto const on_arc = [&](auto const& p) { return std::abs((p - centre).norm() - radius) < 1e-9 * radius; };
  Mesh mesh = to_mesh(quads, options.kind, [&](auto const& a, auto const& b) -> Eigen::RowVector2d {
    Eigen::RowVector2d const middle = straight_middle(a, b);
    if (!on_arc(a) || !on_arc(b))
      return middle;
    return centre + (middle - centre).normalized() * radius;
  });
  mesh.sets["arc"] = boundary_where(mesh, on_arc);
  mesh.sets["flat"] = boundary_where(mesh, [&](auto const& p) { return p[1] == y0; });
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

} // namespace stiction::mesh
