// Gathering of rows and stiffnesses over the surface unknowns, and what the condensed problem holds.
#include "dynamics/contact/problem_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dynamics/contact/bond_grip.hpp"
#include "dynamics/model/spin.hpp"

namespace stiction::dynamics {

namespace {
/// Grip, of the bonds' stiffness: of free bodies, for a finite compliance; of unstable ones, more and more.
constexpr double lightest = 1e-4, loosest = 0.05, tighter = 10, tightest = 0.5;
/// Change of rows and stiffnesses, over the largest, that slows Newton's method less than kept factors do.
constexpr double slight = 1e-2;
} // namespace

template<int D, int C>
ProblemAssembly<D, C>::ProblemAssembly(Model const& model, BulkSystem const& bulk)
    : model_(&model), bulk_(&bulk), spins_(std::ranges::any_of(model.rigids, tensorial)) {
  if (model.reference.size() > 0)
    last_digit_ = 8 * std::numeric_limits<double>::epsilon() * model.reference.cwiseAbs().maxCoeff();
}

template<int D, int C> void ProblemAssembly<D, C>::begin(State const& old, double dt, bool turning) {
  old_ = &old;
  dt_ = dt;
  turning_ = turning;
  turned_ = false;
  unstable_ = Unstable::unmet;
  grip_ = 0;
  condensation_.forget(); // what a step does must follow from its start alone
}

template<int D, int C> bool ProblemAssembly<D, C>::insist() {
  if (unstable_ != Unstable::met)
    return false;
  unstable_ = Unstable::insisted;
  return turning_ = true;
}

template<int D, int C> bool ProblemAssembly<D, C>::give_in() {
  if (unstable_ != Unstable::insisted || !turning_)
    return false;
  unstable_ = Unstable::given_in;
  turning_ = false;
  return true;
}

template<int D, int C> bool ProblemAssembly<D, C>::tighten(Points const& points) {
  if (grip_ >= tightest || weights(model_->scheme).inertia)
    return false;
  bool bonded = false;
  for (std::size_t row = 0; row < points.active().size() && !bonded; ++row) {
    auto const& point = points.active(row);
    bonded = points.pair_of(point).law.adhesion && point.data.bond.old.beta > interface::least_beta;
  }
  grip_ = bonded ? (grip_ >= loosest ? tighter * grip_ : loosest) : grip_;
  return bonded;
}

template<int D, int C>
Vector ProblemAssembly<D, C>::pose(Points const& points, linear::BulkFactor& bulk, Vector const& y,
                                   double weight, contact::Problem& problem) {
  if (model_->held_by_bonds)
    grip_ = std::max(grip_, lightest);
  else if (bulk.hold() > 0) // unstable, not only free
    grip_ = std::max(grip_, loosest);
  auto* const together = bulk.coupled();
  turning_ = turning_ && together == nullptr;
  gather(points, weight);
  if (together != nullptr)
    couple(*together, y, weight, problem);
  else if (pose_again(points, bulk, {y, weight}, problem))
    return fill(points, problem);
  else
    condensation_.eliminate(bulk, y, weight, problem.W.entries(), problem.free);
  // there might be no answer; with inertia a shorter step has one
  if (turning_ && unstable_ != Unstable::insisted && !weights(model_->scheme).inertia &&
      !condensation_.stable()) {
    if (unstable_ == Unstable::unmet)
      unstable_ = Unstable::met;
    turning_ = false;
    Vector guess = pose(points, bulk, y, weight, problem);
    turning_ = D == 3; // on the way round a corner, with the next iterate normals may turn again
    return guess;
  }
  turned_ = turned_ || (turning_ && condensation_.turns());
  return fill(points, problem);
}

/// Where the last problem's W is as good as this one's, whose forces and gaps are told exactly all the same.
template<int D, int C>
bool ProblemAssembly<D, C>::pose_again(Points const& points, linear::BulkFactor& bulk, Unloaded const& now,
                                       contact::Problem& problem) {
  return condensation_.like_last(bulk, now.weight, slight) && eliminate_as(*this, points, bulk, now, problem);
}

template<int D, int C>
bool ProblemAssembly<D, C>::eliminate_as(ProblemAssembly const& lead, Points const& points,
                                         linear::BulkFactor& bulk, Unloaded const& now,
                                         contact::Problem& problem) {
  Vector const force = forces_of(points);
  reaction_.setZero(now.y.size());
  for (Index const k : points.active()) {
    auto const& point = points.all()[ix(k)];
    auto const& H = point.kinematics.H;
    auto const& unknowns = unknowns_of(point.kinematics.nodes);
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      if (unknowns[j] >= 0)
        reaction_[unknowns[j]] += H.col(static_cast<Eigen::Index>(j)).template head<C>().dot(point.force);
  }
  return condensation_.eliminate_as(lead.condensation_, bulk, {now.y, force, reaction_}, now.weight,
                                    problem.free);
}

template<int D, int C>
std::optional<Vector> ProblemAssembly<D, C>::pose_as(ProblemAssembly const& lead, Points const& points,
                                                     linear::BulkFactor& bulk, Unloaded const& now,
                                                     contact::Problem& problem) {
  if (!eliminate_as(lead, points, bulk, now, problem))
    return {};
  turning_ = lead.turning_;
  return fill(points, problem);
}

/// The points of a problem whose operator is there, and their gaps and slips; returns their present forces.
template<int D, int C>
Vector ProblemAssembly<D, C>::fill(Points const& points, contact::Problem& problem) const {
  problem.dim = C;
  problem.points.clear();
  problem.start.setZero(problem.free.size());
  bool const known = problem.W.rows() == problem.free.size(); // else it is another's, who poses the same
  for (std::size_t row = 0; row < points.active().size(); ++row) {
    auto const& point = points.active(row);
    auto const first = C * static_cast<Index>(row);
    problem.free.segment<C>(first) += point.x();
    if (known && problem.W.diagonal(first) == 0 && std::abs(problem.free[first]) <= last_digit_)
      problem.free[first] = 0; // of a point that nothing moves rounding presses no force out
    problem.points.push_back(point.data);
    problem.start[first] = points.before(point).gap;
  }
  return forces_of(points);
}

/// Of the active points, one below the other, N.
template<int D, int C> Vector ProblemAssembly<D, C>::forces_of(Points const& points) {
  Vector forces(C * static_cast<Index>(points.active().size()));
  for (std::size_t row = 0; row < points.active().size(); ++row)
    forces.segment<C>(C * static_cast<Index>(row)) = points.active(row).force;
  return forces;
}

/// Without W: a product with it is a solution of the bulk.
template<int D, int C>
void ProblemAssembly<D, C>::couple(linear::CoupledBulk& bulk, Vector const& y, double weight,
                                   contact::Problem& problem) {
  bulk.couple(condensation_.rows(y, weight, problem.free));
  problem.W = contact::Delassus(bulk.blocks(C), bulk);
}

/// grip_: bodies that are unstable by themselves, as a long film that is pressed a little along, are held by
/// their bonds.
template<int D, int C> void ProblemAssembly<D, C>::gather(Points const& points, double weight) {
  auto const& geometry = points.geometry();
  condensation_.clear();
  if (D == 3 && spins_)
    add_spins(points, weight);
  for (Index const k : points.active()) {
    auto const& point = points.all()[ix(k)];
    auto const& kinematics = point.kinematics;
    condensation_.add_point(unknowns_of(kinematics.nodes), kinematics.H.template topRows<C>());
    if (turning_)
      geometry.change(point.id, kinematics, [&](Indices const& nodes, auto const& change) {
        condensation_.add_change(unknowns_of(nodes), change.template topRows<C>());
      });
    if (turning_ && !geometry.shared(point.id.pair))
      geometry.stiffness(point.id, kinematics, full<D>(point.force),
                         [&](Indices const& nodes, auto const& K) { add_stiffness(nodes, K); });
    if (grip_ > 0)
      add_stiffness(kinematics.nodes,
                    grip_ * bond_grip(points.pair_of(point).law, point.data, {kinematics.gap, kinematics.H}));
  }
  for (std::size_t pair = 0; pair < model_->pairs.size(); ++pair)
    if (turning_ && geometry.shared(static_cast<int>(pair)))
      add_shared_stiffness(points, static_cast<int>(pair));
}

/// What the mass matrix, which has a third of the trace about every axis, lacks of the torque's derivative.
template<int D, int C> void ProblemAssembly<D, C>::add_spins(Points const& points, double weight) {
  auto const scheme = weights(model_->scheme);
  bool const apart = scheme.surface_apart();
  double const factor = apart ? scheme.apart_factor() : 1, mass = apart ? 1 : scheme.mass;
  for (std::size_t r = 0; r < model_->rigids.size(); ++r) {
    auto const& rigid = model_->rigids[r];
    if (!tensorial(rigid))
      continue;
    Vec3 const d = points.geometry().moved().template segment<3>(rigid.turn());
    Eigen::Matrix3d const known = rigid.inertia / (mass * dt_ * dt_) * Eigen::Matrix3d::Identity();
    add_stiffness({rigid.node + 1},
                  (-factor / weight) * (spin_of(*model_, r, *old_, dt_).stiffness(d) - known));
  }
}

template<int D, int C> void ProblemAssembly<D, C>::add_shared_stiffness(Points const& points, int pair) {
  std::vector<contact::Local<D>> forces(ix(model_->pairs[ix(pair)].size()), contact::Local<D>::Zero());
  for (Index const k : points.active())
    if (auto const& point = points.all()[ix(k)]; point.id.pair == pair)
      forces[ix(point.id.index)] = full<D>(point.force);
  points.geometry().shared_stiffness(pair, forces,
                                     [&](Indices const& nodes, auto const& K) { add_stiffness(nodes, K); });
}

template<int D, int C>
void ProblemAssembly<D, C>::add_stiffness(Indices const& nodes, Eigen::Ref<Dense const> const& K) {
  condensation_.add_stiffness(unknowns_of(nodes), K);
}

template<int D, int C> Indices const& ProblemAssembly<D, C>::unknowns_of(Indices const& nodes) {
  unknowns_.assign(D * nodes.size(), -1);
  for (std::size_t a = 0; a < unknowns_.size(); ++a)
    if (Index const u = bulk_->moved_with(D * nodes[a / D] + static_cast<Index>(a % D)); u >= 0)
      unknowns_[a] = u - bulk_->first_contact_unknown();
  return unknowns_;
}

template class ProblemAssembly<2, 1>;
template class ProblemAssembly<2, 2>;
template class ProblemAssembly<3, 1>;
template class ProblemAssembly<3, 3>;

} // namespace stiction::dynamics
