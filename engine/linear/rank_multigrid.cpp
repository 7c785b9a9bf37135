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
  local_.clear();
  for (Index const j : A_.column)
    local_.push_back(own(j) ? j - begin_
                            : end_ - begin_ +
                                  static_cast<Index>(std::ranges::lower_bound(beyond_, j) - beyond_.begin()));
  border_ = ranks_->border({first_, beyond_});
}

void RankMultigrid::set_up(BlockMatrix<3, 3> A, Dense const& modes) {
  bool const same = border_ != nullptr && A.column == A_.column && A.starts == A_.starts;
  A_ = std::move(A);
  if (!same)
    look_beyond();
  Index const n = A_.rows();
  own_block_.resize(ix(n));
  share_beyond_.assign(ix(n), Matrix3::Zero());
  for (Index i = 0; i < n; ++i) {
    own_block_[ix(i)] = A_.find(i, begin_ + i);
    // what makes sweeps within ranks converge (Baker, Falgout, Kolev & Yang 2011)
    for (Index k = A_.starts[ix(i)]; k < A_.starts[ix(i) + 1]; ++k)
      if (local_[ix(k)] >= n)
        share_beyond_[ix(i)].diagonal() += Matrix3(A_.block(k)).cwiseAbs().rowwise().sum();
  }
  held_.clear();
  held_own_.assign(ix(n), Matrix3::Zero());
  invert(held_own_, inverse_);
  held_inverse_ = inverse_;
  coarse_->set_up(A_, modes);
}

void RankMultigrid::invert(std::vector<Matrix3> const& stiffness, std::vector<Matrix3>& inverse) const {
  inverse.resize(stiffness.size());
  for (Index i = 0; i < A_.rows(); ++i)
    inverse[ix(i)] = inverse_of(diagonal(i) + stiffness[ix(i)] + share_beyond_[ix(i)]);
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
    turns_.push_back(inverse_of(own + held[h].stiffness) * own);
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
  invert(held_own_, held_inverse_);
  gather_diagonals(held_);
  coarse_->change(change_of(held_));
}

void RankMultigrid::product(Vector const& x, Vector& y) {
  border_->exchange(x, at_beyond_);
  Index const n = A_.rows();
  y.resize(3 * n);
  for (Index i = 0; i < n; ++i) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Index k = A_.starts[ix(i)]; k < A_.starts[ix(i) + 1]; ++k)
      if (Index const j = local_[ix(k)]; j < n)
        sum.noalias() += A_.block(k) * x.segment<3>(3 * j);
      else
        sum.noalias() += A_.block(k) * at_beyond_.segment<3>(3 * (j - n));
    y.segment<3>(3 * i) = sum;
  }
}

void RankMultigrid::cycle(Vector const& r, bool held, Vector& z) {
  Index const n = A_.rows();
  auto const& inverse = held ? held_inverse_ : inverse_;
  z.resize(r.size());
  for (Index i = 0; i < n; ++i) { // forwards from nothing
    Eigen::Vector3d left = r.segment<3>(3 * i);
    for (Index k = A_.starts[ix(i)]; k < own_block_[ix(i)]; ++k)
      if (Index const j = local_[ix(k)]; j < i)
        left.noalias() -= A_.block(k) * z.segment<3>(3 * j);
    z.segment<3>(3 * i) = inverse[ix(i)] * left;
  }
  product(z, rest_);
  rest_ = r - rest_;
  if (held)
    for (Index i = 0; i < n; ++i)
      rest_.segment<3>(3 * i) -= held_own_[ix(i)] * z.segment<3>(3 * i);
  auto const each_turn = [&](auto&& turn) {
    for (std::size_t h = 0; held && h < held_.size(); ++h)
      if (own(held_[h].node))
        turn(3 * (held_[h].node - begin_), turns_[h]);
  };
  each_turn([&](Index at, Matrix3 const& S) {
    rest_.segment<3>(at) = (S.transpose() * rest_.segment<3>(at)).eval();
  });
  coarse_->correct(rest_, held, lifted_);
  each_turn(
      [&](Index at, Matrix3 const& S) { lifted_.segment<3>(at) = (S * lifted_.segment<3>(at)).eval(); });
  z += lifted_;
  border_->exchange(z, at_beyond_);
  for (Index i = n - 1; i >= 0; --i) { // backwards
    Eigen::Vector3d left = r.segment<3>(3 * i);
    for (Index k = A_.starts[ix(i)]; k < A_.starts[ix(i) + 1]; ++k)
      if (Index const j = local_[ix(k)]; j < n)
        left.noalias() -= A_.block(k) * z.segment<3>(3 * j);
      else
        left.noalias() -= A_.block(k) * at_beyond_.segment<3>(3 * (j - n));
    if (held)
      left.noalias() -= held_own_[ix(i)] * z.segment<3>(3 * i);
    z.segment<3>(3 * i) += inverse[ix(i)] * left;
  }
}

} // namespace stiction::linear
