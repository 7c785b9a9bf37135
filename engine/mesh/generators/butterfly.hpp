// Round regions without a degenerate middle: a bulged square or cube inside, layers of cells around it.
#pragma once
#include "mesh/generators/hexes.hpp"

namespace stiction::mesh {

/// One layer's outer side: blended from the inner square (t = 0) to the circle of this radius (t = 1).
struct Ring {
  double t;
  double radius; ///< m
};

/// Half the width of the inner square, and of the inner cube, over the radius of the first circle or sphere.
inline constexpr double square_width = 0.5;
inline constexpr double cube_width = 0.42;
/// How far the sides lie from the centre along an axis, over that radius.
[[nodiscard]] double square_reach();
[[nodiscard]] double cube_reach();

/// A round body with a fine zone at its pole.
struct Round {
  double radius;      ///< m
  double fine_length; ///< along the surface from the pole, m
  double fine_depth;  ///< m
  double reach;       ///< square_reach() or cube_reach()
};
/// Its lines: shares of the eighth turn from the pole, and from the equator; layers from the inside outwards.
struct RoundLines {
  Lines polar, equator;
  std::vector<Ring> rings;
};
[[nodiscard]] RoundLines round_lines(Round const& round, Grading const& grading);

/// The quarter x, y >= 0 of a disc about the origin. Lines are shares from 0 to 1 of the eighth turn on the
/// outer circle: along x from the y axis to the diagonal, along y from the x axis to the diagonal. Nodes on
/// the axes have an exact zero.
[[nodiscard]] Quads quarter_disc_net(Lines const& x, Lines const& y, std::vector<Ring> const& rings);

/// The eighth x, y, z >= 0 of a ball; lines as above, along the great circles in x = 0 and y = 0.
[[nodiscard]] Hexes eighth_ball_net(std::array<Lines, 3> const& lines, std::vector<Ring> const& rings);

} // namespace stiction::mesh
