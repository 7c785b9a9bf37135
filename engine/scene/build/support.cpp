// What holds the bodies: nodes on the axis of revolution, and rigid motions that nothing resists.
#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "dynamics/contact/bond_grip.hpp"
#include "dynamics/step/stepper.hpp"
#include "linear/decompositions.hpp"
#include "scene/build/builder.hpp"
#include "scene/description/human.hpp"

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

/// The parts of bodies that hang together by cells, [nodes]; -1: a node of none.
class Parts {
public:
  explicit Parts(dynamics::Model const& model) : leader_(ix(model.first_node.back())) {
    std::iota(leader_.begin(), leader_.end(), Index{0});
    std::vector<bool> used(leader_.size(), false);
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      for (auto const& block : model.bodies[b]->mesh.blocks) {
        auto const step = static_cast<std::size_t>(mesh::info(block.kind).nodes);
        for (std::size_t i = 0; i < block.nodes.size(); ++i) {
          Index const first = block.nodes[i - i % step] + model.first_node[b],
                      node = block.nodes[i] + model.first_node[b];
          leader_[ix(find(node))] = find(first);
          used[ix(node)] = true;
        }
      }
    std::map<Index, Index> numbers;
    part_.assign(leader_.size(), -1);
    for (std::size_t node = 0; node < leader_.size(); ++node)
      if (used[node])
        part_[node] = numbers.emplace(find(static_cast<Index>(node)), numbers.size()).first->second;
    count_ = static_cast<Index>(numbers.size());
  }
  [[nodiscard]] Index of(Index node) const { return part_[ix(node)]; }
  [[nodiscard]] Index count() const { return count_; }

private:
  Index find(Index node) {
    while (leader_[ix(node)] != node)
      node = leader_[ix(node)] = leader_[ix(leader_[ix(node)])];
    return node;
  }
  Indices leader_, part_;
  Index count_ = 0;
};

/// Motions of a part of a body that nothing resists.
struct Loose {
  std::size_t body;
  std::vector<std::string> motions; ///< by the component that is most of each
  Vec3 middle;                      ///< m
  bool alone;                       ///< does the body hang together?
};

/// The rigid motions of all parts of bodies, one after the other, and what resists them.
class RigidMotions {
public:
  explicit RigidMotions(dynamics::Model const& model)
      : model_(&model), names_(motion_names(model.kinematics)), parts_(model), frames_(ix(parts_.count())) {
    int const dim = model.dim();
    for (std::size_t b = 0; b < model.bodies.size(); ++b)
      for (Index node = model.first_node[b]; node < model.first_node[b + 1]; ++node)
        if (Index const part = parts_.of(node); part >= 0) {
          auto& frame = frames_[ix(part)];
          frame.body = b;
          frame.low.head(dim) = frame.low.head(dim).cwiseMin(model.reference.row(node).transpose());
          frame.high.head(dim) = frame.high.head(dim).cwiseMax(model.reference.row(node).transpose());
        }
    for (auto& frame : frames_)
      for (int c = dim; c < 3; ++c)
        frame.low[c] = frame.high[c] = 0;
    leader_.resize(frames_.size());
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
  }

  /// A displacement component of one node is held: `weights` over the components of `nodes` is.
  void hold(Indices const& nodes, Eigen::RowVectorXd const& weights) {
    std::map<std::size_t, Eigen::RowVectorXd> rows;
    int const dim = model_->dim();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      Index const part = parts_.of(nodes[k]);
      if (part < 0)
        continue;
      auto const& frame = frames_[ix(part)];
      Vec3 X = -frame.middle();
      X.head(dim) += model_->reference.row(nodes[k]).transpose();
      rows.try_emplace(ix(part), Eigen::RowVectorXd::Zero(count())).first->second +=
          weights.segment(dim * static_cast<Eigen::Index>(k), dim) *
          rigid_motions(model_->kinematics, X / frame.size());
    }
    for (auto const& [a, row] : rows)
      for (auto const& [b, other] : rows) {
        held_.try_emplace({a, b}, Dense::Zero(count(), count())).first->second += row.transpose() * other;
        leader_[leader_of(a)] = leader_of(b);
      }
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

  /// Parts with motions that nothing resists.
  [[nodiscard]] std::vector<Loose> loose() {
    std::map<std::size_t, std::vector<std::size_t>> groups; // of parts that something holds together
    for (std::size_t part = 0; part < frames_.size(); ++part)
      groups[leader_of(part)].push_back(part);
    std::vector<Loose> found;
    for (auto const& [leader, parts] : groups)
      add_loose(parts, found);
    return found;
  }

private:
  struct Frame {
    std::size_t body = 0;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low; ///< of its nodes, m
    [[nodiscard]] Vec3 middle() const { return 0.5 * (low + high); }
    [[nodiscard]] double size() const { return (high - low).norm(); }
  };
  std::size_t leader_of(std::size_t part) {
    while (leader_[part] != part)
      part = leader_[part] = leader_[leader_[part]];
    return part;
  }
  void add_loose(std::vector<std::size_t> const& parts, std::vector<Loose>& found) const {
    auto const n = static_cast<Index>(parts.size());
    Dense held = Dense::Zero(n * count(), n * count());
    for (Index a = 0; a < n; ++a)
      for (Index b = 0; b < n; ++b)
        if (auto const block = held_.find({parts[ix(a)], parts[ix(b)]}); block != held_.end())
          held.block(a * count(), b * count(), count(), count()) = block->second;
    Eigen::SelfAdjointEigenSolver<Dense> const all(held);
    auto const& values = all.eigenvalues(); // ascending
    auto const free = (values.array() <= 1e-12 * std::max(1.0, values[values.size() - 1])).count();
    for (Index a = 0; a < n && free > 0; ++a) {
      auto const& frame = frames_[parts[ix(a)]];
      bool const alone = std::ranges::count(frames_, frame.body, &Frame::body) == 1;
      Loose part{frame.body, {}, frame.middle(), alone};
      Dense const own = all.eigenvectors().block(a * count(), 0, count(), free);
      Eigen::JacobiSVD<Dense> const svd(own * own.transpose(), Eigen::ComputeFullU);
      for (Eigen::Index k = 0; k < count() && svd.singularValues()[k] > 1e-12; ++k) {
        Eigen::Index strongest = 0;
        svd.matrixU().col(k).cwiseAbs().maxCoeff(&strongest);
        part.motions.emplace_back(names_[static_cast<std::size_t>(strongest)]);
      }
      if (!part.motions.empty())
        found.push_back(std::move(part));
    }
  }
  /// None of a spring below `least` E, times a length where forces are not per metre of depth.
  [[nodiscard]] std::size_t holding_members(dynamics::Spring const& spring) const {
    Index const part = parts_.of(spring.from.nodes.front());
    if (part < 0)
      return 0;
    auto const& frame = frames_[ix(part)];
    bool const plane = model_->kinematics == solid::Kinematics::plane_strain;
    double const young = material::moduli(model_->bodies[frame.body]->material).young;
    if (spring.stiffness < least * young * (plane ? 1 : frame.size()))
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
  Parts parts_;
  std::vector<Frame> frames_;
  std::vector<std::size_t> leader_; ///< of parts that something holds together
  /// Sum of (resisted)^T (resisted), [motions, motions] for each two parts that something holds together.
  std::map<std::pair<std::size_t, std::size_t>, Dense> held_;
};

/// "1 mm, 2 mm"
std::string place(Vec3 const& at, int dim) {
  auto text = human(at[0], "m");
  for (int c = 1; c < dim; ++c)
    text += ", " + human(at[c], "m");
  return text;
}

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
  if (motions.loose().empty())
    return;
  auto const& first = scene_.part.schedule.stages.front();
  double const dt = first.until / first.steps;
  hold_bonds(model, contact, start, dt, motions);
  auto const loose = motions.loose();
  model.held_by_bonds = loose.empty();
  std::set<std::size_t> told;
  for (auto const& part : loose) {
    if (!told.insert(part.body).second)
      continue;
    auto const others = std::ranges::count(loose, part.body, &Loose::body) - 1;
    auto const which = part.alone ? std::string()
                                  : fmt::format("is in parts that no cell joins; the one about ({}){} ",
                                                place(part.middle, model.dim()),
                                                others > 0 ? fmt::format(" and {} more", others) : "");
    complain(
        {"bodies", scene_.bodies[part.body]},
        fmt::format("{}can {}: no motion holds it, nor a spring of at least 1e-7 of its stiffness, nor a "
                    "bond that is whole at the start, and in "
                    "a quasi-static run contact alone cannot; fix or drive a set of it (at a plane of "
                    "symmetry the component across it), let scheme.quasi_static{{stabilisation = 1e-6}} "
                    "hold it until contact does, or give it inertia with scheme.theta_xi",
                    which, fmt::join(part.motions, ", ")));
  }
}

} // namespace stiction::scene
