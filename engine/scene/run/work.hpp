// What a run took in counted operations: a cost that repeats on every machine.
#pragma once
#include "dynamics/step/stepper.hpp"

namespace stiction::scene {

/// Floating-point operations of forces, stiffness, factorizations, solves and contact, from counts and sizes;
/// leading terms only. To compare runs by, not to predict seconds.
[[nodiscard]] double operations(dynamics::Model const& model, dynamics::Stepper const& stepper);

} // namespace stiction::scene
