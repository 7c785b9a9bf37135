// Elimination of the bulk and of the geometric stiffness onto the components of the contact points.
#include "dynamics/contact/condensation.hpp"

#include <algorithm>
#include <cmath>

#include "linear/decompositions.hpp"

namespace stiction::dynamics {

void Condensation::clear() {
  now_.rows = 0;
  now_.H.clear();
  now_.change.clear();
  now_.K.clear();
}

void Condensation::add_point(Indices const& unknowns, Eigen::Ref<Dense const> const& H) {
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (Eigen::Index i = 0; i < H.rows(); ++i)
      if (double const value = H(i, static_cast<Eigen::Index>(j)); unknowns[j] >= 0 && value != 0)
        now_.H.push_back({now_.rows + static_cast<Index>(i), unknowns[j], value});
  now_.rows += static_cast<Index>(H.rows());
}

void Condensation::add_change(Indices const& unknowns, Eigen::Ref<Dense const> const& change) {
  Index const first = now_.rows - static_cast<Index>(change.rows());
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (Eigen::Index i = 0; i < change.rows(); ++i)
      if (double const value = change(i, static_cast<Eigen::Index>(j)); unknowns[j] >= 0 && value != 0)
        now_.change.push_back({first + static_cast<Index>(i), unknowns[j], value});
}

/// Of H + change.
template<class Act> void Condensation::each_row_entry(Act const& act) const {
  std::for_each(made_.H.begin(), made_.H.end(), act);
  std::for_each(made_.change.begin(), made_.change.end(), act);
}

void Condensation::add_stiffness(Indices const& unknowns, Eigen::Ref<Dense const> const& K) {
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (double const value = K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          unknowns[i] >= 0 && unknowns[j] >= 0 && value != 0)
        now_.K.push_back({unknowns[i], unknowns[j], value});
}

/// The unknowns that H or K touch.
void Condensation::find_used(Index surface) {
  slot_.assign(ix(surface), -1);
  used_.clear();
  auto use = [&](Index u) {
    if (slot_[ix(u)] >= 0)
      return;
    slot_[ix(u)] = static_cast<Index>(used_.size());
    used_.push_back(u);
  };
  for (auto const& k : made_.K) { // those of K first: the support
    use(k.row);
    use(k.column);
  }
  support_ = static_cast<Index>(used_.size());
  each_row_entry([&](Entry const& h) { use(h.column); });
}

/// Does each component move one unknown, each another one, as of nodes over a plane along the axes?
bool Condensation::one_to_one() const {
  Index row = 0;
  return std::ranges::all_of(made_.H, [&](Entry const& h) { return h.row == row++; }) && row == made_.rows &&
         static_cast<Index>(used_.size()) == made_.rows;
}

void Condensation::eliminate(linear::BulkFactor& bulk, Vector const& y, double weight, Dense& W,
                             Vector& free) {
  made_ = now_;
  symmetric_ = bulk.symmetric();
  held_ = bulk.hold() > 0;
  of_ = bulk.identity();
  lead_ = nullptr;
  for (Index u = 0; held_ && u < bulk.surface(); ++u) // S du = y is (S + hold P) du = y + hold P du
    made_.K.push_back({u, u, bulk.hold() / weight});
  free.setZero(made_.rows);
  each_row_entry([&](Entry const& h) { free[h.row] += h.value * y[h.column]; });
  bool const same = made_of_.bulk == bulk.identity() && made_of_.weight == weight && made_of_.H == made_.H;
  bool const plain = made_.K.empty() && made_.change.empty();
  if (plain && same && W.rows() == made_.rows)
    return;
  made_of_ = plain ? Origin{bulk.identity(), weight, made_.H} : Origin{};
  weight_ = weight;
  find_used(bulk.surface());
  if (plain && one_to_one()) {
    Vector const sides = Vector::NullaryExpr(made_.rows, [&](Index row) { return made_.H[ix(row)].value; });
    bulk.compliance(used_, W);
    V_.resize(0, 0);
    for (auto const& h : made_.H)
      W.col(h.row).array() *= (weight * h.value) * sides.array();
    return;
  }
  set_mobility(bulk, W);
  if (support_ == 0)
    return;
  add_stiffness_of_contact(W);
  move_without_forces(*this, y, free);
}

linear::SurfaceRows Condensation::rows(Vector const& y, double weight, Vector& free) {
  made_ = now_;
  support_ = 0;
  of_.reset();
  lead_ = nullptr;
  free.setZero(made_.rows);
  for (auto const& h : made_.H)
    free[h.row] += h.value * y[h.column];
  return {made_.H, made_.rows, weight};
}

/// W = weight (H + change) V H^T
void Condensation::set_mobility(linear::BulkFactor& bulk, Dense& W) {
  bulk.compliance(used_, V_);
  right_.setZero(V_.rows(), made_.rows);
  for (auto const& h : made_.H)
    right_.col(h.row) += (weight_ * h.value) * V_.col(slot_[ix(h.column)]);
  across_ = right_.transpose();
  W.setZero(made_.rows, made_.rows);
  each_row_entry([&](Entry const& h) { W.col(h.row) += h.value * across_.col(slot_[ix(h.column)]); });
  if (!alike()) // else W is its own transpose
    W.transposeInPlace();
}

/// Adds what K_geo does to W.
void Condensation::add_stiffness_of_contact(Dense& W) {
  Index const m = made_.rows, s = support_;
  small_.setIdentity(s, s);
  bool const crowded = made_.K.size() > static_cast<std::size_t>(s) * static_cast<std::size_t>(s);
  if (crowded) {
    K_all_.setZero(s, s);
    for (auto const& k : made_.K)
      K_all_(slot_[ix(k.row)], slot_[ix(k.column)]) += weight_ * k.value;
    small_.noalias() -= V_.topLeftCorner(s, s) * K_all_;
  }
  for (auto const& k : made_.K)
    if (!crowded)
      small_.col(slot_[ix(k.column)]) -= (weight_ * k.value) * V_.col(slot_[ix(k.row)]).head(s);
  small_factor_.compute(small_);
  Dense motion(m, s);
  if (m > 0)
    motion = small_factor_.solve(right_.topRows(s)).transpose();
  K_motion_.setZero(m, s);
  if (crowded)
    K_motion_.noalias() = motion * K_all_.transpose();
  for (auto const& k : made_.K)
    if (!crowded)
      K_motion_.col(slot_[ix(k.row)]) += (weight_ * k.value) * motion.col(slot_[ix(k.column)]);
  if (!alike()) {
    if (!symmetric_)
      V_.transposeInPlace();
    left_.setZero(s, m);
    each_row_entry([&](Entry const& h) {
      left_.col(h.row) += (weight_ * h.value) * V_.col(slot_[ix(h.column)]).head(s);
    });
    if (!symmetric_)
      V_.transposeInPlace();
  }
  W.noalias() += (1 / weight_) * (sides() * K_motion_.transpose());
}

/// Adds to `free` what the K_geo of `made` does where nothing but y moves its support.
void Condensation::move_without_forces(Condensation const& made, Vector const& y, Vector& free) {
  Index const s = made.support_;
  Vector motion = y(made.used_).head(s);
  motion = made.small_factor_.solve(motion).eval();
  K_moving_.setZero(s);
  for (auto const& k : made.made_.K)
    K_moving_[made.slot_[ix(k.row)]] += (made.weight_ * k.value) * motion[made.slot_[ix(k.column)]];
  free.noalias() += (1 / made.weight_) * (made.sides() * K_moving_);
}

bool Condensation::like_last(linear::BulkFactor const& bulk, double weight, double slight) const {
  if (!of_ || of_ != bulk.identity() || weight_ != weight || held_ || now_.rows != made_.rows)
    return false;
  if (now_.K.empty() && now_.change.empty() && now_.H == made_.H) // `eliminate` leaves W as well, to the bit
    return false;
  auto const largest = [](std::vector<Entry> const& entries) {
    double most = 0;
    for (auto const& one : entries)
      most = std::max(most, std::abs(one.value));
    return most;
  };
  auto const like = [&](std::vector<Entry> const& now, std::vector<Entry> const& made, double scale) {
    return std::ranges::equal(now, made, [&](Entry const& a, Entry const& b) {
      return a.row == b.row && a.column == b.column && std::abs(a.value - b.value) <= slight * scale;
    });
  };
  double const of_rows = largest(made_.H);
  return like(now_.H, made_.H, of_rows) && like(now_.change, made_.change, of_rows) &&
         like(now_.K, made_.K, largest(made_.K));
}

bool Condensation::eliminate_as(Condensation const& lead, linear::BulkFactor const& bulk, Present const& now,
                                double weight, Vector& free) {
  bool const of_another = lead.lead_ != nullptr && lead.lead_ != &lead;
  if (!lead.of_ || of_another || lead.of_ != bulk.identity() || lead.weight_ != weight)
    return false;
  extra_ = weight * now.reaction;
  for (auto const& h : lead.made_.H)
    extra_[h.column] -= weight * h.value * now.force[h.row];
  for (Index u = 0; u < bulk.surface(); ++u)
    if (extra_[u] != 0 && lead.slot_[ix(u)] < 0) // the points have come to other nodes
      return false;
  moved_ = now.y;
  if (!extra_.isZero(0)) {
    if (lead.V_.size() == 0)
      return false;
    moved_(lead.used_) += lead.V_ * extra_(lead.used_);
  }
  if (&lead != this)
    made_of_ = {};
  lead_ = &lead;
  free.setZero(lead.made_.rows);
  lead.each_row_entry([&](Entry const& h) { free[h.row] += h.value * moved_[h.column]; });
  if (lead.support_ > 0)
    move_without_forces(lead, moved_, free);
  return true;
}

/// With V = L L^T, where I - L^T K_geo L is; a K_geo small beside V^-1 needs no factor.
bool Condensation::stable() const {
  if (held_ || support_ == 0 ||
      (small_ - Dense::Identity(support_, support_)).cwiseAbs().rowwise().sum().maxCoeff() < 1)
    return true;
  Dense const V = V_.topLeftCorner(support_, support_);
  Eigen::LLT<Dense> const bulk(0.5 * (V + V.transpose()));
  if (bulk.info() != Eigen::Success)
    return true;
  Dense const U = bulk.matrixU(); // L^T
  Dense UK = Dense::Zero(support_, support_);
  for (auto const& k : made_.K) {
    Index const row = slot_[ix(k.row)], filled = row + 1;
    UK.col(slot_[ix(k.column)]).head(filled) += (weight_ * k.value) * U.col(row).head(filled);
  }
  Dense const turned = UK * U.transpose().triangularView<Eigen::Lower>();
  return Eigen::LLT<Dense>(Dense::Identity(support_, support_) - 0.5 * (turned + turned.transpose()))
             .info() == Eigen::Success;
}

void Condensation::add_forces(Vector const& force, double weight, Vector& c) const {
  auto const& made = lead_ != nullptr ? *lead_ : *this;
  if (lead_ != nullptr)
    c += extra_;
  for (auto const& h : made.made_.H)
    c[h.column] += weight * h.value * force[h.row];
  if (made.support_ == 0)
    return;
  Vector const extra = made.K_motion_.transpose() * force + K_moving_;
  for (Index i = 0; i < made.support_; ++i)
    c[made.used_[ix(i)]] += extra[i];
}

} // namespace stiction::dynamics
