// Small scenes that several tests start from.
#pragma once
#include "scene/build/build.hpp"
#include "scene/tables.hpp"

namespace stiction::test {

struct Rectangle {
  std::vector<double> origin{0, 0}, size{1, 1}; ///< m
  std::vector<double> cells{4, 4};
};

inline Input linear_elastic(double young, double poisson) {
  return make("material.linear_elastic", {{"young", value(young, "Pa")}, {"poisson", value(poisson)}});
}
inline Input block(Rectangle const& shape, Input material, double density = 1) {
  auto mesh = make("mesh.block", {{"origin", values(shape.origin, "m")},
                                  {"size", values(shape.size, "m")},
                                  {"cells", values(shape.cells)}});
  return make(
      "body",
      {{"mesh", std::move(mesh)}, {"material", std::move(material)}, {"density", value(density, "kg/m^3")}});
}
inline Input half_disc(double radius, double size, Input material) {
  auto mesh = make(
      "mesh.half_disc",
      {{"radius", value(radius, "m")}, {"size", value(size, "m")}, {"centre", values({0, -radius}, "m")}});
  return make(
      "body",
      {{"mesh", std::move(mesh)}, {"material", std::move(material)}, {"density", value(1, "kg/m^3")}});
}
/// The half-plane below y = 0.
inline Input floor() {
  return make("obstacle", {{"shape", make("rigid.plane")}});
}
inline Input pair(std::string secondary, std::string primary) {
  return make("pair", {{"secondary", text(std::move(secondary))}, {"primary", text(std::move(primary))}});
}
inline Input coulomb(double mu) {
  return make("friction.coulomb", {{"mu", value(mu)}});
}
inline Input rcc(double w, double C, double b) {
  return make("adhesion.rcc", {{"w", value(w, "J/m^2")},
                               {"C_n", value(C, "N/m^3")},
                               {"C_t", value(C, "N/m^3")},
                               {"b", value(b, "N s/m")}});
}
inline Input roller(std::string set, std::vector<double> const& normal) {
  return make("constraint.roller", {{"set", text(std::move(set))}, {"normal", values(normal)}});
}
inline Input periodic(std::string set, std::string to) {
  return make("constraint.periodic", {{"set", text(std::move(set))}, {"to", text(std::move(to))}});
}
inline Input tied(std::string set, std::string to) {
  return make("constraint.tied", {{"set", text(std::move(set))}, {"to", text(std::move(to))}});
}
/// With both, all components of the set, in space too.
inline Input fix(std::string set, bool x = true, bool y = true) {
  if (x && y)
    return make("motion.fix", {{"set", text(std::move(set))}});
  return make("motion.fix", {{"set", text(std::move(set))}, {"x", flag(x)}, {"y", flag(y)}});
}
/// Displacements at times; an empty list leaves its component free.
inline Input drive(std::string set, std::vector<double> const& times, std::vector<double> const& x,
                   std::vector<double> const& y) {
  auto motion = make("motion.drive", {{"set", text(std::move(set))}, {"times", values(times, "s")}});
  if (!x.empty())
    at(motion, "x") = values(x, "m");
  if (!y.empty())
    at(motion, "y") = values(y, "m");
  return motion;
}
/// Stages that end at these times, with so many equal steps each.
inline Input schedule(std::vector<std::pair<double, int>> const& stages) {
  core::List all;
  for (auto const& [end, steps] : stages)
    all.push_back(make("stage", {{"to", value(end, "s")}, {"steps", value(steps)}}));
  return make("schedule", {{"stages", list(std::move(all))}});
}
inline Input quasi_static() {
  return make("scheme.quasi_static");
}

/// A block "foot" on the floor, pair "sole"; E = 1000 Pa, nu = 0, 1 m by 1 m, quasi-static. Its top sinks by
/// 0.01 m in the first second and goes 0.1 m sideways in the next.
inline Input foot_on_floor() {
  auto scene = make("scene");
  at(scene, "bodies.foot") = block({}, linear_elastic(1000, 0));
  at(scene, "obstacles.floor") = floor();
  at(scene, "pairs.sole") = pair("foot.bottom", "floor");
  at(scene, "motions") = list({drive("foot.top", {0, 1, 2}, {0, 0, 0.1}, {0, -0.01, -0.01})});
  at(scene, "scheme") = quasi_static();
  at(scene, "schedule") = schedule({{1, 4}, {2, 10}});
  return scene;
}

/// Two blocks one above the other, pair "joint" between "upper.bottom" and "lower.top"; else as
/// foot_on_floor, with the lower block standing fixed.
inline Input two_blocks() {
  auto scene = make("scene");
  at(scene, "bodies.lower") = block({{0, -1}, {1, 1}, {4, 4}}, linear_elastic(1000, 0));
  at(scene, "bodies.upper") = block({}, linear_elastic(1000, 0));
  at(scene, "pairs.joint") = pair("upper.bottom", "lower.top");
  at(scene, "motions") =
      list({fix("lower.bottom"), drive("upper.top", {0, 1, 2}, {0, 0, 0.1}, {0, -0.01, -0.01})});
  at(scene, "scheme") = quasi_static();
  at(scene, "schedule") = schedule({{1, 4}, {2, 10}});
  return scene;
}

} // namespace stiction::test
