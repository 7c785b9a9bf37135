// A bulk in space whose loads are solved for by conjugate gradients with multigrid: no factor, no columns.
#pragma once
#include "linear/bulk_factor.hpp"

namespace stiction::linear {

/// Where the unknowns of a pattern belong.
struct NodesOfUnknowns {
  Indices place; ///< [unknowns], 3 node + component
  Dense modes;   ///< [3 nodes, 6], motions that take no energy where nothing is held
};

/// Passes over the matrix that a cycle and the product with it take, coarser levels included.
inline constexpr double cycle_passes = 4.2;
/// Relative residual to which a load is solved for, in at most so many iterations.
inline constexpr double solved_to = 1e-12;
inline constexpr int most_for_load = 400;
/// Vectors of GMRES for loads and constraints together.
inline constexpr int most_coupled = 60;
/// What a matrix of so many numbers, both triangles, will take.
[[nodiscard]] Effort multigrid_effort(double numbers);

/// The matrix alone takes memory as its entries do. Loads are solved for to a relative residual of
/// `solved_to`; where they cannot be, as of a matrix that is not positive definite, what comes back is not
/// finite.
[[nodiscard]] std::unique_ptr<BulkFactor> make_multigrid_factor(Pattern pattern, Index surface,
                                                                NodesOfUnknowns nodes);

} // namespace stiction::linear
