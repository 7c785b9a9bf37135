// The longest stable step of central differences.
#pragma once
#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// 2 / omega_max at displacement u [dim nodes], s; infinite without a deformable cell that is free to move.
/// No frequency of the assembly exceeds the largest of its single cells, each with its own lumped mass and
/// its driven unknowns held (Irons, Treharne 1971), so that the answer errs to the safe side. Networks that
/// relax resist at once; null: with the memory of rest.
[[nodiscard]] double critical_step(Model const& model, Vector const& u, double t = 0,
                                   Memory const* memory = nullptr);
inline constexpr double critical_margin =
    1e-6; ///< part of the limit by which rounding may carry a step above it
/// "dt = ... is above the stability limit ...".
[[nodiscard]] std::string above_critical(double dt, double limit);

} // namespace stiction::dynamics
