// What a run took in counted operations: a cost that repeats on every machine.
#pragma once
#include <map>
#include <string>

#include "dynamics/step/stepper.hpp"

namespace stiction::scene {

/// Floating-point operations of forces, stiffness, factorizations, solves and contact, from counts and sizes;
/// leading terms only. To compare runs by, not to predict seconds.
[[nodiscard]] double operations(dynamics::Model const& model, dynamics::Stepper const& stepper);
/// That, and how often what was done, by the names that the manifest has.
[[nodiscard]] std::map<std::string, double> counters_of(dynamics::Model const& model,
                                                        dynamics::Stepper const& stepper);

} // namespace stiction::scene
