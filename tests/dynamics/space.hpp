// Small scenes in space, and what their states add up to.
#pragma once
#include <Eigen/Geometry>

#include "dynamics/marching.hpp"

namespace stiction::test {

using contact::Vec3;

inline std::vector<double> numbers(Vec3 const& v) {
  return {v.x(), v.y(), v.z()};
}

struct Box {
  Vec3 origin = Vec3::Zero(), size = Vec3::Ones(); ///< m
  Vec3 cells{2, 2, 2};
};
inline Input box(Box const& shape, Input material, double density = 1) {
  auto mesh = make("mesh.box", {{"origin", values(numbers(shape.origin), "m")},
                                {"size", values(numbers(shape.size), "m")},
                                {"cells", values(numbers(shape.cells))}});
  return make(
      "body",
      {{"mesh", std::move(mesh)}, {"material", std::move(material)}, {"density", value(density, "kg/m^3")}});
}
/// Displacements at times; an empty list leaves its component free.
inline Input drive(std::string set, std::vector<double> const& times,
                   std::array<std::vector<double>, 3> const& paths) {
  auto motion = make("motion.drive", {{"set", text(std::move(set))}, {"times", values(times, "s")}});
  for (std::size_t c = 0; c < 3; ++c)
    if (!paths[c].empty())
      at(motion, std::string(1, "xyz"[c])) = values(paths[c], "m");
  return motion;
}
inline Input fix_in(std::string set, std::string const& components) {
  auto motion = make("motion.fix", {{"set", text(std::move(set))}});
  for (std::string const c : {"x", "y", "z"})
    at(motion, c) = flag(components.find(c) != std::string::npos);
  return motion;
}
inline Input theta_xi(double theta, double xi) {
  return make("scheme.theta_xi", {{"theta", value(theta)}, {"xi", value(xi)}});
}
inline Input space() {
  auto scene = make("scene");
  at(scene, "kinematics") = text("three_dimensional");
  at(scene, "scheme") = quasi_static();
  at(scene, "schedule") = schedule({{2, 1}});
  return scene;
}

/// A cube "foot" of 1 m on the floor, pair "sole", E = 1000 Pa, nu = 0, quasi-static, without motions.
inline Input cube_on_floor() {
  auto scene = space();
  at(scene, "bodies.foot") = box({}, linear_elastic(1000, 0));
  at(scene, "obstacles.floor") = floor();
  at(scene, "pairs.sole") = pair("foot.bottom", "floor");
  return scene;
}
/// It is pressed and dragged with friction 0.3, in nine steps.
inline Input dragged_cube(Input material) {
  auto table = cube_on_floor();
  at(table, "bodies.foot.material") = std::move(material);
  at(table, "bodies.foot.mesh.cells") = values({3, 3, 3});
  at(table, "pairs.sole.friction") = coulomb(0.3);
  at(table, "motions") = list({drive("foot.top", {0, 1, 2}, {{{0, 0, 0.2}, {0, 0, 0.1}, {0, -0.1, -0.1}}})});
  at(table, "schedule") = schedule({{1, 4}, {2, 5}});
  return table;
}

/// Sum over nodes of a vector with dim components each, padded with 0.
inline Vec3 sum_over(scene::Scene const& scene, Vector const& v, Indices const& nodes) {
  int const dim = scene.model->dim();
  Vec3 sum = Vec3::Zero();
  for (Index const node : nodes)
    sum.head(dim) += v.segment(dim * node, dim);
  return sum;
}
/// Force of the motions on a set, N.
inline Vec3 drive_on(scene::Scene const& scene, State const& state, std::string const& set) {
  return sum_over(scene, state.drive, nodes_of(scene, set));
}
/// Force of the contact on the secondary surface of a pair, N.
inline Vec3 contact_on(scene::Scene const& scene, State const& state, std::size_t pair = 0) {
  return sum_over(scene, state.reaction, scene.model->pairs[pair].nodes());
}
/// Moment of nodal forces about the origin where the nodes are now, N m.
inline Vec3 moment(scene::Scene const& scene, State const& state, Vector const& force) {
  auto const& model = *scene.model;
  Vec3 sum = Vec3::Zero();
  for (Index i = 0; i < model.first_node.back(); ++i) {
    Vec3 const position = model.reference.row(i).transpose() + state.u.segment<3>(3 * i);
    sum += position.cross(Vec3(force.segment<3>(3 * i)));
  }
  return sum;
}

/// Mean of a nodal vector over the deformable bodies, weighted by mass.
inline Vec3 mass_mean(scene::Scene const& scene, Stepper const& stepper, Vector const& v) {
  int const dim = scene.model->dim();
  Vector ones = Vector::Zero(v.size()), weighted;
  ones.head(dim * scene.model->first_node.back()).setOnes();
  stepper.bulk().mass().times(ones, weighted);
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < ones.size(); i += dim)
    sum.head(dim) += v.segment(i, dim) * weighted[i];
  return sum * dim / weighted.sum();
}

} // namespace stiction::test
