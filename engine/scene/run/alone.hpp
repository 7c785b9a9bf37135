// What a scene's own work costs with nothing around it: the limit that a run is held to.
#pragma once
#include <map>
#include <string>

#include "dynamics/step/stepper.hpp"
#include "halfspace/surface.hpp"

namespace stiction::scene {

/// Processor time of one product with the surface's compliance and of one solution that nearly undoes it, s.
/// Keys: product, preconditioning.
[[nodiscard]] std::map<std::string, double> alone(halfspace::Surface const& surface);

/// Processor time of one pass for forces, one for the effective stiffness, one factorization and one solution
/// in this state, s, each by itself: the least of several. Keys: force_pass, stiffness_pass, factorization,
/// solve. The factor at hand is made anew.
[[nodiscard]] std::map<std::string, double> alone(dynamics::Stepper& stepper, dynamics::Model const& model,
                                                  dynamics::State const& state, double dt);

} // namespace stiction::scene
