// Scenes that a closed formula answers.
#pragma once
#include "scene/half_spaces.hpp"

namespace stiction::test {

/// The sphere of half_space_scene or the cylinder of half_line_scene, this under 20 N/m, without what their
/// formulas do not give.
inline Input formula_scene(bool line = false) {
  Input table = line ? half_line_scene() : half_space_scene();
  at(table, "model") = text("formula");
  remove(table, "obstacles.ball.x");
  if (!line)
    return table;
  remove(table, "probes.energy");
  remove(table, "obstacles.ball.y");
  at(table, "obstacles.ball.force") = values({0, 20, 20}, "N");
  return table;
}

/// A wave of a periodic line, pressed by a fifth of what makes all of it touch.
inline Input wave_scene() {
  Input table = formula_scene(true);
  at(table, "bodies.base.boundary") = text("periodic");
  at(table, "bodies.base.size") = values({0.4}, "m");
  at(table, "obstacles.ball.surface") =
      make("surface.wave", {{"amplitude", value(1e-3, "m")}, {"wavelengths", values({0.2}, "m")}});
  at(table, "probes.energy") = make("probe.energy");
  return table;
}

/// Reversible, Pa and m.
inline Input dugdale(double sigma0, double h0) {
  return make("adhesion.dugdale", {{"sigma0", value(sigma0, "Pa")}, {"h0", value(h0, "m")}});
}

} // namespace stiction::test
