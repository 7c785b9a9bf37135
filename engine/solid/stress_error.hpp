// How wrong the stress of a mesh is, judged by how much it jumps between cells.
#pragma once
#include "solid/cells.hpp"

namespace stiction::solid {

/// Per cell, int |s* - s_h|^2 and int |s*|^2 over its reference volume: s_h is the mean Cauchy stress of the
/// cell, s* the stress recovered at its nodes (Zienkiewicz and Zhu 1987), with
/// the norm of tensors in place of the energy's. Pa^2 m^dim
struct StressError {
  std::vector<double> error, size; ///< [cells], squared
  std::vector<double> volume;      ///< [cells], m^2 (m^3)
  /// sqrt(sum error / sum (size + error)): 0 of an exact stress.
  [[nodiscard]] double relative() const;
};

/// memory: of networks that relax, as of Cells.
[[nodiscard]] StressError stress_error(Body const& body, Kinematics kinematics, std::span<double const> u,
                                       std::span<double const> memory = {});

} // namespace stiction::solid
