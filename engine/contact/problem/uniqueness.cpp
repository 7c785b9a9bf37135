// One node has a single answer iff W_nn > mu |W_nt|, one bond iff 1 / W_nn exceeds the fall of its force.
#include "contact/problem/uniqueness.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "contact/problem/held_bonds.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr double bearing_part = 0.01; // of the strength, above which a bond counts as pulled
constexpr int rounds = 30;            // of the power iteration
constexpr double no_pivot = 1e-12;    // over the largest: of a singular matrix

/// A point that friction drags: unit direction of its drag.
template<int D> struct Dragged {
  Index point;
  double mu;
  Eigen::Matrix<double, D - 1, 1> along;
};

template<int D> class Check {
public:
  Check(Problem const& problem, Checked which, Snapped snapped)
      : problem_(problem), which_(which), snapped_(snapped) {}

  Doubts operator()(Vector const& force, Vector const& x) {
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const p = force.segment<D>(D * i), at = x.segment<D>(D * i);
      auto const state = evaluate<D>(problem_, i, p, at, natural_scale(problem_, i));
      if (state.mu > 0 && (which_ == Checked::all || state.status != interface::Status::open))
        look_at_friction(i, state.mu);
      if (state.mu > 0 && !state.dry.template tail<D - 1>().isZero(0))
        look_at_drag(i, state);
      if (problem_.points[ix(i)].adhesion >= 0)
        look_at_bond(i, (p - state.dry)[0]);
    }
    if (doubts_.friction.points == 0)
      look_at_friction_together();
    doubts_.softening.together = together(bonded_);
    if (doubts_.softening.any() && which_ == Checked::bearing)
      if (auto const held = held_bonds(problem_, force, x, snapped_))
        doubts_.softening = *held;
    doubts_.weakening.together = together(weakened_);
    return doubts_;
  }

private:
  void look_at_friction(Index i, double mu) {
    auto const block = problem_.W.block<D>(i);
    double const W_nt = block.row(0).template tail<D - 1>().norm(), W_nn = block(0, 0);
    if (W_nn > mu * W_nt || W_nt == 0)
      return;
    auto& worst = doubts_.friction;
    ++worst.points;
    double const ratio = W_nn > 0 ? mu * W_nt / W_nn : std::numeric_limits<double>::infinity();
    if (worst.worst >= 0 && ratio <= steepest_)
      return;
    steepest_ = ratio;
    worst = {worst.points, 0, i, mu, W_nn, W_nt};
  }

  /// The direction in which friction acts is held: what turns it only adds stiffness.
  void look_at_drag(Index i, PointState<D> const& state) {
    auto const& point = problem_.points[ix(i)];
    dragged_.push_back({i, state.mu, state.dry.template tail<D - 1>().normalized()});
    if (point.friction < 0 || (which_ == Checked::bearing && state.status == interface::Status::open))
      return;
    Yielding<D> drag{i, Local<D>::Zero(), 0};
    drag.along.template tail<D - 1>() = dragged_.back().along;
    drag.fall =
        state.dry[0] * interface::steepest_fall(problem_.frictions[ix(point.friction)], point.bond.dt);
    note(drag, weakened_, doubts_.weakening);
  }

  void look_at_friction_together() {
    auto const n = static_cast<Index>(dragged_.size());
    if (n < 2)
      return;
    Dense matrix(n, n);
    Vector x(problem_.free.size());
    for (Index b = 0; b < n; ++b) {
      auto const& other = dragged_[ix(b)];
      Local<D> load = Local<D>::Unit(0);
      load.template tail<D - 1>() = other.mu * other.along;
      x.setZero();
      problem_.W.add_column<D>(other.point, load, x);
      for (Index a = 0; a < n; ++a)
        matrix(a, b) = x[D * dragged_[ix(a)].point];
    }
    Eigen::PartialPivLU<Dense> const factor(matrix);
    auto const pivots = factor.matrixLU().diagonal().array();
    if (pivots.abs().minCoeff() <= no_pivot * pivots.abs().maxCoeff()) // singular: its sign is rounding's
      return;
    if (((pivots < 0).count() % 2 == 0) == (factor.permutationP().determinant() > 0))
      return;
    auto const& first = dragged_.front();
    auto const row = problem_.W.block<D>(first.point).row(0).eval();
    doubts_.friction = {0, n, first.point, first.mu, row[0], row.template tail<D - 1>().norm()};
  }

  /// `pull`: the bond's normal force, negative where it pulls, N.
  void look_at_bond(Index i, double pull) {
    auto const& point = problem_.points[ix(i)];
    auto const& law = problem_.adhesions[ix(point.adhesion)];
    if (which_ == Checked::bearing && !pulls(i, pull) && !pulled(i))
      return;
    note({i, Local<D>::Unit(0), point.area * interface::steepest_fall(law, point.bond)}, bonded_,
         doubts_.softening);
  }

  /// By more than a small part of its strength?
  [[nodiscard]] bool pulls(Index i, double normal) const {
    auto const& point = problem_.points[ix(i)];
    auto const scales = interface::scales(problem_.adhesions[ix(point.adhesion)]);
    return -normal >= bearing_part * point.area * scales.strength;
  }
  /// Did it at the step's start? Of a bond that snapped nothing is left at the end.
  [[nodiscard]] bool pulled(Index i) const {
    auto const& point = problem_.points[ix(i)];
    if (problem_.start.size() == 0)
      return false;
    auto const at = interface::adhere<D>(problem_.adhesions[ix(point.adhesion)], point.bond,
                                         problem_.start.segment<D>(D * i));
    return pulls(i, point.area * at.traction[0]);
  }

  void note(Yielding<D> const& point, std::vector<Yielding<D>>& all, LeapDoubt& worst) const {
    if (!(point.fall > 0))
      return;
    double const gives = point.along.dot(problem_.W.block<D>(point.point) * point.along);
    if (!(gives > 0))
      return;
    all.push_back(point);
    worst.points += gives * point.fall >= 1 ? 1 : 0;
    if (worst.worst < 0 || gives * point.fall * worst.stiffness > worst.fall) {
      worst.worst = point.point;
      worst.stiffness = 1 / gives;
      worst.fall = point.fall;
    }
  }

  /// Rayleigh quotients of sqrt(fall) W sqrt(fall) along the points' directions: they rise to the largest
  /// eigenvalue.
  [[nodiscard]] double together(std::vector<Yielding<D>> const& all) const {
    auto const n = static_cast<Index>(all.size());
    if (n == 0)
      return 0;
    Dense matrix(n, n);
    Vector x(problem_.free.size());
    for (Index b = 0; b < n; ++b) {
      x.setZero();
      problem_.W.add_column<D>(all[ix(b)].point, all[ix(b)].along, x);
      for (Index a = 0; a < n; ++a)
        matrix(a, b) = std::sqrt(all[ix(a)].fall * all[ix(b)].fall) *
                       all[ix(a)].along.dot(x.segment<D>(D * all[ix(a)].point));
    }
    Vector v = Vector::Ones(n).normalized(), next(n);
    double quotient = matrix.diagonal().maxCoeff(); // a lower bound as well
    for (int k = 0; k < rounds; ++k) {
      next.noalias() = matrix * v;
      quotient = std::max(quotient, v.dot(next));
      if (!(next.norm() > 0))
        break;
      v = next.normalized();
    }
    return quotient;
  }

  Problem const& problem_;
  Checked which_;
  Snapped snapped_;
  Doubts doubts_;
  std::vector<Dragged<D>> dragged_;
  std::vector<Yielding<D>> bonded_, weakened_;
  double steepest_ = 0; ///< largest mu |W_nt| / W_nn
};

} // namespace

Doubts doubts(Problem const& problem, Vector const& force, Vector const& x, Checked which, Snapped snapped) {
  return by_dimension(problem.dim, [&]<int D>() { return Check<D>(problem, which, snapped)(force, x); });
}

std::string words(FrictionDoubt const& doubt) {
  if (doubt.points == 0)
    return fmt::format(
        "it and {} more that friction pushes, all sliding that way, press with a matrix W_nn + "
        "mu W_nt of negative determinant: together they have with friction more than one answer, or "
        "none; a symmetric body may lean to either side",
        doubt.together - 1);
  std::string text = fmt::format("W_nn = {:.3g} m/N <= mu |W_nt| = {:.3g} x {:.3g} m/N: by itself, all "
                                 "other forces held, it has with friction more than one answer, or none",
                                 doubt.W_nn, doubt.mu, doubt.W_nt);
  if (doubt.W_nn > 0)
    text += fmt::format(
        "; mu below {:.3g} makes it single, for deformable bodies with inertia also a smaller step",
        doubt.W_nn / doubt.W_nt);
  return text;
}

std::string words(SofteningDoubt const& doubt) {
  std::string const remedy = "a less stiff law, a smaller area per point or stiffer bodies make it single, "
                             "with inertia also a smaller step";
  if (doubt.points > 0 && doubt.held)
    return fmt::format(
        "{:.3g} N/m, with which the bodies and the other bonds hold it, <= {:.3g} N/m by which the "
        "bond's force fell in this step: it snaps there, or nearly, and there may be more than one answer; "
        "{}",
        doubt.stiffness, doubt.fall, remedy);
  if (doubt.held)
    return fmt::format(
        "the bonds that weakened in this step did so together {:.3g} times as fast as what holds them "
        "follows: they snap there, or nearly, and there may be more than one answer; {}",
        doubt.together, remedy);
  if (doubt.points > 0)
    return fmt::format(
        "1/W_nn = {:.3g} N/m <= {:.3g} N/m by which the bond's force may fall per opening: by itself, all "
        "other forces held, it has at some loads more than one answer, and snaps from one to another where "
        "other bonds do not hold it; {}",
        doubt.stiffness, doubt.fall, remedy);
  return fmt::format(
      "the bonds together may weaken {:.3g} times as fast as what they hold follows: at some loads there "
      "may be more than one answer, and bonds snap from one to another; {}",
      doubt.together, remedy);
}

std::string words(WeakeningDoubt const& doubt) {
  std::string const remedy =
      "steps longer than the time over which friction falls, or stiffer bodies, make it single, with inertia "
      "also much smaller steps; static_kinetic, which decides at the start of each step, has one";
  if (doubt.points > 0)
    return fmt::format(
        "1/W_tt = {:.3g} N/m <= {:.3g} N/m by which friction may fall per slip in this step: at "
        "some loads there is more than one answer, and the point leaps from one to another; {}",
        doubt.stiffness, doubt.fall, remedy);
  return fmt::format("the points together lose friction with slip {:.3g} times as fast as what they hold "
                     "follows: at some loads there may be more than one answer, and points leap from one to "
                     "another; {}",
                     doubt.together, remedy);
}

} // namespace stiction::contact
