// What holds the bodies: nodes on the axis of revolution, and rigid motions that nothing resists.
#include <Eigen/SVD>
#include <fmt/format.h>
#include <set>

#include "scene/builder.hpp"

namespace stiction::scene {

namespace {

/// Rigid motions of a body, [components, motions] at the place X relative to its middle, in parts of its
/// size.
Dense rigid_motions(solid::Kinematics kinematics, Vec3 const& X) {
  if (kinematics == solid::Kinematics::axisymmetric) {
    Dense along(2, 1);
    along << 0, 1;
    return along;
  }
  if (kinematics == solid::Kinematics::plane_strain) {
    Dense plane(2, 3);
    plane << 1, 0, -X.y(), 0, 1, X.x();
    return plane;
  }
  Dense space(3, 6);
  space << 1, 0, 0, 0, X.z(), -X.y(), 0, 1, 0, -X.z(), 0, X.x(), 0, 0, 1, X.y(), -X.x(), 0;
  return space;
}

std::vector<char const*> motion_names(solid::Kinematics kinematics) {
  if (kinematics == solid::Kinematics::axisymmetric)
    return {"move along y"};
  if (kinematics == solid::Kinematics::plane_strain)
    return {"move along x", "move along y", "turn"};
  return {"move along x", "move along y", "move along z", "turn about x", "turn about y", "turn about z"};
}

} // namespace

/// Nodes on the axis of revolution cannot leave it: their radial component is held without being asked for.
void Builder::hold_axis() {
  auto& model = *scene_.model;
  if (model.kinematics != solid::Kinematics::axisymmetric)
    return;
  std::set<Index> driven;
  for (auto const& motion : model.motions)
    if (motion.component == 0)
      driven.insert(motion.nodes.begin(), motion.nodes.end());
  dynamics::Motion axis;
  for (Index node = 0; node < model.first_node.back(); ++node)
    if (model.reference(node, 0) == 0 && !driven.contains(node))
      axis.nodes.push_back(node);
  if (!axis.nodes.empty())
    model.motions.push_back(axis);
}

/// Without inertia every rigid motion needs something that holds it; contact is not counted on.
void Builder::check_supports() {
  auto const& model = *scene_.model;
  if (dynamics::weights(model.scheme).inertia || !complaints_.empty())
    return; // a set that was not understood may be what holds the body
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (auto const loose = loose_motions(b); !loose.empty())
      complain(
          {"bodies", scene_.bodies[b]},
          fmt::format("can {}: no motion holds it, and in a quasi-static run contact alone cannot; fix or "
                      "drive a set of it (at a plane of symmetry the component across it), or give it "
                      "inertia with scheme.theta_xi",
                      fmt::join(loose, ", ")));
}

std::vector<std::string> Builder::loose_motions(std::size_t body) const {
  auto const& model = *scene_.model;
  Index const first = model.first_node[body], last = model.first_node[body + 1];
  Vec3 middle = Vec3::Zero(), extent = Vec3::Zero();
  for (int c = 0; c < model.dim(); ++c) {
    auto const column = model.reference.col(c).segment(first, last - first);
    middle[c] = 0.5 * (column.minCoeff() + column.maxCoeff());
    extent[c] = column.maxCoeff() - column.minCoeff();
  }
  auto const names = motion_names(model.kinematics);
  auto const count = static_cast<Eigen::Index>(names.size());
  Dense held = Dense::Zero(count, count); // sum over driven components of (motion)(motion)^T
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes) {
      if (node < first || node >= last)
        continue;
      Vec3 X = -middle;
      for (int c = 0; c < model.dim(); ++c)
        X[c] += model.reference(node, c);
      Eigen::RowVectorXd const row = rigid_motions(model.kinematics, X / extent.norm()).row(motion.component);
      held += row.transpose() * row;
    }
  Eigen::JacobiSVD<Dense> const svd(held, Eigen::ComputeFullV);
  std::vector<std::string> loose;
  for (Eigen::Index k = 0; k < count; ++k)
    if (svd.singularValues()[k] <= 1e-12 * std::max(1.0, svd.singularValues()[0])) {
      Eigen::Index strongest = 0;
      svd.matrixV().col(k).cwiseAbs().maxCoeff(&strongest);
      loose.emplace_back(names[static_cast<std::size_t>(strongest)]);
    }
  return loose;
}

} // namespace stiction::scene
