// Each rank solves with its own nodes' rows; right-hand sides come whole, and motions are gathered.
#include "linear/rank_factor.hpp"

#include <Eigen/LU>
#include <bit>
#include <limits>

#include "core/error.hpp"
#include "linear/held_points.hpp"
#include "linear/krylov.hpp"
#include "linear/multigrid_factor.hpp"
#include "linear/rank_multigrid.hpp"

namespace stiction::linear {

namespace {

constexpr double stored_by_ranks = 3; ///< numbers over those of the matrix: it and both hierarchies

/// Vectors of which each rank has its own nodes' part.
struct SharedVectors : KeptWhole {
  explicit SharedVectors(Ranks const* its) : ranks(its) {}
  Ranks const* ranks;
  [[nodiscard]] double inner(Vector const& a, Vector const& b) const { return ranks->sum(a.dot(b)); }
  [[nodiscard]] double length(Vector const& a) const { return std::sqrt(ranks->sum(a.squaredNorm())); }
  [[nodiscard]] bool zero(Vector const& a) const { return ranks->largest(a.isZero(0) ? 0 : 1) == 0; }
};

class RankFactor : public BulkFactor, public CoupledBulk {
public:
  RankFactor(std::shared_ptr<Pattern const> pattern, Index surface,
             std::shared_ptr<UnknownsOfRanks const> nodes, Ranks const& ranks)
      : BulkFactor(surface), pattern_(std::move(pattern)), nodes_(std::move(nodes)), ranks_(&ranks),
        begin_(nodes_->first[ix(ranks.rank())]), end_(nodes_->first[ix(ranks.rank() + 1)]),
        multigrid_(ranks, nodes_->first) {
    for (Index const first : nodes_->first)
      first_number_.push_back(3 * first);
    shape_blocks();
  }
  [[nodiscard]] std::unique_ptr<BulkFactor> another() const override {
    return std::make_unique<RankFactor>(pattern_, surface(), nodes_, *ranks_);
  }
  [[nodiscard]] Pattern const& pattern() const override { return *pattern_; }
  [[nodiscard]] Effort effort() const override {
    double const numbers = ranks_numbers_;
    return {stored_by_ranks * numbers, multigrid_effort(numbers).operations};
  }
  [[nodiscard]] double surface_numbers() const override { return 0; }
  [[nodiscard]] CoupledBulk* coupled() override { return this; }

  [[nodiscard]] Vector condense(Vector& b) override {
    agree(b);
    alone_ = solved(scattered(b), alone_);
    b = gathered(alone_);
    return b.tail(surface());
  }
  void expand(Vector const& surface_load, Vector& b) override { b += gathered(motion_of(surface_load)); }
  void compliance(Indices const& used, Dense& C) override {
    auto const n = static_cast<Index>(used.size());
    C.resize(n, n);
    for (Index j = 0; j < n; ++j) {
      Vector load = Vector::Zero(pattern().size());
      load[first_of_surface() + used[ix(j)]] = 1;
      Vector const motion = gathered(solved(scattered(load), {}));
      for (Index i = 0; i < n; ++i)
        C(i, j) = motion[first_of_surface() + used[ix(i)]];
    }
    spend(n, 0);
  }
  [[nodiscard]] std::shared_ptr<Carried const> carried() const override {
    Vector all;
    if (motion_.size() > 0)
      ranks_->gather(motion_, first_number_, all);
    return std::make_shared<Carried const>(Carried{{}, load_, std::move(all)});
  }
  void carry_on(Carried const* what) override {
    alone_.resize(0);
    load_ = what != nullptr ? what->load : Vector();
    motion_ = what != nullptr && what->motion.size() > 0
                  ? Vector(what->motion.segment(3 * begin_, 3 * (end_ - begin_)))
                  : Vector();
  }

  void couple(SurfaceRows rows) override { rows_ = std::move(rows); }
  void add_motion(Vector const& p, Eigen::Ref<Vector> x) override {
    Vector load = Vector::Zero(surface());
    for (auto const& h : rows_.H)
      load[h.column] += rows_.weight * h.value * p[h.row];
    x += everywhere(motion_at_points(motion_of(load)));
  }
  [[nodiscard]] Dense blocks(Index components) const override;
  [[nodiscard]] bool solve(PointLaws const& laws, Vector const& p, double tolerance, Vector& dp,
                           Vector& dx) override;
  void advance(double part) override {
    motion_ += part * change_;
    load_.resize(0);
  }
  using BulkFactor::solve;

protected:
  [[nodiscard]] bool take(std::span<double const> values) override;
  [[nodiscard]] bool add(std::vector<ColumnEntry> columns) override { return columns.empty(); }

private:
  void shape_blocks();
  void agree(Vector const& numbers) const;
  [[nodiscard]] double cycle_operations() const { return cycle_passes * 2 * ranks_numbers_; }
  [[nodiscard]] Index place(Index unknown) const { return nodes_->nodes.place[ix(unknown)]; }
  [[nodiscard]] Index surface_place(Index column) const { return place(first_of_surface() + column); }
  [[nodiscard]] bool own(Index place) const { return place >= 3 * begin_ && place < 3 * end_; }
  /// The part of own nodes of what is known of all unknowns, and back.
  [[nodiscard]] Vector scattered(Vector const& b) const {
    Vector part = Vector::Zero(3 * (end_ - begin_));
    for (Index u = 0; u < b.size(); ++u)
      if (own(place(u)))
        part[place(u) - 3 * begin_] = b[u];
    return part;
  }
  [[nodiscard]] Vector gathered(Vector const& part) const {
    Vector all, b(pattern().size());
    ranks_->gather(part, first_number_, all);
    for (Index u = 0; u < b.size(); ++u)
      b[u] = all[place(u)];
    return b;
  }
  /// Numbers of contact rows, of which each rank has those of its nodes and zeros.
  [[nodiscard]] Vector everywhere(Vector rows) const {
    ranks_->sum(std::span(rows.data(), static_cast<std::size_t>(rows.size())));
    return rows;
  }
  [[nodiscard]] Vector const& motion_of(Vector const& load);
  [[nodiscard]] Vector solved(Vector const& b, Vector u);
  void hold_points(PointLaws const& laws, Dense const& inverse);
  template<class Visit> void each_own(Visit const& visit) const {
    for (auto const& h : rows_.H)
      if (Index const at = surface_place(h.column); own(at))
        visit(h.row, at - 3 * begin_, h.value);
  }
  void add_loads(Vector const& forces, double factor, Eigen::Ref<Vector> u) const {
    each_own(
        [&](Index row, Index at, double value) { u[at] += factor * rows_.weight * value * forces[row]; });
  }
  [[nodiscard]] Vector motion_at_points(Vector const& u) const {
    Vector x = Vector::Zero(rows_.count);
    each_own([&](Index row, Index at, double value) { x[row] += value * u[at]; });
    return x;
  }
  [[nodiscard]] std::vector<bool> own_points(Index components) const;

  std::shared_ptr<Pattern const> pattern_;
  std::shared_ptr<UnknownsOfRanks const> nodes_;
  Ranks const* ranks_;
  Index begin_, end_;    ///< own nodes
  Indices first_number_; ///< [ranks + 1], three a node
  BlockMatrix<3, 3> shape_;
  double ranks_numbers_ = 0; ///< of the matrix on all ranks
  RankMultigrid multigrid_;
  std::vector<double> surface_diagonals_; ///< [surface, 9], blocks of their nodes
  SurfaceRows rows_;
  Vector alone_;  ///< own part: motion of the loads last condensed
  Vector load_;   ///< on the surface, empty where the motion is not quite its
  Vector motion_; ///< own part
  Vector change_; ///< own part, last found
};

/// Whether all ranks were given the same.
void RankFactor::agree(Vector const& numbers) const {
  std::uint64_t sum = 0;
  for (double const number : numbers)
    sum = (std::rotl(sum, 5) ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
  auto const short_sum = static_cast<double>(sum >> 12U);
  core::expect(ranks_->largest(short_sum) == -ranks_->largest(-short_sum),
               "the same numbers on all ranks: do they run on processors of one kind?");
}

/// The blocks of own rows that the pattern fills, and those of the diagonal.
void RankFactor::shape_blocks() {
  std::vector<Indices> near(ix(end_ - begin_));
  for (Index i = begin_; i < end_; ++i)
    near[ix(i - begin_)].push_back(i);
  auto const couple = [&](Index a, Index b) {
    if (a >= begin_ && a < end_ && near[ix(a - begin_)].back() != b)
      near[ix(a - begin_)].push_back(b);
  };
  for (Index j = 0; j < pattern_->size(); ++j)
    for (Index k = pattern_->columns[ix(j)]; k < pattern_->columns[ix(j) + 1]; ++k) {
      Index const a = place(j) / 3, b = place(pattern_->rows[ix(k)]) / 3;
      couple(a, b);
      couple(b, a);
    }
  shape_.columns = nodes_->first.back();
  for (auto& row : near) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    shape_.column.insert(shape_.column.end(), row.begin(), row.end());
    shape_.end_row();
    Indices().swap(row);
  }
  ranks_numbers_ = ranks_->sum(9.0 * static_cast<double>(shape_.column.size()));
}

bool RankFactor::take(std::span<double const> values) {
  BlockMatrix<3, 3> A = shape_;
  A.values.assign(9 * A.column.size(), 0.0);
  Vector diagonal = Vector::Zero(3 * A.rows());
  auto const put = [&](Index a, Index b, double value) {
    if (!own(a))
      return;
    Index const row = a / 3 - begin_;
    A.block(A.find(row, b / 3))(a % 3, b % 3) = value;
    if (a == b)
      diagonal[a - 3 * begin_] = value;
  };
  for (Index j = 0; j < pattern().size(); ++j)
    for (Index k = pattern().columns[ix(j)]; k < pattern().columns[ix(j) + 1]; ++k) {
      Index const a = place(j), b = place(pattern().rows[ix(k)]);
      put(a, b, values[ix(k)]);
      if (a != b)
        put(b, a, values[ix(k)]);
    }
  bool const good = diagonal.allFinite() && (diagonal.array() >= 0).all();
  if (ranks_->largest(good ? 0 : 1) > 0)
    return false;
  double const mean = ranks_->sum(diagonal.sum()) / (3 * nodes_->first.back());
  for (Index a = 0; a < diagonal.size(); ++a) // components that are driven
    if (diagonal[a] == 0)
      A.block(A.find(a / 3, begin_ + a / 3))(a % 3, a % 3) = mean;
  multigrid_.set_up(std::move(A), nodes_->nodes.modes);
  surface_diagonals_.assign(9 * ix(surface()), 0.0);
  for (Index c = 0; c < surface(); ++c)
    if (Index const at = surface_place(c); own(at))
      Eigen::Map<Matrix3>{&surface_diagonals_[9 * ix(c)]} = multigrid_.diagonal(at / 3 - begin_);
  ranks_->sum(surface_diagonals_);
  load_.resize(0);
  return true;
}

Vector RankFactor::solved(Vector const& b, Vector u) {
  SharedVectors const vectors{ranks_};
  bool const nothing = vectors.length(b) == 0;
  bool const start = u.size() > 0 && u.allFinite();
  if (nothing || ranks_->largest(start ? 0 : 1) > 0)
    u = Vector::Zero(b.size());
  if (nothing)
    return u;
  auto const end = conjugate_gradients([&](Vector const& x, Vector& y) { multigrid_.product(x, y); },
                                       [&](Vector const& r, Vector& z) { multigrid_.cycle(r, false, z); }, b,
                                       u, KrylovLimits<SharedVectors>{solved_to, most_for_load, vectors});
  spend(0, end.iterations * cycle_operations());
  if (!end.converged)
    u.setConstant(std::numeric_limits<double>::quiet_NaN());
  return u;
}

/// Of all for a load on the surface alone; the last one is kept, and is where the next begins.
Vector const& RankFactor::motion_of(Vector const& load) {
  if (load_.size() == load.size() && load_ == load)
    return motion_;
  agree(load);
  Vector all = Vector::Zero(3 * (end_ - begin_));
  for (Index c = 0; c < load.size(); ++c)
    if (Index const at = surface_place(c); own(at))
      all[at - 3 * begin_] = load[c];
  motion_ = solved(all, std::move(motion_));
  load_ = load;
  return motion_;
}

Dense RankFactor::blocks(Index components) const {
  Dense all = Dense::Zero(rows_.count, components);
  for (auto const& own : by_point(rows_, components))
    for (auto const& g : own)
      for (auto const& h : own) {
        Index const a = surface_place(g.column), b = surface_place(h.column);
        core::expect(a / 3 == b / 3, "contact points that move one node each");
        Matrix3 const inverse =
            Matrix3(Eigen::Map<Matrix3 const>(&surface_diagonals_[9 * ix(g.column)])).inverse();
        all(g.row, h.row % components) +=
            compliance_in_body * rows_.weight * g.value * h.value * inverse(a % 3, b % 3);
      }
  return all;
}

/// The preconditioner with what the laws' points hold, on all ranks.
void RankFactor::hold_points(PointLaws const& laws, Dense const& inverse) {
  Index const C = static_cast<Index>(laws.A.cols());
  std::vector<HeldNode> points, held;
  Index row = 0;
  for (auto const& own : by_point(rows_, C)) {
    SmallBlock const S = holding(rows_.weight * (inverse.middleRows(row, C) * laws.B.middleRows(row, C)));
    row += C;
    if (own.empty())
      continue;
    HeldNode node{surface_place(own.front().column) / 3, Matrix3::Zero()};
    for (auto const& g : own)
      for (auto const& h : own)
        node.stiffness(surface_place(g.column) % 3, surface_place(h.column) % 3) +=
            g.value * h.value * S(g.row % C, h.row % C);
    points.push_back(node); // if nothing is held there, too: whatever changes has one shape then
  }
  std::ranges::stable_sort(points, {}, &HeldNode::node);
  for (auto const& point : points)
    if (!held.empty() && held.back().node == point.node)
      held.back().stiffness += point.stiffness;
    else
      held.push_back(point);
  multigrid_.hold(std::move(held));
}

/// Of each point, whether its node is own; those that move none are the first rank's.
std::vector<bool> RankFactor::own_points(Index components) const {
  std::vector<bool> all;
  for (auto const& own_rows : by_point(rows_, components))
    all.push_back(own_rows.empty() ? ranks_->rank() == 0 : own(surface_place(own_rows.front().column)));
  return all;
}

bool RankFactor::solve(PointLaws const& laws, Vector const& p, double tolerance, Vector& dp, Vector& dx) {
  Index const n = 3 * (end_ - begin_), m = rows_.count, C = static_cast<Index>(laws.A.cols());
  agree(p);
  agree(laws.right);
  if (motion_.size() != n)
    motion_.setZero(n);
  Dense const inverse = softened(laws, blocks(C));
  if (!inverse.allFinite())
    return false;
  hold_points(laws, inverse);
  Vector mine(m); // 1 in own rows, 0 in those of others
  auto const points = own_points(C);
  for (Index row = 0; row < m; ++row)
    mine[row] = points[ix(row / C)] ? 1 : 0;
  Vector load, z;
  auto const apply = [&](Vector const& v, Vector& w) {
    multigrid_.product(v.head(n), load);
    add_loads(v.tail(m), -1, load);
    w.resize(n + m);
    w.head(n) = load;
    w.tail(m) = by_blocks(laws.A, v.tail(m)) + by_blocks(laws.B, motion_at_points(v.head(n)));
  };
  auto const precondition = [&](Vector const& v, Vector& w) {
    load = v.head(n);
    add_loads(by_blocks(inverse, v.tail(m)), 1, load);
    multigrid_.cycle(load, true, z);
    w.resize(n + m);
    w.head(n) = z;
    w.tail(m) = by_blocks(inverse, v.tail(m) - by_blocks(laws.B, motion_at_points(z)));
  };
  Vector right(n + m), both;
  multigrid_.product(motion_, load);
  add_loads(p, -1, load);
  right.head(n) = -load;
  right.tail(m) = laws.right.cwiseProduct(mine);
  auto const end = gmres(apply, precondition, right, both,
                         KrylovLimits<SharedVectors>{tolerance, most_coupled, SharedVectors(ranks_)});
  spend(0, end.iterations * cycle_operations());
  change_ = both.head(n);
  dp = everywhere(both.tail(m));
  dx = everywhere(motion_at_points(change_));
  return ranks_->largest(both.allFinite() ? 0 : 1) == 0;
}

} // namespace

std::unique_ptr<BulkFactor> make_rank_factor(Pattern pattern, Index surface, UnknownsOfRanks nodes,
                                             Ranks const& ranks) {
  return std::make_unique<RankFactor>(std::make_shared<Pattern const>(std::move(pattern)), surface,
                                      std::make_shared<UnknownsOfRanks const>(std::move(nodes)), ranks);
}

} // namespace stiction::linear
