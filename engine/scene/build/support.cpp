// What holds the bodies: nodes on the axis of revolution, and rigid motions that nothing resists.
#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "dynamics/contact/bond_grip.hpp"
#include "dynamics/step/stepper.hpp"
#include "linear/decompositions.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

/// Rigid motions of a body, [components, motions] at the point X relative to its middle, in parts of its
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

namespace {

constexpr double least = 1e-7; ///< of a stabilisation, and of a spring beside its body

/// The rigid motions of all bodies, one after the other, and what resists them.
class RigidMotions {
public:
  explicit RigidMotions(dynamics::Model const& model)
      : model_(&model), names_(motion_names(model.kinematics)), frames_(model.bodies.size()) {
    for (std::size_t b = 0; b < frames_.size(); ++b) {
      auto const& nodes = model.bodies[b]->mesh.nodes;
      Vector const low = nodes.colwise().minCoeff(), high = nodes.colwise().maxCoeff();
      frames_[b].middle.head(model.dim()) = 0.5 * (low + high);
      frames_[b].size = (high - low).norm();
    }
    auto const all = static_cast<Eigen::Index>(frames_.size()) * count();
    held_ = Dense::Zero(all, all);
  }

  /// A displacement component of one node is held: `weights` over the components of `nodes` is.
  void hold(Indices const& nodes, Eigen::RowVectorXd const& weights) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(held_.cols());
    int const dim = model_->dim();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      auto const found = std::ranges::upper_bound(model_->first_node, nodes[k]);
      Eigen::Index const b = found - model_->first_node.begin() - 1;
      auto const& [middle, size] = frames_[static_cast<std::size_t>(b)];
      Vec3 X = -middle;
      for (int c = 0; c < dim; ++c)
        X[c] += model_->reference(nodes[k], c);
      row.segment(b * count(), count()) += weights.segment(dim * static_cast<Eigen::Index>(k), dim) *
                                           rigid_motions(model_->kinematics, X / size);
    }
    held_ += row.transpose() * row;
  }

  void hold_motions() {
    for (auto const& motion : model_->motions)
      for (Index const node : motion.nodes)
        if (node < model_->first_node.back())
          hold({node}, Eigen::RowVectorXd::Unit(model_->dim(), motion.component));
  }

  /// What a follower does beside its masters.
  void hold_links() {
    int const dim = model_->dim();
    for (auto const& link : model_->links) {
      Indices nodes{link.dof / dim};
      std::vector<std::pair<int, double>> shares{{link.dof % dim, 1.0}};
      for (auto const& [master, weight] : link.masters) {
        nodes.push_back(master / dim);
        shares.emplace_back(master % dim, -weight);
      }
      Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(dim * static_cast<Eigen::Index>(nodes.size()));
      for (std::size_t k = 0; k < shares.size(); ++k)
        weights[dim * static_cast<Eigen::Index>(k) + shares[k].first] = shares[k].second;
      hold(nodes, weights);
    }
  }

  /// The ways of springs from end to end. What is too soft beside its body holds nothing: its points, moved
  /// by any friction, would meet their gaps loosely.
  void hold_springs() {
    for (auto const& spring : model_->springs)
      for (std::size_t k = 0; k < holding_members(spring); ++k)
        for (int c = 0; c < model_->dim(); ++c)
          if (Vec3 const way = way_of(spring, c); !way.isZero(0))
            hold_spring(spring, k, way);
  }

  /// Per body the motions that nothing resists, by the component that is most of each.
  [[nodiscard]] std::vector<std::vector<std::string>> loose() const {
    Eigen::SelfAdjointEigenSolver<Dense> const all(held_);
    auto const& values = all.eigenvalues(); // ascending
    auto const free = (values.array() <= 1e-12 * std::max(1.0, values[values.size() - 1])).count();
    std::vector<std::vector<std::string>> found(frames_.size());
    for (std::size_t b = 0; b < frames_.size(); ++b) {
      Dense const own = all.eigenvectors().block(static_cast<Eigen::Index>(b) * count(), 0, count(), free);
      Eigen::JacobiSVD<Dense> const svd(own * own.transpose(), Eigen::ComputeFullU);
      for (Eigen::Index k = 0; k < count() && svd.singularValues()[k] > 1e-12; ++k) {
        Eigen::Index strongest = 0;
        svd.matrixU().col(k).cwiseAbs().maxCoeff(&strongest);
        found[b].emplace_back(names_[static_cast<std::size_t>(strongest)]);
      }
    }
    return found;
  }

private:
  struct Frame {
    Vec3 middle = Vec3::Zero();
    double size = 0; ///< m
  };
  /// None of a spring below `least` E, times a length where forces are not per metre of depth.
  [[nodiscard]] std::size_t holding_members(dynamics::Spring const& spring) const {
    auto const found = std::ranges::upper_bound(model_->first_node, spring.from.nodes.front());
    auto const b = static_cast<std::size_t>(found - model_->first_node.begin() - 1);
    bool const plane = model_->kinematics == solid::Kinematics::plane_strain;
    double const young = material::moduli(model_->bodies[b]->material).young;
    if (spring.stiffness < least * young * (plane ? 1 : frames_[b].size))
      return 0;
    return spring.spread ? spring.from.nodes.size() : 1;
  }
  /// The c-th way along which a spring resists; one that has a direction resists along the first alone.
  static Vec3 way_of(dynamics::Spring const& spring, int c) {
    if (spring.along == dynamics::SpringAlong::axes)
      return spring.axes[c] > 0 ? Vec3(Vec3::Unit(c)) : Vec3(Vec3::Zero());
    return c == 0 ? spring.direction : Vec3(Vec3::Zero());
  }
  /// Along a way, of the mean of a set or, where the spring is spread, of its k-th node.
  void hold_spring(dynamics::Spring const& spring, std::size_t k, Vec3 const& way) {
    Indices nodes = spring.spread ? Indices{spring.from.nodes[k]} : spring.from.nodes;
    std::vector<double> shares = spring.spread ? std::vector<double>{1} : spring.from.shares;
    nodes.insert(nodes.end(), spring.to.nodes.begin(), spring.to.nodes.end());
    for (double const share : spring.to.shares)
      shares.push_back(-share);
    int const dim = model_->dim();
    Eigen::RowVectorXd weights(dim * static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
      weights.segment(dim * static_cast<Eigen::Index>(i), dim) = shares[i] * way.head(dim).transpose();
    hold(nodes, weights);
  }
  [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(names_.size()); }

  dynamics::Model const* model_;
  std::vector<char const*> names_;
  std::vector<Frame> frames_;
  Dense held_; ///< sum of (resisted)^T (resisted), [bodies motions, bodies motions]
};

/// Rows of H along which the bonds of the start resist.
void hold_bonds(dynamics::Model const& model, dynamics::ContactSystem const& contact,
                dynamics::State const& start, double dt, RigidMotions& motions) {
  contact.each_point([&](dynamics::PointId id, Indices const& nodes, Dense const& H) {
    auto const& law = model.pairs[ix(id.pair)].law;
    auto const& point = start.contacts[ix(id.pair)][ix(id.index)];
    if (nodes.empty() || !law.adhesion)
      return;
    auto const held = dynamics::bond_resistance(*law.adhesion, {point.bond, dt, point.gap <= 0}, point.gap);
    for (int c = 0; c < model.dim(); ++c)
      if (held[c] > 0)
        motions.hold(nodes, H.row(c));
  });
}

} // namespace

/// Without inertia every rigid motion needs something that resists it from the start: a motion, a spring, an
/// intact bond or the stabilisation of the scheme; contact alone is not counted on.
void Builder::check_supports(dynamics::ContactSystem const& contact, dynamics::State const& start) {
  auto& model = *scene_.model;
  auto const weights = dynamics::weights(model.scheme);
  double const asked = dynamics::weights(scene_.part.scheme).stabilisation;
  if (asked > 0 && asked < least)
    complain({"scheme", "stabilisation"},
             fmt::format("is {:g}; so little leaves a body that contact holds so compliant that its gaps are "
                         "met loosely; give 1e-6, at least {:g}, or 0",
                         asked, least));
  if (weights.inertia || weights.stabilisation > 0)
    return;
  RigidMotions motions(model);
  motions.hold_motions();
  motions.hold_links();
  motions.hold_springs();
  auto loose = motions.loose();
  auto const any = [&] { return std::ranges::any_of(loose, [](auto const& own) { return !own.empty(); }); };
  if (!any())
    return;
  auto const& first = scene_.part.schedule.stages.front();
  double const dt = first.until / first.steps;
  hold_bonds(model, contact, start, dt, motions);
  loose = motions.loose();
  model.held_by_bonds = !any();
  for (std::size_t b = 0; b < loose.size(); ++b)
    if (!loose[b].empty())
      complain(
          {"bodies", scene_.bodies[b]},
          fmt::format("can {}: no motion holds it, nor a spring of at least 1e-7 of its stiffness, nor a "
                      "bond that is whole at the start, and in "
                      "a quasi-static run contact alone cannot; fix or drive a set of it (at a plane of "
                      "symmetry the component across it), let scheme.quasi_static{{stabilisation = 1e-6}} "
                      "hold it until contact does, or give it inertia with scheme.theta_xi",
                      fmt::join(loose[b], ", ")));
}

} // namespace stiction::scene
