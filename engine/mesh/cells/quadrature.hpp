// Quadrature rules on the reference cells.
#pragma once
#include "core/types.hpp"

namespace stiction::mesh {

struct Rule {
  Matrix points;  ///< [points, dim], reference coordinates
  Vector weights; ///< [points], sum to the reference cell's measure
};

/// Gauss rule with n = 2, 3 or 4 points a direction on [-1, 1]^dim, exact to degree 2 n - 1 in each
/// direction.
[[nodiscard]] Rule cube_rule(int dim, int n);

/// Gauss rule with any number of points on [-1, 1], from the eigenvectors of Legendre's recurrence (Golub and
/// Welsch 1969).
[[nodiscard]] Rule line_rule(int n);

/// Exact to degrees 1, 2 and 4 (Dunavant, Int. J. Numer. Meth. Engng 21, 1985).
[[nodiscard]] Rule triangle_1();
[[nodiscard]] Rule triangle_3();
[[nodiscard]] Rule triangle_6();

/// Exact to degrees 1, 2 and 5 (Keast, Comp. Meth. Appl. Mech. Engng 55, 1986), all weights positive.
[[nodiscard]] Rule tetrahedron_1();
[[nodiscard]] Rule tetrahedron_4();
[[nodiscard]] Rule tetrahedron_14();

} // namespace stiction::mesh
