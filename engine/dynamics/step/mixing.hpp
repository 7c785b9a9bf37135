// Anderson's mixing of Newton iterations that share a factor (Walker and Ni 2011).
#pragma once
#include "core/types.hpp"

namespace stiction::dynamics {

/// While one factor serves, an iteration is nearly the same linear map again and again: the combination of
/// the last ones whose imbalances cancel best ends nearer to where they lead than the last one.
class Mixing {
public:
  /// The next iteration is another map.
  void forget();
  /// correction[n] and forces[any] that follow an imbalance[n] become those of the combination. Other numbers
  /// of them than before are another map.
  void mix(Vector const& imbalance, Vector& correction, Vector& forces);

private:
  static constexpr Eigen::Index memory = 4;
  Dense imbalances_, ends_, forces_; ///< differences between successive iterations, [n or any, memory]
  Vector last_imbalance_, last_correction_, last_step_, last_forces_;
  Eigen::Index kept_ = 0, next_ = 0;
};

} // namespace stiction::dynamics
