// Scenes of a half space under a height map.
#pragma once
#include "scene/scenes.hpp"

namespace stiction::test {

/// A sphere of radius 1 m, down by 5 mm in two stages and along by 2 mm in the second; 16 x 12 points.
inline Input half_space_scene() {
  Input table = make("scene");
  at(table, "kinematics") = text("three_dimensional");
  at(table, "bodies.base") = make("body.half_space", {{"young", value(1e4, "Pa")},
                                                      {"poisson", value(0.3)},
                                                      {"size", values({0.4, 0.3}, "m")},
                                                      {"points", values({16, 12})},
                                                      {"boundary", text("free")}});
  at(table, "obstacles.ball") =
      make("obstacle.height_map", {{"surface", make("surface.sphere", {{"radius", value(1, "m")}})},
                                   {"times", values({0, 1, 2}, "s")},
                                   {"x", values({0, 0, 2e-3}, "m")},
                                   {"z", values({0, -5e-3, -5e-3}, "m")}});
  at(table, "pairs.joint") = pair("base.surface", "ball");
  at(table, "scheme") = make("scheme.quasi_static");
  at(table, "schedule") = schedule({{1, 3}, {2, 4}});
  at(table, "output") = make("output", {{"frames", value(2)}});
  at(table, "probes.joint") = make("probe.contact", {{"pair", text("joint")}});
  at(table, "probes.ball") = make("probe.rigid", {{"obstacle", text("ball")}});
  at(table, "probes.energy") = make("probe.energy");
  at(table, "probes.middle") =
      make("probe.contact_point", {{"pair", text("joint")}, {"near", values({0, 0, 0}, "m")}});
  return table;
}

/// The same of a cylinder and 24 points on a line in plane strain.
inline Input half_line_scene() {
  Input table = half_space_scene();
  at(table, "kinematics") = text("plane_strain");
  at(table, "bodies.base.size") = values({0.4}, "m");
  at(table, "bodies.base.points") = values({24});
  at(table, "obstacles.ball.surface") = make("surface.cylinder", {{"radius", value(1, "m")}});
  at(table, "obstacles.ball.y") = at(table, "obstacles.ball.z");
  remove(table, "obstacles.ball.z");
  at(table, "probes.middle.near") = values({0, 0}, "m");
  at(table, "probes.line") = make("probe.contact_line", {{"pair", text("joint")}});
  return table;
}

} // namespace stiction::test
