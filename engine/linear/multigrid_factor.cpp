// Loads by conjugate gradients; contact together with the bulk by GMRES, with the points' stiffness in the
// preconditioner.
#include "linear/multigrid_factor.hpp"

#include <Eigen/LU>
#include <limits>

#include "linear/held_points.hpp"
#include "linear/krylov.hpp"
#include "linear/multigrid.hpp"
#include "linear/symmetric_product.hpp"

namespace stiction::linear {

namespace {

/// Of a block of hexahedra, over the numbers of its matrix: matrix and both hierarchies; twice-passes to set
/// up.
constexpr double stored = 3.8, set_up_passes = 30;
constexpr Index few_nodes_in_slab = 500; ///< nodes that one thread does best
constexpr std::size_t remembered = 2;    ///< answers of earlier steps
constexpr double independent = 1e-16;    ///< part of a motion's energy that has to be its own

/// A load and the motion of all that it causes.
struct Answered {
  Vector load, motion;
};

/// Loads on the surface end to end, and motions.
Carried packed(std::vector<Answered> const& all) {
  Carried carried;
  for (auto const& [load, motion] : all) {
    carried.load.conservativeResize(carried.load.size() + load.size());
    carried.load.tail(load.size()) = load;
    carried.motion.conservativeResize(carried.motion.size() + motion.size());
    carried.motion.tail(motion.size()) = motion;
  }
  return carried;
}

std::vector<Answered> unpacked(Carried const& carried, Index surface) {
  auto const count = surface > 0 ? carried.load.size() / surface : 0;
  std::vector<Answered> all;
  all.reserve(static_cast<std::size_t>(count));
  for (auto k = 0; k < count; ++k)
    all.push_back(
        {carried.load.segment(k * surface, surface),
         carried.motion.segment(k * (carried.motion.size() / count), carried.motion.size() / count)});
  return all;
}

class MultigridFactor : public BulkFactor, public CoupledBulk {
public:
  MultigridFactor(Pattern pattern, Index surface, NodesOfUnknowns nodes)
      : BulkFactor(surface), pattern_(std::make_shared<Pattern const>(std::move(pattern))) {
    shape_blocks(nodes);
    number_in_waves(std::move(nodes));
    shape_blocks(*nodes_);
  }
  MultigridFactor(MultigridFactor const& like, int /*another*/)
      : BulkFactor(like.surface()), pattern_(like.pattern_), nodes_(like.nodes_), waves_(like.waves_) {
    shape_blocks(*nodes_);
  }
  [[nodiscard]] std::unique_ptr<BulkFactor> another() const override {
    return std::make_unique<MultigridFactor>(*this, 0);
  }
  [[nodiscard]] Pattern const& pattern() const override { return *pattern_; }
  [[nodiscard]] Effort effort() const override {
    return multigrid_effort(9 * static_cast<double>(A_.column.size()));
  }
  [[nodiscard]] double surface_numbers() const override { return 0; }
  [[nodiscard]] CoupledBulk* coupled() override { return this; }

  [[nodiscard]] Vector condense(Vector& b) override {
    Vector load = scattered(b);
    alone_ = solved(load, nearest(load));
    alone_load_ = std::move(load);
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
    spend(n, 0); // the operations are those of the loads
  }

  [[nodiscard]] std::shared_ptr<Carried const> carried() const override {
    auto all = earlier_;
    if (load_.size() > 0)
      all.insert(all.begin(), {load_, motion_});
    all.resize(std::min(all.size(), remembered));
    return std::make_shared<Carried const>(packed(all));
  }
  void carry_on(Carried const* what) override {
    alone_.resize(0);
    earlier_ = what != nullptr ? unpacked(*what, surface()) : std::vector<Answered>();
    load_ = !earlier_.empty() ? earlier_.front().load : Vector();
    motion_ = !earlier_.empty() ? earlier_.front().motion : Vector();
    if (std::exchange(holds_, false)) // changes of what is held add up roundings
      held_ = plain_;
  }

  void couple(SurfaceRows rows) override { rows_ = std::move(rows); }
  void add_motion(Vector const& p, Eigen::Ref<Vector> x) override {
    auto const& u = motion_of(surface_load(p));
    for (auto const& h : rows_.H)
      x[h.row] += h.value * u[surface_place(h.column)];
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
  void shape_blocks(NodesOfUnknowns const& nodes);
  void number_in_waves(NodesOfUnknowns nodes);
  [[nodiscard]] double cycle_operations() const {
    return cycle_passes * 2 * static_cast<double>(A_.values.size());
  }
  [[nodiscard]] Index surface_place(Index column) const {
    return nodes_->place[ix(first_of_surface() + column)];
  }
  [[nodiscard]] Vector scattered(Vector const& b) const {
    Vector all = Vector::Zero(3 * A_.rows());
    for (Index u = 0; u < b.size(); ++u)
      all[nodes_->place[ix(u)]] = b[u];
    return all;
  }
  [[nodiscard]] Vector gathered(Vector const& all) const {
    Vector b(pattern().size());
    for (Index u = 0; u < b.size(); ++u)
      b[u] = all[nodes_->place[ix(u)]];
    return b;
  }
  [[nodiscard]] Vector surface_load(Vector const& p) const {
    Vector load = Vector::Zero(surface());
    for (auto const& h : rows_.H)
      load[h.column] += rows_.weight * h.value * p[h.row];
    return load;
  }
  [[nodiscard]] Vector on_surface(Vector const& load) const {
    Vector all = Vector::Zero(3 * A_.rows());
    for (Index c = 0; c < load.size(); ++c)
      all[surface_place(c)] = load[c];
    return all;
  }
  [[nodiscard]] Vector const& motion_of(Vector const& load);
  [[nodiscard]] Vector nearest(Vector const& b) const;
  [[nodiscard]] Vector solved(Vector const& b, Vector u);
  void add_held(std::vector<SurfaceEntry> const& own, SmallBlock const& S,
                std::vector<Matrix3>& stiffness) const;
  void hold_points(PointLaws const& laws, Dense const& inverse);
  void add_loads(Vector const& forces, double factor, Vector& u) const {
    for (auto const& h : rows_.H)
      u[surface_place(h.column)] += factor * rows_.weight * h.value * forces[h.row];
  }
  [[nodiscard]] Vector motion_at_points(Vector const& u) const {
    Vector at = Vector::Zero(rows_.count);
    for (auto const& h : rows_.H)
      at[h.row] += h.value * u[surface_place(h.column)];
    return at;
  }

  std::shared_ptr<Pattern const> pattern_;
  std::shared_ptr<NodesOfUnknowns const> nodes_; ///< in waves
  Waves waves_;
  BlockMatrix<3, 3> A_;
  SymmetricProduct product_; ///< with A_
  Multigrid plain_, held_;
  bool holds_ = false; ///< has held_ been changed since it was plain_?
  SurfaceRows rows_;
  Vector alone_load_, alone_;     ///< the loads last condensed and their motion, of all
  Vector load_, motion_;          ///< on the surface, empty where the motion is not quite its; of all
  std::vector<Answered> earlier_; ///< by the same matrix in earlier steps
  Vector change_;                 ///< of the motion, last found
};

/// The blocks that the pattern fills, and those of the diagonal.
void MultigridFactor::shape_blocks(NodesOfUnknowns const& nodes) {
  A_ = {};
  Index const n = static_cast<Index>(nodes.modes.rows()) / 3;
  std::vector<Indices> near(ix(n));
  for (Index i = 0; i < n; ++i)
    near[ix(i)].push_back(i);
  for (Index j = 0; j < pattern_->size(); ++j)
    for (Index k = pattern_->columns[ix(j)]; k < pattern_->columns[ix(j) + 1]; ++k) {
      Index const a = nodes.place[ix(j)] / 3, b = nodes.place[ix(pattern_->rows[ix(k)])] / 3;
      if (near[ix(a)].back() != b)
        near[ix(a)].push_back(b);
      if (near[ix(b)].back() != a)
        near[ix(b)].push_back(a);
    }
  A_.columns = n;
  for (auto& row : near) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    A_.column.insert(A_.column.end(), row.begin(), row.end());
    A_.end_row();
    Indices().swap(row);
  }
}

/// Takes other numbers for the nodes, with which many of them are smoothed at the same time.
void MultigridFactor::number_in_waves(NodesOfUnknowns nodes) {
  auto made = waves_of(A_, {std::max(few_nodes_in_slab, A_.rows() / 24), 2});
  Dense const modes = nodes.modes;
  for (std::size_t k = 0; k < made.order.size(); ++k)
    nodes.modes.middleRows<3>(3 * static_cast<Index>(k)) = modes.middleRows<3>(3 * made.order[k]);
  for (Index& place : nodes.place)
    place = 3 * made.waves.number[ix(place / 3)] + place % 3;
  waves_ = std::move(made.waves);
  nodes_ = std::make_shared<NodesOfUnknowns const>(std::move(nodes));
}

bool MultigridFactor::take(std::span<double const> values) {
  A_.values.assign(9 * A_.column.size(), 0.0);
  Vector own = Vector::Zero(3 * A_.rows());
  each_row(pattern().size(), [&](Index j) {
    for (Index k = pattern().columns[ix(j)]; k < pattern().columns[ix(j) + 1]; ++k) {
      Index const a = nodes_->place[ix(j)], b = nodes_->place[ix(pattern().rows[ix(k)])];
      double const value = values[ix(k)];
      A_.block(A_.find(a / 3, b / 3))(a % 3, b % 3) = value;
      A_.block(A_.find(b / 3, a / 3))(b % 3, a % 3) = value;
      if (a == b)
        own[a] = value;
    }
  });
  if (!own.allFinite())
    return false;
  double const mean = own.mean();
  for (Index a = 0; a < own.size(); ++a) // components that are driven
    if (own[a] == 0)
      A_.block(A_.find(a / 3, a / 3))(a % 3, a % 3) = mean;
    else if (own[a] < 0)
      return false;
  earlier_.clear();
  product_.take(A_, waves_);
  plain_.set_up(A_, nodes_->modes, waves_);
  held_ = plain_;
  holds_ = false;
  load_.resize(0);
  return true;
}

Vector MultigridFactor::solved(Vector const& b, Vector u) {
  if (b.isZero(0) || u.size() == 0 || !u.allFinite())
    u = Vector::Zero(b.size());
  if (b.isZero(0))
    return u;
  auto const apply = [&](Vector const& x, Vector& y) { product_(x, y); };
  auto const end = conjugate_gradients(apply, [&](Vector const& r, Vector& z) { plain_.cycle(r, z); }, b, u,
                                       {solved_to, most_for_load});
  spend(0, end.iterations * cycle_operations());
  if (!end.converged)
    u.setConstant(std::numeric_limits<double>::quiet_NaN());
  return u;
}

/// Among combinations of motions that are known the one that comes nearest in energy to that of b (Fischer
/// 1998). Under steady driving the loads of two steps give that of the next.
Vector MultigridFactor::nearest(Vector const& b) const {
  std::vector<Answered> known; // of all; made orthogonal
  for (auto const& one : earlier_)
    known.push_back({on_surface(one.load), one.motion});
  if (alone_.size() > 0)
    known.push_back({alone_load_, alone_});
  Vector u = Vector::Zero(b.size());
  for (auto one = known.begin(); one != known.end(); ++one) {
    double const whole = one->load.dot(one->motion);
    for (auto other = known.begin(); other != one; ++other) {
      double const part = other->load.dot(one->motion);
      one->load -= part * other->load;
      one->motion -= part * other->motion;
    }
    double const energy = one->load.dot(one->motion);
    double const scale = energy > independent * whole ? 1 / std::sqrt(energy) : 0;
    one->load *= scale;
    one->motion *= scale;
    u += one->motion.dot(b) * one->motion;
  }
  return u;
}

/// Of all for a load on the surface alone; the last one is kept, and is where the next begins.
Vector const& MultigridFactor::motion_of(Vector const& load) {
  if (motion_.size() > 0 && load_.size() == load.size() && load_ == load)
    return motion_;
  motion_ = solved(on_surface(load), std::move(motion_));
  load_ = load;
  return motion_;
}

Dense MultigridFactor::blocks(Index components) const {
  Dense all = Dense::Zero(rows_.count, components);
  for (auto const& own : by_point(rows_, components))
    for (auto const& g : own)
      for (auto const& h : own) {
        Index const a = surface_place(g.column), b = surface_place(h.column);
        if (a / 3 != b / 3)
          continue;
        Matrix3 const inverse = Matrix3(A_.block(A_.find(a / 3, a / 3))).inverse();
        all(g.row, h.row % components) +=
            compliance_in_body * rows_.weight * g.value * h.value * inverse(a % 3, b % 3);
      }
  return all;
}

/// Adds what a point with this stiffness S does to each node that it moves.
void MultigridFactor::add_held(std::vector<SurfaceEntry> const& own, SmallBlock const& S,
                               std::vector<Matrix3>& stiffness) const {
  Index const C = static_cast<Index>(S.rows());
  for (auto const& g : own)
    for (auto const& h : own)
      if (Index const a = surface_place(g.column), b = surface_place(h.column); a / 3 == b / 3)
        stiffness[ix(a / 3)](a % 3, b % 3) += g.value * h.value * S(g.row % C, h.row % C);
}

/// The preconditioner with what the laws' points hold.
void MultigridFactor::hold_points(PointLaws const& laws, Dense const& inverse) {
  Index const C = static_cast<Index>(laws.A.cols());
  std::vector<Matrix3> stiffness(ix(A_.rows()), Matrix3::Zero());
  Index row = 0;
  for (auto const& own : by_point(rows_, C)) {
    add_held(own, holding(rows_.weight * (inverse.middleRows(row, C) * laws.B.middleRows(row, C))),
             stiffness);
    row += C;
  }
  std::vector<HeldNode> held;
  for (Index node = 0; node < A_.rows(); ++node)
    if (!stiffness[ix(node)].isZero(0))
      held.push_back({node, stiffness[ix(node)]});
  held_.hold(std::move(held));
  holds_ = true;
}

bool MultigridFactor::solve(PointLaws const& laws, Vector const& p, double tolerance, Vector& dp,
                            Vector& dx) {
  Index const n = 3 * A_.rows(), m = rows_.count;
  if (motion_.size() != n)
    motion_.setZero(n);
  Dense const inverse = softened(laws, blocks(static_cast<Index>(laws.A.cols())));
  if (!inverse.allFinite())
    return false;
  hold_points(laws, inverse);
  Vector u, load, z;
  auto const apply = [&](Vector const& v, Vector& w) {
    u = v.head(n);
    product_(u, load);
    add_loads(v.tail(m), -1, load);
    w.resize(n + m);
    w.head(n) = load;
    w.tail(m) = by_blocks(laws.A, v.tail(m)) + by_blocks(laws.B, motion_at_points(u));
  };
  auto const precondition = [&](Vector const& v, Vector& w) {
    load = v.head(n);
    add_loads(by_blocks(inverse, v.tail(m)), 1, load);
    held_.cycle(load, z);
    w.resize(n + m);
    w.head(n) = z;
    w.tail(m) = by_blocks(inverse, v.tail(m) - by_blocks(laws.B, motion_at_points(z)));
  };
  Vector right = Vector::Zero(n + m), both;
  product_(motion_, load);
  add_loads(p, -1, load);
  right.head(n) = -load;
  right.tail(m) = laws.right;
  auto const end = gmres(apply, precondition, right, both, {tolerance, most_coupled});
  spend(0, end.iterations * cycle_operations());
  dp = both.tail(m);
  change_ = both.head(n);
  dx = motion_at_points(change_);
  return both.allFinite();
}

} // namespace

Effort multigrid_effort(double numbers) {
  return {stored * numbers, set_up_passes * 2 * numbers};
}

std::unique_ptr<BulkFactor> make_multigrid_factor(Pattern pattern, Index surface, NodesOfUnknowns nodes) {
  return std::make_unique<MultigridFactor>(std::move(pattern), surface, std::move(nodes));
}

} // namespace stiction::linear
