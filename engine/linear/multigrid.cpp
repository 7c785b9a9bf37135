// Aggregates of nodes, prolongators smoothed from rigid-body modes, Galerkin products and the V cycle.
#include "linear/multigrid.hpp"

#include "linear/decompositions.hpp"
#include "linear/single_level.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace stiction::linear {

namespace level {

template<int B> using Square = Eigen::Matrix<double, B, B>;

/// A level as it is set up, and as cycles see it.
template<int B> struct Level {
  BlockMatrix<B, B> const* A = nullptr;
  BlockMatrix<B, B> own;          ///< of all but the first
  std::vector<HeldNode> held;     ///< of the first level alone
  Indices own_block;              ///< [nodes], the diagonal ones
  std::vector<Square<B>> inverse; ///< of the diagonal blocks
  BlockMatrix<B, coarse> P;
  SingleLevel<B> single;
};

} // namespace level

namespace {

using namespace level;

constexpr Index few = 100;         ///< coarse nodes that are factored at once
constexpr double strong = 0.02;    ///< of the geometric mean of the diagonal blocks
constexpr double dependent = 1e-8; ///< of a mode's length, left after the others are taken out
constexpr double regular = 1e-6;   ///< pivot over the largest diagonal, from which on there is an inverse
constexpr int powers = 12;
constexpr std::size_t most_levels = 20;
constexpr Index few_in_slab = 64; ///< coarse nodes that one thread does best

/// Pseudo-inverse of a symmetric block.
template<int B> Square<B> inverse_of(Square<B> const& block) {
  if (Eigen::LLT<Square<B>> const factor(block);
      factor.info() == Eigen::Success &&
      factor.matrixLLT().diagonal().cwiseAbs2().minCoeff() > regular * block.diagonal().maxCoeff())
    return factor.solve(Square<B>::Identity());
  return pseudo_inverse(block);
}

template<int B> Square<B> diagonal_block(Level<B> const& level, Index i) {
  return level.A->block(level.own_block[ix(i)]);
}

template<int B> void invert_diagonal(Level<B>& level) {
  level.inverse.resize(ix(level.A->rows()));
  level.own_block.resize(level.inverse.size());
  each_row(level.A->rows(), [&](Index i) {
    level.own_block[ix(i)] = level.A->find(i, i);
    level.inverse[ix(i)] = inverse_of<B>(diagonal_block(level, i));
  });
}

/// Largest eigenvalue of D^-1 A, from below, by powers.
template<int B> double largest_eigenvalue(Level<B> const& level) {
  Vector x(B * level.A->rows()), y;
  for (Index i = 0; i < x.size(); ++i) // of all wave lengths
    x[i] = 0.5 + std::fmod(0.6180339887498949 * (i + 1), 1.0);
  double value = 1;
  for (int k = 0; k < powers; ++k) {
    x /= x.norm();
    y.setZero(x.size());
    add_product(*level.A, x, y);
    each_row(level.A->rows(),
             [&](Index i) { y.segment<B>(B * i) = level.inverse[ix(i)] * y.segment<B>(B * i); });
    value = y.norm();
    x.swap(y);
  }
  return value;
}

/// Neighbours that a node is strongly coupled with.
template<int B> std::vector<Indices> strong_neighbours(BlockMatrix<B, B> const& A) {
  Index const n = A.rows();
  Vector size(n);
  each_row(n, [&](Index i) { size[i] = A.block(A.find(i, i)).norm(); });
  std::vector<Indices> near(ix(n));
  each_row(n, [&](Index i) {
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
      if (Index const j = A.column[ix(k)];
          j != i && A.block(k).squaredNorm() > strong * strong * size[i] * size[j])
        near[ix(i)].push_back(j);
  });
  return near;
}

/// Aggregate of each node, -1 for one that is coupled with none.
struct Aggregates {
  Indices of;
  Index count = 0;
};

/// number: of the nodes in the order in which they are to be visited, or empty.
Aggregates aggregate(std::vector<Indices> const& near, Indices const& number) {
  Indices visited = number;
  if (visited.empty()) {
    visited.resize(near.size());
    std::iota(visited.begin(), visited.end(), 0);
  }
  Aggregates all;
  all.of.assign(near.size(), -1);
  auto const taken = [&](Index j) { return all.of[ix(j)] >= 0; };
  auto const start = [&](Index i) {
    all.of[ix(i)] = all.count;
    for (Index const j : near[ix(i)])
      if (!taken(j))
        all.of[ix(j)] = all.count;
    ++all.count;
  };
  for (Index const i : visited)
    if (!near[ix(i)].empty() && !taken(i) && std::none_of(near[ix(i)].begin(), near[ix(i)].end(), taken))
      start(i);
  Indices const first = all.of;
  for (Index const i : visited)
    for (std::size_t k = 0; k < near[ix(i)].size() && !taken(i); ++k)
      all.of[ix(i)] = first[ix(near[ix(i)][k])];
  for (Index const i : visited)
    if (!near[ix(i)].empty() && !taken(i))
      start(i);
  return all;
}

/// Q R = Q, with orthonormal or zero columns of Q.
Square<coarse> orthonormalise(Dense& Q) {
  Square<coarse> R = Square<coarse>::Zero();
  for (int c = 0; c < coarse; ++c) {
    double const length = Q.col(c).norm();
    for (int twice = 0; twice < 2; ++twice)
      for (int d = 0; d < c; ++d) {
        double const part = Q.col(d).dot(Q.col(c));
        R(d, c) += part;
        Q.col(c) -= part * Q.col(d);
      }
    double const left = Q.col(c).norm();
    bool const independent = left > dependent * length;
    R(c, c) = independent ? left : 0;
    Q.col(c) *= independent ? 1 / left : 0;
  }
  return R;
}

/// Orthogonal columns that span the modes on each aggregate; the modes of the coarse nodes.
template<int B>
BlockMatrix<B, coarse> tentative(Aggregates const& aggregates, Dense const& modes, Dense& coarse_modes) {
  auto const n = static_cast<Index>(aggregates.of.size());
  std::vector<Indices> members(ix(aggregates.count));
  for (Index i = 0; i < n; ++i)
    if (aggregates.of[ix(i)] >= 0)
      members[ix(aggregates.of[ix(i)])].push_back(i);
  Dense all = Dense::Zero(B * n, coarse), local;
  coarse_modes.setZero(coarse * aggregates.count, coarse);
  for (Index a = 0; a < aggregates.count; ++a) {
    auto const& own = members[ix(a)];
    local.resize(B * static_cast<Index>(own.size()), coarse);
    for (std::size_t k = 0; k < own.size(); ++k)
      local.middleRows<B>(B * static_cast<Index>(k)) = modes.middleRows<B>(B * own[k]);
    coarse_modes.middleRows<coarse>(coarse * a) = orthonormalise(local);
    for (std::size_t k = 0; k < own.size(); ++k)
      all.middleRows<B>(B * own[k]) = local.middleRows<B>(B * static_cast<Index>(k));
  }
  BlockMatrix<B, coarse> P;
  P.columns = aggregates.count;
  for (Index i = 0; i < n; ++i) {
    if (Index const a = aggregates.of[ix(i)]; a >= 0) {
      P.column.push_back(a);
      Eigen::Matrix<double, B, coarse> const block = all.middleRows<B>(B * i);
      P.values.insert(P.values.end(), block.data(), block.data() + B * coarse);
    }
    P.end_row();
  }
  return P;
}

/// (1 - omega D^-1 A) P
template<int B> BlockMatrix<B, coarse> smoothed(Level<B> const& level, BlockMatrix<B, coarse> const& P) {
  double const omega = 4.0 / 3.0 / largest_eigenvalue(level);
  auto S = product(*level.A, P);
  each_row(S.rows(), [&](Index i) {
    for (Index k = S.starts[ix(i)]; k < S.starts[ix(i) + 1]; ++k)
      S.block(k) = -omega * (level.inverse[ix(i)] * S.block(k)).eval();
    for (Index k = P.starts[ix(i)]; k < P.starts[ix(i) + 1]; ++k)
      S.block(S.find(i, P.column[ix(k)])) += P.block(k);
  });
  return S;
}

/// The prolongation of a level; its modes become those of the next one. False if that has no fewer nodes.
template<int B> bool prepare(Level<B>& level, Dense& modes) {
  Dense coarse_modes;
  auto const aggregates = aggregate(strong_neighbours(*level.A), level.single.waves.number);
  level.P = smoothed(level, tentative<B>(aggregates, modes, coarse_modes));
  modes = std::move(coarse_modes);
  return level.P.columns > 0 && level.P.columns < level.A->rows();
}

/// P^T A P, as symmetric as A.
template<int B> BlockMatrix<coarse, coarse> matrix_below(Level<B> const& level) {
  return mirrored(
      product(transposed(level.P, columns_of(level.P)), product(*level.A, level.P), Triangles::left));
}

/// The matrix of the next level, its nodes numbered in waves.
template<int B> void make_next(Level<B>& level, Dense& modes, Level<coarse>& next) {
  next.own = matrix_below(level);
  auto made = waves_of(next.own, {std::max(few_in_slab, next.own.rows() / 16), 2});
  next.own = renumbered(next.own, &made.order, made.waves.number);
  level.P = renumbered(level.P, nullptr, made.waves.number);
  Dense const old = modes;
  for (std::size_t k = 0; k < made.order.size(); ++k)
    modes.middleRows<coarse>(coarse * static_cast<Index>(k)) = old.middleRows<coarse>(coarse * made.order[k]);
  next.single.waves = std::move(made.waves);
}

/// What cycles need of a level that is set up.
template<int B> void hand_over(Level<B>& level) {
  level.single.take_matrix(*level.A);
  each_row(level.A->rows(), [&](Index i) { level.single.set_inverse(i, level.inverse[ix(i)]); });
  level.single.take_prolongation(level.P);
}

} // namespace

struct Multigrid::Levels {
  Level<3> finest;
  std::vector<Level<coarse>> coarser;
  Dense modes;                   ///< of the first coarse level
  BlockMatrix<3, coarse> free_P; ///< P of the finest where nothing is held
  Eigen::LLT<Dense> last;

  Levels& operator=(Levels const&) = delete;
  Levels() = default;
  ~Levels() = default;
  Levels(Levels const& other)
      : finest(other.finest), coarser(other.coarser), modes(other.modes), free_P(other.free_P),
        last(other.last) {
    for (auto& level : coarser)
      level.A = &level.own;
  }
  /// All that follows from the matrix of the first coarse level; with aggregates and prolongators as they are
  /// once it has changed.
  void make_coarser();
  void follow();
  void factor_last();
  using Rows = Eigen::Matrix<double, 3, coarse>;
  void change(HeldNode const* was, HeldNode const* is);
  [[nodiscard]] std::vector<std::pair<Index, Rows>> around(Index i) const;
  /// z of the level is found from r, which is used up.
  template<int B> void cycle(SingleLevel<B>& level, std::size_t below) {
    auto& down = coarser[below].single;
    level.forwards();
    level.restrict_to(down.r);
    if (below + 1 == coarser.size())
      solve_last(down);
    else
      cycle(down, below + 1);
    level.add_prolonged(down.z);
    level.backwards();
  }
  void solve_last(SingleLevel<coarse>& level) const {
    Dense b = unpadded<coarse>(level.r).template cast<double>();
    Eigen::Map<Vector> all(b.data(), b.size());
    last.solveInPlace(all);
    unpadded<coarse>(level.z) = b.cast<float>();
  }
};

Multigrid::Multigrid() = default;
Multigrid::Multigrid(Multigrid const& other)
    : levels_(other.levels_ ? std::make_unique<Levels>(*other.levels_) : nullptr) {}
Multigrid& Multigrid::operator=(Multigrid const& other) {
  return *this = Multigrid(other);
}
Multigrid::Multigrid(Multigrid&&) noexcept = default;
Multigrid& Multigrid::operator=(Multigrid&&) noexcept = default;
Multigrid::~Multigrid() = default;

void Multigrid::Levels::make_coarser() {
  coarser.resize(1);
  Dense now = modes;
  for (std::size_t k = 0; k < most_levels; ++k) {
    auto& level = coarser[k];
    level.A = &level.own;
    if (level.own.rows() <= few)
      break;
    invert_diagonal(level);
    if (!prepare(level, now))
      break;
    make_next(level, now, coarser.emplace_back());
    hand_over(level);
  }
  factor_last();
}

void Multigrid::Levels::follow() {
  for (std::size_t k = 0; k + 1 < coarser.size(); ++k) {
    auto& level = coarser[k];
    invert_diagonal(level);
    hand_over(level);
    coarser[k + 1].own = matrix_below(level);
  }
  factor_last();
}

void Multigrid::Levels::factor_last() {
  auto const& end = coarser.back().own;
  for (auto* vector : {&coarser.back().single.r, &coarser.back().single.z})
    vector->setZero(lanes<coarse> * end.rows());
  Dense all = Dense::Zero(coarse * end.rows(), coarse * end.rows());
  for (Index i = 0; i < end.rows(); ++i)
    for (Index k = end.starts[ix(i)]; k < end.starts[ix(i) + 1]; ++k)
      all.block<coarse, coarse>(coarse * i, coarse * end.column[ix(k)]) = end.block(k);
  all.diagonal().array() += 1e-12 * all.diagonal().maxCoeff();
  last.compute(all);
}

void Multigrid::set_up(BlockMatrix<3, 3> const& A, Dense const& modes, Waves const& waves) {
  levels_ = std::make_unique<Levels>();
  auto& finest = levels_->finest;
  finest.A = &A;
  finest.single.waves = waves;
  invert_diagonal(finest);
  levels_->coarser.reserve(most_levels + 1);
  levels_->modes = modes;
  static_cast<void>(prepare(finest, levels_->modes));
  make_next(finest, levels_->modes, levels_->coarser.emplace_back());
  levels_->free_P = finest.P;
  hand_over(finest);
  levels_->make_coarser();
}

/// P of one node becomes that of its new stiffness, and the coarse matrix follows: with d the change of P
/// there, it gains d^T A P + P^T A d + d^T A d, and the change of P^T stiffness P.
void Multigrid::Levels::change(HeldNode const* was, HeldNode const* is) {
  Index const i = is != nullptr ? is->node : was->node;
  auto& P = finest.P;
  auto& next = coarser.front().own;
  Matrix3 const own = diagonal_block(finest, i);
  Matrix3 const before = was != nullptr ? was->stiffness : Matrix3::Zero(),
                after = is != nullptr ? is->stiffness : Matrix3::Zero();
  finest.inverse[ix(i)] = inverse_of<3>(own + after);
  finest.single.set_inverse(i, finest.inverse[ix(i)]);
  Matrix3 const free = is != nullptr ? Matrix3(finest.inverse[ix(i)] * own) : Matrix3::Identity();
  Indices const columns(P.column.begin() + P.starts[ix(i)], P.column.begin() + P.starts[ix(i) + 1]);
  std::vector<Rows> d, old;
  for (Index k = P.starts[ix(i)]; k < P.starts[ix(i) + 1]; ++k) {
    old.emplace_back(P.block(k));
    P.block(k) = free * free_P.block(k);
    finest.single.set_prolongation(k, P.block(k));
    d.emplace_back(P.block(k) - old.back());
  }
  for (std::size_t a = 0; a < columns.size(); ++a)
    for (std::size_t b = 0; b < columns.size(); ++b)
      next.block(next.find(columns[a], columns[b])) +=
          (old[a] + d[a]).transpose() * (own + after) * (old[b] + d[b]) -
          old[a].transpose() * (own + before) * old[b];
  for (auto const& [column, AP] : around(i))
    for (std::size_t a = 0; a < columns.size(); ++a) {
      Square<coarse> const more = d[a].transpose() * AP;
      next.block(next.find(columns[a], column)) += more;
      next.block(next.find(column, columns[a])) += more.transpose();
    }
}

/// Row i of A P without the diagonal block of A.
std::vector<std::pair<Index, Multigrid::Levels::Rows>> Multigrid::Levels::around(Index i) const {
  auto const& A = *finest.A;
  auto const& P = finest.P;
  std::vector<std::pair<Index, Rows>> sums;
  for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k) {
    Index const j = A.column[ix(k)];
    for (Index l = P.starts[ix(j)]; l < P.starts[ix(j) + 1] && j != i; ++l) {
      auto sum = std::ranges::find(sums, P.column[ix(l)], &std::pair<Index, Rows>::first);
      if (sum == sums.end())
        sum = sums.insert(sum, {P.column[ix(l)], Rows::Zero()});
      sum->second.noalias() += A.block(k) * P.block(l);
    }
  }
  return sums;
}

void Multigrid::hold(std::vector<HeldNode> held) {
  auto& now = levels_->finest.held;
  if (held == now)
    return;
  auto old = now.begin();
  auto const release = [&](Index until) {
    for (; old != now.end() && old->node < until; ++old)
      levels_->change(&*old, nullptr);
  };
  for (auto const& one : held) {
    release(one.node);
    bool const had = old != now.end() && old->node == one.node;
    if (!had || !(*old == one))
      levels_->change(had ? &*old : nullptr, &one);
    old += had ? 1 : 0;
  }
  release(std::numeric_limits<Index>::max());
  now = std::move(held);
  levels_->follow();
}

void Multigrid::cycle(Vector const& r, Vector& z) {
  auto& finest = levels_->finest.single;
  double const size = r.lpNorm<Eigen::Infinity>(); // keeps what is small within single precision's range
  z.setZero(r.size());
  if (!(size > 0))
    return;
  unpadded<3>(finest.r) = (1 / size * by_node<3>(r)).cast<float>();
  levels_->cycle(finest, 0);
  by_node<3>(z) = size * unpadded<3>(finest.z).cast<double>();
}

double Multigrid::complexity() const {
  auto const first = static_cast<double>(levels_->finest.A->values.size());
  double sum = first;
  for (auto const& level : levels_->coarser)
    sum += static_cast<double>(level.own.values.size());
  return sum / first;
}

std::size_t Multigrid::levels() const {
  return 1 + levels_->coarser.size();
}

double Multigrid::numbers() const {
  if (!levels_)
    return 0;
  auto sum = static_cast<double>(levels_->finest.P.values.size() + 9 * levels_->finest.inverse.size());
  for (auto const& level : levels_->coarser)
    sum += static_cast<double>(level.own.values.size() + level.P.values.size());
  return sum;
}

} // namespace stiction::linear
