// Springs by their members: whole ones between means, or a share of one at each node.
#include "dynamics/bulk/springs.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {

/// Components in which the spring may act.
std::vector<int> components_of(Spring const& spring, int dim) {
  std::vector<int> all;
  for (int c = 0; c < dim; ++c)
    if (spring.along == SpringAlong::line ||
        (spring.along == SpringAlong::axes ? spring.axes[c] : spring.direction[c]) != 0)
      all.push_back(c);
  return all;
}

} // namespace

Springs::Springs(Model const& model) : model_(&model) {
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    auto const& spring = model.springs[s];
    damped_ = damped_ || spring.damping > 0;
    linear_ = linear_ && spring.linear();
    if (!spring.spread) {
      Member whole{s, 1, spring.from.nodes, {}};
      whole.nodes.insert(whole.nodes.end(), spring.to.nodes.begin(), spring.to.nodes.end());
      for (double const share : spring.from.shares)
        whole.weights.push_back(-share);
      whole.weights.insert(whole.weights.end(), spring.to.shares.begin(), spring.to.shares.end());
      members_.push_back(std::move(whole));
    }
    for (std::size_t k = 0; spring.spread && k < spring.from.nodes.size(); ++k)
      members_.push_back({s, spring.from.shares[k], {spring.from.nodes[k]}, {-1}});
  }
  for (std::size_t m = 0; m < members_.size(); ++m)
    add_blocks(m);
}

/// Components that a spring does not couple have a block each.
void Springs::add_blocks(std::size_t m) {
  auto const& member = members_[m];
  auto const& spring = model_->springs[member.spring];
  int const dim = model_->dim();
  auto const components = components_of(spring, dim);
  bool const together = spring.along != SpringAlong::axes;
  for (int const c : components) {
    if (!together || c == components.front())
      blocks_.push_back({m, {}, {}, {}, {}});
    auto& block = blocks_.back();
    for (std::size_t k = 0; k < member.nodes.size(); ++k) {
      block.dofs.push_back(dim * member.nodes[k] + c);
      block.components.push_back(c);
      block.weights.push_back(member.weights[k]);
    }
  }
}

Eigen::Vector3d Springs::apart(Member const& member, Vector const& u, double t) const {
  auto const& spring = model_->springs[member.spring];
  int const dim = model_->dim();
  Eigen::Vector3d way = spring.start();
  for (int c = 0; c < dim; ++c)
    way[c] += spring.to.shift[ix(c)].value(t);
  for (std::size_t k = 0; k < member.nodes.size(); ++k)
    way.head(dim) += member.weights[k] * u.segment(dim * member.nodes[k], dim);
  return way;
}

Eigen::Vector3d Springs::rate(Member const& member, Vector const& v, double t) const {
  auto const& spring = model_->springs[member.spring];
  int const dim = model_->dim();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int c = 0; c < dim; ++c)
    sum[c] = spring.to.shift[ix(c)].rate_before(t);
  for (std::size_t k = 0; k < member.nodes.size(); ++k)
    sum.head(dim) += member.weights[k] * v.segment(dim * member.nodes[k], dim);
  return sum;
}

void Springs::add_at(Member const& member, Eigen::Vector3d const& force, Vector& sum) const {
  int const dim = model_->dim();
  for (std::size_t k = 0; k < member.nodes.size(); ++k)
    sum.segment(dim * member.nodes[k], dim) += (member.share * member.weights[k]) * force.head(dim);
}

double Springs::add_force(Vector const& u, double t, Vector& force) const {
  double energy = 0;
  for (auto const& member : members_) {
    auto const now = pull_of(model_->springs[member.spring], apart(member, u, t));
    add_at(member, now.force, force);
    energy += member.share * now.energy;
  }
  return energy;
}

void Springs::add_damping(Instant const& now, Vector& force) const {
  for (auto const& member : members_)
    if (auto const& spring = model_->springs[member.spring]; spring.damping > 0)
      add_at(member, drag_of(spring, apart(member, now.u, now.t)) * rate(member, now.v, now.t), force);
}

/// Force of spring and dashpot, whatever the member's share.
SpringPull Springs::pull(Member const& member, Instant const& now) const {
  auto const& spring = model_->springs[member.spring];
  Eigen::Vector3d const way = apart(member, now.u, now.t);
  auto pull = pull_of(spring, way);
  if (spring.damping > 0)
    pull.force += drag_of(spring, way) * rate(member, now.v, now.t);
  return pull;
}

SpringPull Springs::pull(std::size_t spring, Instant const& now) const {
  SpringPull sum;
  for (auto const& member : members_)
    if (member.spring == spring) {
      auto const one = pull(member, now);
      sum.elongation += member.share * one.elongation;
      sum.energy += member.share * one.energy;
      sum.force += member.share * one.force;
    }
  return sum;
}

SpringWork Springs::path_work(Instant const& from, Instant const& to, double later) const {
  SpringWork work;
  for (auto const& member : members_) {
    auto const& spring = model_->springs[member.spring];
    Eigen::Vector3d carried = Eigen::Vector3d::Zero();
    for (int c = 0; c < model_->dim(); ++c)
      carried[c] = spring.to.shift[ix(c)].value(to.t) - spring.to.shift[ix(c)].value(from.t);
    if (carried.isZero(0))
      continue;
    Eigen::Vector3d const first = apart(member, from.u, from.t), last = apart(member, to.u, to.t);
    Eigen::Vector3d const pull =
        (1 - later) * pull_of(spring, first).force + later * pull_of(spring, last).force;
    work.elastic += member.share * pull.dot(carried);
    if (spring.damping > 0)
      work.viscous += member.share * ((1 - later) * drag_of(spring, first) * rate(member, from.v, from.t) +
                                      later * drag_of(spring, last) * rate(member, to.v, to.t))
                                         .dot(carried);
  }
  return work;
}

double Springs::damping_loss(Instant const& from, Instant const& to, double later) const {
  double loss = 0;
  for (auto const& member : members_) {
    auto const& spring = model_->springs[member.spring];
    if (spring.damping == 0)
      continue;
    Eigen::Vector3d const first = apart(member, from.u, from.t), last = apart(member, to.u, to.t);
    Eigen::Vector3d const drag = (1 - later) * drag_of(spring, first) * rate(member, from.v, from.t) +
                                 later * drag_of(spring, last) * rate(member, to.v, to.t);
    loss += member.share * std::max(0.0, drag.dot(last - first));
  }
  return loss;
}

void Springs::add_cliques(Indices const& unknown_of, std::vector<Indices>& cliques) const {
  for (auto const& block : blocks_) {
    auto& clique = cliques.emplace_back();
    for (Index const dof : block.dofs)
      clique.push_back(unknown_of[ix(dof)]);
  }
}

/// tangent(member): of the whole spring, [3, 3].
template<class Tangent> void Springs::add_entries(Tangent const& tangent, std::span<double> values) const {
  for (auto const& block : blocks_) {
    Eigen::Matrix3d const whole = tangent(members_[block.member]);
    auto at = block.map.begin();
    for (std::size_t i = 0; i < block.dofs.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j, ++at)
        if (*at >= 0)
          values[ix(*at)] +=
              block.weights[i] * block.weights[j] * whole(block.components[i], block.components[j]);
  }
}

void Springs::add_stiffness(Vector const& u, double t, double factor, std::span<double> values) const {
  add_entries(
      [&](Member const& member) -> Eigen::Matrix3d {
        return factor * member.share * pull_of(model_->springs[member.spring], apart(member, u, t)).tangent;
      },
      values);
}

void Springs::add_damping_stiffness(Vector const& u, double t, double factor,
                                    std::span<double> values) const {
  add_entries(
      [&](Member const& member) -> Eigen::Matrix3d {
        return factor * member.share * drag_of(model_->springs[member.spring], apart(member, u, t));
      },
      values);
}

/// Of a spring that is spread the members act on nodes of their own: the stiffest one tells.
double Springs::stiffest(Vector const& u, double t, Vector const& inverse_mass) const {
  std::vector<double> each(model_->springs.size(), 0.0);
  for (auto const& member : members_) {
    double compliance = 0;
    for (std::size_t k = 0; k < member.nodes.size(); ++k)
      compliance += member.weights[k] * member.weights[k] *
                    inverse_mass.segment(model_->dim() * member.nodes[k], model_->dim()).maxCoeff();
    double const stiffness =
        member.share * pull_of(model_->springs[member.spring], apart(member, u, t)).tangent.norm();
    each[member.spring] = std::max(each[member.spring], stiffness * compliance);
  }
  double sum = 0;
  for (double const one : each)
    sum += one;
  return sum;
}

} // namespace stiction::dynamics
