// The nets of quarter disc and eighth ball: lattice, outline, layers.
#include "mesh/generators/butterfly.hpp"

#include <cmath>
#include <map>
#include <numbers>

namespace stiction::mesh {

namespace {

constexpr double square_bulge = 0.1; // of the square's sides: corners of about 112 degrees instead of 90
constexpr double cube_bulge = 0.25;  // share of a ball in the cube's shape

/// The line at share s of the eighth turn as a coordinate in [0, 1].
double coordinate(double s) {
  return s == 0 ? 0 : s == 1 ? 1 : std::tan(s * std::numbers::pi / 4);
}

Position<2> bulged(Position<2> const& p) {
  return {p[0] * (1 + square_bulge * (1 - p[1] * p[1])), p[1] * (1 + square_bulge * (1 - p[0] * p[0]))};
}

/// Between the cube and the ball through its corners; the cube's map to the ball keeps planes x = 0.
Position<3> bulged(Position<3> const& p) {
  Position<3> const q = p.cwiseAbs2();
  Position<3> ball;
  for (int i = 0; i < 3; ++i) {
    double const a = q[(i + 1) % 3], b = q[(i + 2) % 3];
    ball[i] = p[i] * std::sqrt(3 * (1 - a / 2 - b / 2 + a * b / 3));
  }
  return (1 - cube_bulge) * p + cube_bulge * ball;
}

/// Where the outline point p of the unit square or cube comes to lie in a layer.
template<int dim> Position<dim> in_ring(Position<dim> const& p, Ring const& ring, double width) {
  return (1 - ring.t) * width * bulged(p) + ring.t * ring.radius * p.normalized();
}

using Lattice = std::array<Index, 3>;

/// The nodes of one closed shell of the eighth ball, by their indices in the lattice.
using Shell = std::map<Lattice, Index>;

/// Makes the net from a lattice of lines.
class EighthBall {
public:
  explicit EighthBall(std::array<Lines, 3> const& lines) {
    for (std::size_t d = 0; d < 3; ++d) {
      for (double const s : lines[d])
        lines_[d].push_back(coordinate(s));
      last_[d] = static_cast<Index>(lines[d].size()) - 1;
    }
  }

  Hexes make(std::vector<Ring> const& rings) {
    double const width = cube_width * rings.front().radius;
    Shell shell = add_cube(width);
    for (auto const& ring : rings) {
      Shell next;
      for (auto const& [at, inner] : shell)
        next[at] = hexes_.add(in_ring<3>(position(at), ring, width));
      add_layer(shell, next);
      shell = std::move(next);
    }
    return std::move(hexes_);
  }

private:
  [[nodiscard]] Position<3> position(Lattice const& at) const {
    return {lines_[0][ix(at[0])], lines_[1][ix(at[1])], lines_[2][ix(at[2])]};
  }
  /// The inner cube; returns its outer sides.
  Shell add_cube(double width) {
    Shell all, outside;
    for (Index k = 0; k <= last_[2]; ++k)
      for (Index j = 0; j <= last_[1]; ++j)
        for (Index i = 0; i <= last_[0]; ++i) {
          Lattice const at{i, j, k};
          all[at] = hexes_.add(width * bulged(position(at)));
          if (i == last_[0] || j == last_[1] || k == last_[2])
            outside[at] = all[at];
        }
    for (Index k = 0; k < last_[2]; ++k)
      for (Index j = 0; j < last_[1]; ++j)
        for (Index i = 0; i < last_[0]; ++i)
          hexes_.cells.push_back({all[{i, j, k}], all[{i + 1, j, k}], all[{i + 1, j + 1, k}],
                                  all[{i, j + 1, k}], all[{i, j, k + 1}], all[{i + 1, j, k + 1}],
                                  all[{i + 1, j + 1, k + 1}], all[{i, j + 1, k + 1}]});
    return outside;
  }
  /// Cells between two shells, over the three outer sides of the lattice.
  void add_layer(Shell const& inner, Shell const& outer) {
    for (std::size_t normal = 0; normal < 3; ++normal) {
      std::size_t const u = (normal + 1) % 3, v = (normal + 2) % 3;
      Lattice at{};
      at[normal] = last_[normal];
      for (at[u] = 0; at[u] < last_[u]; ++at[u])
        for (at[v] = 0; at[v] < last_[v]; ++at[v])
          add_cell(inner, outer, at, {u, v});
    }
  }
  void add_cell(Shell const& inner, Shell const& outer, Lattice const& at, std::array<std::size_t, 2> uv) {
    constexpr std::array<std::array<Index, 2>, 4> steps{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    std::array<Index, 8> cell{};
    for (std::size_t i = 0; i < 4; ++i) {
      Lattice corner = at;
      corner[uv[0]] += steps[i][0];
      corner[uv[1]] += steps[i][1];
      cell[i] = inner.at(corner);
      cell[i + 4] = outer.at(corner);
    }
    hexes_.cells.push_back(cell);
  }

  std::array<Lines, 3> lines_; ///< coordinates in [0, 1]
  Lattice last_{};
  Hexes hexes_;
};

} // namespace

double square_reach() {
  return square_width * bulged(Position<2>(1, 0))[0];
}

double cube_reach() {
  return cube_width * bulged(Position<3>(1, 0, 0))[0];
}

Hexes eighth_ball_net(std::array<Lines, 3> const& lines, std::vector<Ring> const& rings) {
  return EighthBall(lines).make(rings);
}

RoundLines round_lines(Round const& round, Grading const& grading) {
  double const eighth = std::numbers::pi / 4 * round.radius;
  RoundLines lines{graded_lines(eighth, round.fine_length, grading), {}, {}};
  double const last = lines.polar.back() - lines.polar[lines.polar.size() - 2];
  Grading onwards = grading;
  onwards.fine_size = last;
  Lines const rest = graded_lines(eighth, 0, onwards); // from the diagonal to the equator
  for (double& s : lines.polar)
    s = s == eighth ? 1 : s / eighth;
  for (auto s = rest.rbegin(); s != rest.rend(); ++s)
    lines.equator.push_back(*s == eighth ? 0 : 1 - *s / eighth);
  double const thickness = (1 - round.reach) * round.radius;
  Lines const depths = graded_lines(thickness, round.fine_depth, grading);
  for (auto depth = std::next(depths.rbegin()); depth != depths.rend(); ++depth)
    lines.rings.push_back({1 - *depth / thickness, round.radius});
  return lines;
}

Quads quarter_disc_net(Lines const& x, Lines const& y, std::vector<Ring> const& rings) {
  double const width = square_width * rings.front().radius;
  auto const nx = static_cast<Index>(x.size()) - 1, ny = static_cast<Index>(y.size()) - 1;
  auto const position = [&](Index i, Index j) {
    return Position<2>(coordinate(x[ix(i)]), coordinate(y[ix(j)]));
  };
  Quads quads;
  auto const add = [&](Position<2> const& p) { return quads.add(p[0], p[1]); };
  for (Index j = 0; j <= ny; ++j)
    for (Index i = 0; i <= nx; ++i)
      add(width * bulged(position(i, j)));
  for (Index j = 0; j < ny; ++j)
    for (Index i = 0; i < nx; ++i) {
      Index const a = i + j * (nx + 1), b = a + nx + 1;
      quads.cells.push_back({a, a + 1, b + 1, b});
    }
  std::vector<std::array<Index, 2>> outline; // up the right side, then back along the top
  for (Index j = 0; j <= ny; ++j)
    outline.push_back({nx, j});
  for (Index i = nx - 1; i >= 0; --i)
    outline.push_back({i, ny});
  Indices inner, outer;
  for (auto const& [i, j] : outline)
    inner.push_back(i + j * (nx + 1));
  for (auto const& ring : rings) {
    outer.clear();
    for (auto const& [i, j] : outline)
      outer.push_back(add(in_ring<2>(position(i, j), ring, width)));
    for (std::size_t s = 0; s + 1 < outline.size(); ++s)
      quads.cells.push_back({inner[s], outer[s], outer[s + 1], inner[s + 1]});
    inner = outer;
  }
  return quads;
}

} // namespace stiction::mesh
