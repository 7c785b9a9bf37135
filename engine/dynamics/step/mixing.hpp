// Anderson's mixing: corrections of an iteration whose matrix lacks a part of the derivative.
#pragma once
#include <vector>

#include "core/types.hpp"

namespace stiction::dynamics {

/// What the matrix lacks shows in how corrections answer to those before: of the last few the mixture is
/// taken that by this answer leaves least (Walker and Ni 2011). Few directions in which an
/// iteration leads away are those of a Krylov space, and it finds back.
class Mixing {
public:
  void clear();
  /// Instead of the correction that the matrix makes of what is unbalanced; [unknowns], m.
  void mix(Vector& correction);

private:
  static constexpr std::size_t most = 5; ///< corrections
  std::vector<Vector> made_, answers_;   ///< corrections made, and how the next by the matrix differed
  Vector last_;                          ///< by the matrix; empty: none
  Vector last_made_;
};

} // namespace stiction::dynamics
