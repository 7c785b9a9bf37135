// Gauss-Seidel within each rank's rows, and what points hold: in the smoother, in the prolongators, and so in
// the coarse matrices.
#include "linear/rank_multigrid.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "core/error.hpp"

namespace stiction::linear {

namespace {

constexpr double none = 1e-10; ///< of a block's largest eigenvalue

Matrix3 inverse_of(Matrix3 const& block) {
  Eigen::SelfAdjointEigenSolver<Matrix3> const parts(block);
  Eigen::Vector3d values = parts.eigenvalues();
  double const least = none * values[2];
  for (double& value : values)
    value = value > least ? 1 / value : 0;
  return parts.eigenvectors() * values.asDiagonal() * parts.eigenvectors().transpose();
}

/// Where a node stands in an ascending list of held ones, or -1.
Index place_of(std::vector<HeldNode> const& held, Index node) {
  auto const at = std::ranges::lower_bound(held, node, {}, &HeldNode::node);
  return at != held.end() && at->node == node ? static_cast<Index>(at - held.begin()) : -1;
}

} // namespace

RankMultigrid::RankMultigrid(Ranks const& ranks, Indices first)
    : ranks_(&ranks), first_(std::move(first)), begin_(first_[ix(ranks.rank())]),
      end_(first_[ix(ranks.rank() + 1)]), coarse_(ranks.coarse_levels(first_)) {}

/// Which nodes of others own rows couple with, and where columns stand then.
void RankMultigrid::look_beyond() {
  beyond_.clear();
  for (Index const j : A_.column)
    if (!own(j))
      beyond_.push_back(j);
  std::ranges::sort(beyond_);
  beyond_.erase(std::unique(beyond_.begin(), beyond_.end()), beyond_.end());
  auto const place = [&](Index j) {
    return static_cast<Index>(std::ranges::lower_bound(beyond_, j) - beyond_.begin());
  };
  Index const n = A_.rows();
  local_.clear();
  local_.reserve(A_.column.size());
  for (Index const j : A_.column)
    local_.push_back(own(j) ? j - begin_ : n + place(j));
  own_block_.resize(ix(n));
  for (Index i = 0; i < n; ++i)
    own_block_[ix(i)] = A_.find(i, begin_ + i);
  border_ = ranks_->border({first_, beyond_});
}

/// What couples own nodes, and what couples these with nodes beyond.
void RankMultigrid::take_own() {
  Index const n = A_.rows();
  BlockMatrix<3, 3> inner;
  inner.columns = n;
  inner.column.reserve(A_.column.size());
  inner.values.reserve(A_.values.size());
  bordering_.clear();
  share_.clear();
  toward_ = {};
  toward_.columns = static_cast<Index>(beyond_.size());
  for (Index i = 0; i < n; ++i) {
    Matrix3 share = Matrix3::Zero();
    auto const before = toward_.column.size();
    for (Index k = A_.starts[ix(i)]; k < A_.starts[ix(i) + 1]; ++k) {
      Index const j = local_[ix(k)];
      auto& part = j < n ? inner : toward_;
      part.column.push_back(j < n ? j : j - n);
      part.values.insert(part.values.end(), A_.block(k).data(), A_.block(k).data() + 9);
      if (j >= n) // what makes sweeps within ranks converge (Baker, Falgout, Kolev & Yang 2011)
        share.diagonal() += Matrix3(A_.block(k)).cwiseAbs().rowwise().sum();
    }
    inner.end_row();
    if (toward_.column.size() == before)
      continue;
    toward_.end_row();
    bordering_.push_back(i);
    share_.push_back(share);
  }
  within_.take(inner, Waves::one_by_one(n));
  free_.waves = Waves::one_by_one(n);
  free_.take_matrix(inner);
}

void RankMultigrid::set_up(BlockMatrix<3, 3> A, Dense const& modes) {
  bool const same = border_ != nullptr && A.column == A_.column && A.starts == A_.starts;
  A_ = std::move(A);
  if (!same)
    look_beyond();
  take_own();
  held_.clear();
  held_own_.assign(ix(A_.rows()), Matrix3::Zero());
  invert(free_);
  hold_ = free_;
  coarse_->set_up(A_, modes);
}

void RankMultigrid::invert(SingleLevel<3>& level) const {
  std::size_t border = 0;
  for (Index i = 0; i < A_.rows(); ++i) {
    Matrix3 block = diagonal(i) + held_own_[ix(i)];
    if (border < bordering_.size() && bordering_[border] == i)
      block += share_[border++];
    level.set_inverse(i, inverse_of(block));
  }
}

/// turns_: how much of a coarse motion each held node follows.
void RankMultigrid::gather_diagonals(std::vector<HeldNode> const& held) {
  std::vector<double> blocks(9 * held.size(), 0.0);
  for (std::size_t h = 0; h < held.size(); ++h)
    if (own(held[h].node))
      Eigen::Map<Matrix3>{&blocks[9 * h]} = diagonal(held[h].node - begin_);
  ranks_->sum(blocks);
  turns_.clear();
  for (std::size_t h = 0; h < held.size(); ++h) {
    Matrix3 const own = Eigen::Map<Matrix3 const>(&blocks[9 * h]);
    turns_.push_back(held[h].stiffness.isZero(0) ? Matrix3(Matrix3::Identity())
                                                 : Matrix3(inverse_of(own + held[h].stiffness) * own));
  }
}

/// S^T (A + held) S - A with S = (own + held)^-1 own of held nodes, 1 of others.
BlockMatrix<3, 3> RankMultigrid::change_of(std::vector<HeldNode> const& held) const {
  BlockMatrix<3, 3> D;
  D.columns = A_.columns;
  Indices place_beyond;
  for (Index const node : beyond_)
    place_beyond.push_back(place_of(held, node));
  Indices place_own(ix(A_.rows()), -1);
  for (std::size_t h = 0; h < held.size(); ++h)
    if (own(held[h].node))
      place_own[ix(held[h].node - begin_)] = static_cast<Index>(h);
  for (Index i = 0; i < A_.rows(); ++i) {
    Index const at = place_own[ix(i)];
    for (Index k = A_.starts[ix(i)]; k < A_.starts[ix(i) + 1]; ++k) {
      Index const j = local_[ix(k)];
      Index const by = j < A_.rows() ? place_own[ix(j)] : place_beyond[ix(j - A_.rows())];
      if (at < 0 && by < 0)
        continue;
      Matrix3 changed = A_.block(k);
      if (at >= 0 && i == j)
        changed += held[ix(at)].stiffness;
      if (at >= 0)
        changed = (turns_[ix(at)].transpose() * changed).eval();
      if (by >= 0)
        changed = (changed * turns_[ix(by)]).eval();
      changed -= A_.block(k);
      D.column.push_back(A_.column[ix(k)]);
      D.values.insert(D.values.end(), changed.data(), changed.data() + changed.size());
    }
    D.end_row();
  }
  return D;
}

void RankMultigrid::hold(std::vector<HeldNode> held) {
  if (held == held_)
    return;
  held_ = std::move(held);
  for (auto& stiffness : held_own_)
    stiffness.setZero();
  for (auto const& one : held_)
    if (own(one.node))
      held_own_[ix(one.node - begin_)] = one.stiffness;
  invert(hold_);
  gather_diagonals(held_);
  coarse_->change(change_of(held_));
}

/// y -= what nodes beyond, as they were last exchanged, do to own ones.
void RankMultigrid::subtract_beyond(Vector& y) const {
  for (std::size_t b = 0; b < bordering_.size(); ++b)
    for (Index k = toward_.starts[b]; k < toward_.starts[b + 1]; ++k)
      y.segment<3>(3 * bordering_[b]).noalias() -=
          toward_.block(k) * at_beyond_.segment<3>(3 * toward_.column[ix(k)]);
}

void RankMultigrid::product(Vector const& x, Vector& y) {
  border_->exchange(x, at_beyond_);
  at_beyond_ = -at_beyond_;
  within_(x, y);
  subtract_beyond(y);
}

void RankMultigrid::cycle(Vector const& r, bool held, Vector& z) {
  auto& level = held ? hold_ : free_;
  double const most = r.lpNorm<Eigen::Infinity>(), size = most > 0 ? most : 1; // as Multigrid has it
  auto const take_motion = [&] {
    z.resize(r.size());
    by_node<3>(z) = size * unpadded<3>(level.z).cast<double>();
  };
  auto const look_beyond_from = [&](Vector& load) {
    border_->exchange(z, at_beyond_);
    subtract_beyond(load);
    for (std::size_t b = 0; b < bordering_.size(); ++b)
      load.segment<3>(3 * bordering_[b]) += share_[b] * z.segment<3>(3 * bordering_[b]);
  };
  auto const each_turn = [&](auto&& turn) {
    for (std::size_t h = 0; held && h < held_.size(); ++h)
      if (own(held_[h].node))
        turn(3 * (held_[h].node - begin_), turns_[h]);
  };
  unpadded<3>(level.r) = (1 / size * by_node<3>(r)).cast<float>();
  level.forwards();
  take_motion();
  rest_.resize(r.size());
  by_node<3>(rest_) = size * unpadded<3>(level.rest).cast<double>();
  look_beyond_from(rest_);
  each_turn([&](Index at, Matrix3 const& S) {
    rest_.segment<3>(at) = (S.transpose() * rest_.segment<3>(at)).eval();
  });
  coarse_->correct(rest_, held, lifted_);
  each_turn(
      [&](Index at, Matrix3 const& S) { lifted_.segment<3>(at) = (S * lifted_.segment<3>(at)).eval(); });
  z += lifted_;
  load_ = r;
  look_beyond_from(load_);
  unpadded<3>(level.r) = (1 / size * by_node<3>(load_)).cast<float>();
  unpadded<3>(level.z) = (1 / size * by_node<3>(z)).cast<float>();
  level.backwards();
  take_motion();
}

} // namespace stiction::linear
