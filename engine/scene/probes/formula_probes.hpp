// Probes of a closed formula as columns of a series: those of half spaces that it gives.
#pragma once
#include "scene/probes/probes.hpp"

namespace stiction::scene {

/// What a formula says at one moment.
struct FormulaState {
  double t = 0;                  ///< s
  formula::State normal;         ///< depth, force that presses, area, peak
  std::array<double, 2> way{};   ///< of the counterpart along x and y, m
  std::array<double, 2> along{}; ///< force on the half space along x and y, N
  double size = 0;               ///< of the state, as the formula counts it
  double work = 0;               ///< of what presses since the start, J (a line: J/m)
  double start = 0;              ///< energy at the start, J (a line: J/m)
};

/// Appends the probe's values of one state to a row.
using FormulaSampler = std::function<void(FormulaState const&, std::vector<double>&)>;

/// Adds the columns of every probe of a scene with a formula, in the order of their names, and returns their
/// samplers.
[[nodiscard]] std::vector<FormulaSampler> add_formula_probes(Scene const& scene, Columns const& columns);

} // namespace stiction::scene
