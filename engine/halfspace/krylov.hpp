// Systems of linearised contact by products with W and what nearly undoes it.
#pragma once
#include <optional>

#include "halfspace/linearised.hpp"

namespace stiction::halfspace {

/// A correction: changes of force at the points that count, of the lift, and what W makes of them.
struct Correction {
  Vector force;    ///< [D points], N
  Vector motion;   ///< W force, of all points, m
  double lift = 0; ///< m
  long iterations = 0;
};

/// Solves until the residual is `part` of the right side, or for `most` iterations.
template<int D> class Krylov {
public:
  /// held_lift: stiffness that holds the lift, N/m.
  Krylov(Surface const& surface, Linearised<D> const& system, bool lifted, double held_lift = 0);
  /// right[D points], as `Linearised` has it, N; total: of the changes of normal forces, N, if lifted.
  [[nodiscard]] Correction solve(Vector const& right, double total, double part, long most);

private:
  [[nodiscard]] Correction by_conjugate_gradients(Vector const& right, double total, double part, long most);
  [[nodiscard]] Correction by_residuals(Vector const& right, double total, double part, long most);
  void prepare_lift();
  /// W few, all of it, into `moved_`.
  void move(Vector const& few);
  void apply(Vector const& few, double lift, Vector& result);
  /// Nearly undoes `apply` without the lift.
  void undo(Vector const& few, Vector& result);
  void undo_symmetric(Vector const& few, Vector& result);
  void masked_solve(Vector const& few, Vector& result);
  [[nodiscard]] int basis() const;
  [[nodiscard]] double normal_sum(Vector const& few) const;

  Surface const* surface_;
  Linearised<D> const* system_;
  bool lifted_;
  double held_lift_;
  Vector all_, moved_; ///< of all points
  Vector some_;        ///< of those that count
  Vector lift_force_;  ///< undone: what a lift of one asks for
  double lift_sum_ = 0;
};

} // namespace stiction::halfspace
