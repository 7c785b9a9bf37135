// The natural map over all points, its linearisation, steps along it, and small ones where that fails.
#include "halfspace/solver.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "core/threads.hpp"
#include "halfspace/krylov.hpp"
#include "halfspace/standing.hpp"

namespace stiction::halfspace {

namespace {

template<int D> class Newton {
public:
  Newton(Surface const& surface, Problem const& problem, Wanted const& wanted)
      : surface_(surface), problem_(problem), wanted_(wanted), n_(problem.size()),
        natural_(contact::natural_scale(problem.shared, 0)), rho_(D == 1 ? natural_ : 1 / surface.longest()),
        own_(problem.shared.W.template block<D>(0)) {
    governed_ = surface.longest();
    least_hold_ = 1e-3 / governed_;
    unfelt_ = !wanted.force && !surface.mean_gives();
    for (auto const& law : problem.shared.adhesions) {
      auto const scales = interface::scales(law);
      strength_ = std::max(strength_, scales.strength);
      double const wide = scales.strength > 0 ? 3 * scales.work / scales.strength : 0;
      reach_ = std::max({reach_, far * scales.opening, wide});
      opening_ = opening_ > 0 ? std::min(opening_, scales.opening) : scales.opening;
    }
  }

  Answer run(Vector const& guess) {
    answer_.force = guess_ = guess;
    place();
    evaluate();
    Standing const before = standing();
    torn_ = tells() && !wanted_.force && problem_.has_start() && before.bonds < bonds_at_start(problem_);
    Vector start = answer_.x;
    if (!solve_from_here() || gained<D>(before, standing()) || gained_beside_held() ||
        over_a_rise({guess_, std::move(start), 0}))
      if (!solve_from_held())
        solve_by_small_moves();
    finish();
    return std::move(answer_);
  }

private:
  [[nodiscard]] bool enough() {
    answer_.interrupted = answer_.interrupted || (wanted_.enough && wanted_.enough());
    return answer_.interrupted;
  }

  /// x = free + lift + W p.
  void place() {
    answer_.x = problem_.shared.free;
    for (Index i = 0; answer_.lift != 0 && i < n_; ++i)
      answer_.x[D * i] += answer_.lift;
    surface_.add_product(answer_.force, answer_.x);
  }

  [[nodiscard]] contact::PointState<D> state(Index i) const {
    Local<D> p = answer_.force.segment<D>(D * i);
    Local<D> const x = answer_.x.segment<D>(D * i);
    double const hold = held(i);
    if (hold > 0)
      p += hold * (x - near_.segment<D>(D * i));
    auto state = contact::evaluate<D>(problem_.shared, problem_.point(i), p, x, rho_);
    state.adhesion_by_x.diagonal().array() -= hold;
    return state;
  }
  /// Is it apart, without force or anything that could pull? Then nothing is missing there.
  [[nodiscard]] bool idle(Index i) const {
    return D == 1 && !problem_.adheres() && answer_.force[i] == 0 && answer_.x[i] > 0;
  }
  /// Stiffness that holds a point near where it was, if adhesion may make it snap from there, N/m.
  [[nodiscard]] double held(Index i) const {
    if (hold_ == 0 || !problem_.adheres())
      return 0;
    bool const stays = interface::evolves(problem_.adhesion()) && problem_.beta(i) > 0;
    return stays || near_[D * i] < reach_ ? hold_ * problem_.area : 0;
  }
  /// Stiffness that holds the counterpart near where it was, N/m.
  [[nodiscard]] double held_lift() const { return hold_ * lift_share_; }

  [[nodiscard]] bool tells() const { return problem_.adheres() && !interface::evolves(problem_.adhesion()); }
  void back_to(Station const& at) {
    answer_.force = at.force;
    answer_.x = at.x;
    answer_.lift = at.lift;
  }
  [[nodiscard]] Station here() const { return {answer_.force, answer_.x, answer_.lift}; }
  /// With what holds have, and the work that a force has still to do.
  template<class At> [[nodiscard]] Standing standing(At const& at, double lift) const {
    auto now = halfspace::standing<D>(problem_, at);
    now.potential += 0.5 * held_lift() * std::pow(lift - lift_near_, 2);
    if (wanted_.force)
      now.potential += (*wanted_.force - 0.5 * now.force) * lift;
    for (Index i = 0; hold_ > 0 && i < n_; ++i)
      now.potential += 0.5 * held(i) * (at(i).x - near_.segment<D>(D * i)).squaredNorm();
    return now;
  }
  /// On the way from a station to here.
  [[nodiscard]] Standing standing_on_way(Station const& from, double part) const {
    return standing(on_way<D>(from, answer_, part), from.lift + part * (answer_.lift - from.lift));
  }
  [[nodiscard]] Standing standing() const {
    return tells() ? standing(on_way<D>(answer_, answer_, 0), answer_.lift) : Standing{};
  }
  /// Does energy rise on the straight way from there to here? Then nothing leads down it, and a state between
  /// the two may hold. Friction has no potential: where it acts only lost bonds are asked for.
  [[nodiscard]] bool over_a_rise(Station const& from) {
    if (!tells() || torn_ || (D > 1 && standing().bonds >= bonds_at_start(problem_)))
      return false;
    if ((answer_.x - from.x).cwiseAbs().maxCoeff() < little * opening_)
      return false;
    double const before = standing_on_way(from, 0).potential;
    double const most = before + work_of_pressing<D>(problem_, from.x, from.force, answer_.force) +
                        rounding * std::abs(before);
    return std::ranges::any_of(looks,
                               [&](double part) { return standing_on_way(from, part).potential > most; });
  }

  /// Where a displacement tears bonds before any force changes, an answer without them is compared with what
  /// there is while bonds are held where they were.
  [[nodiscard]] bool gained_beside_held() {
    if (!torn_)
      return false;
    Standing const after = standing();
    if (after.bonds >= bonds_at_start(problem_))
      return false;
    Vector x = problem_.shared.free;
    surface_.add_product(guess_, x);
    if (after.potential <= least_held<D>(problem_, guess_, x))
      return false;
    Vector const found = answer_.force;
    bool const held = hold_bonds_at_start();
    Standing const reference = standing();
    answer_.force = found;
    place();
    evaluate();
    return held && gained<D>(reference, after);
  }
  /// Bonds have the gaps of the last state, without slip, and all else no force.
  bool hold_bonds_at_start() {
    answer_.force.setZero();
    system_ = {};
    system_.own = own_;
    for (Index i = 0; i < n_; ++i)
      if (bonded_at_start(problem_, i))
        system_.points.push_back(i);
    LocalMatrix<D> const stiff = own_.inverse();
    system_.B.assign(system_.points.size(), stiff);
    system_.yields.assign(system_.points.size(), true);
    Vector to_go(D * system_.size());
    for (Index k = 0; k < system_.size(); ++k) {
      Index const i = system_.points[ix(k)];
      to_go.segment<D>(D * k) = stiff * (problem_.template start<D>(i) - problem_.template free<D>(i));
    }
    Correction const made = Krylov<D>(surface_, system_, false).solve(to_go, 0, 1e-8, most_inner);
    answer_.krylov += made.iterations;
    for (Index k = 0; k < system_.size(); ++k)
      answer_.force.segment<D>(D * system_.points[ix(k)]) = made.force.segment<D>(D * k);
    place();
    evaluate();
    for (Index k = 0; k < system_.size(); ++k) {
      Index const i = system_.points[ix(k)];
      to_go.segment<D>(D * k) = answer_.x.segment<D>(D * i) - problem_.template start<D>(i);
    }
    double moved = 0; // since the start of the step, without forces
    for (Index i = 0; i < n_; ++i)
      moved = std::max(moved,
                       (problem_.template start<D>(i) - problem_.template free<D>(i)).cwiseAbs().maxCoeff());
    return to_go.cwiseAbs().maxCoeff() < 1e-3 * moved;
  }
  bool solve_from_held() {
    if (!torn_ || !hold_bonds_at_start())
      return false;
    Standing const held = standing();
    return solve_from_here() && !gained<D>(held, standing());
  }
  [[nodiscard]] double steepest() const {
    double most = 0;
    for (Index i = 0; problem_.adheres() && i < n_; ++i)
      most = std::max(most, interface::steepest_fall(problem_.adhesion(), problem_.bond(i)));
    return most;
  }

  /// The force of every point that no displacement tells of: where the mean of the surface stays, forces may
  /// grow by the same at all points for ever without coming nearer to an answer. They are no yardstick then.
  [[nodiscard]] double unfelt() const { return unfelt_ ? normal_force<D>(answer_.force) / double(n_) : 0; }

  /// How large the force of a point is, of which so much is unfelt, N.
  [[nodiscard]] double yardstick(Index i, double unfelt) const {
    Local<D> force = answer_.force.segment<D>(D * i);
    double const whole = force.norm();
    force[0] -= unfelt;
    return unfelt == 0 ? whole : std::max(force.norm(), std::min(whole, strength_ * problem_.area));
  }

  /// Residuals of all points, and how large they are.
  void evaluate() {
    F_.resize(D * n_);
    double const unfelt = this->unfelt();
    std::array<contact::Verdict, core::most_pieces> verdicts;
    double const squares = core::sum_of_pieces(n_, least_points, [&](Index first, Index last) {
      double sum = 0;
      auto& verdict = verdicts[ix(core::piece_of(n_, least_points, first))];
      for (Index i = first; i < last; ++i) {
        Local<D> const residual = idle(i) ? Local<D>(Local<D>::Zero()) : state(i).residual;
        F_.segment<D>(D * i) = residual;
        double const area = problem_.area;
        double const pressed = std::max(0.0, -problem_.shared.free[D * i] - answer_.lift) * natural_;
        verdict.residual = std::max(verdict.residual, residual.norm() * natural_ / rho_ / area);
        verdict.scale = std::max({verdict.scale, yardstick(i, unfelt) / area, pressed / area});
        sum += residual.squaredNorm();
      }
      return sum;
    });
    verdict_ = {};
    for (auto const& one : verdicts) {
      verdict_.residual = std::max(verdict_.residual, one.residual);
      verdict_.scale = std::max(verdict_.scale, one.scale);
    }
    norm_ = std::sqrt(squares + std::pow(missing() / std::sqrt(double(n_)), 2));
  }

  /// Of the force that is asked for, N.
  [[nodiscard]] double missing() const {
    if (!wanted_.force)
      return 0;
    return *wanted_.force - normal_force<D>(answer_.force) + held_lift() * (answer_.lift - lift_near_);
  }
  [[nodiscard]] bool balanced() const {
    return !wanted_.force || std::abs(missing()) <= tolerance() * std::abs(*wanted_.force) ||
           std::abs(missing()) <= tolerance() * answer_.force.cwiseAbs().maxCoeff();
  }
  /// While points are held their answers are but stations on a way.
  [[nodiscard]] double tolerance() const {
    return hold_ > 0 ? std::max(wanted_.tolerance, tolerance_held) : wanted_.tolerance;
  }
  [[nodiscard]] bool there() const { return verdict_.relative() <= tolerance() && balanced(); }

  /// The points at which W counts; forces of the others change at once.
  void linearise() {
    std::array<Linearised<D>, core::most_pieces> parts;
    core::each_piece(n_, least_points, [&](Index first, Index last) {
      auto& part = parts[ix(core::piece_of(n_, least_points, first))];
      for (Index i = first; i < last; ++i)
        if (!idle(i))
          linearise(i, part);
    });
    system_ = {};
    system_.own = own_;
    for (auto const& part : parts)
      system_.append(part);
    auto const yielding = std::ranges::count(system_.yields, true);
    system_.softness = yielding > 0 ? system_.softness / double(yielding) : 0;
  }
  /// Softness is summed up.
  void linearise(Index i, Linearised<D>& system) const {
    auto const at = state(i);
    LocalMatrix<D> const a = at.residual_by_dry, b = at.residual_by_x - a * at.adhesion_by_x;
    if (b.cwiseAbs().maxCoeff() < least_hold_)
      return;
    LocalMatrix<D> const left = (a + b * own_).inverse();
    LocalMatrix<D> const B = left * b;
    // how soft the stiffest direction is beside W: of one component S = 1 / B - W_own
    double const stiffest = B.cwiseAbs().maxCoeff(), soft = std::max(0.0, 1 / stiffest - own_(0, 0));
    bool const yields = stiffest * own_(0, 0) < 1 + 1e-9 + 10.0 * (D > 1) && soft < governed_ && B(0, 0) >= 0;
    system.points.push_back(i);
    system.B.push_back(B);
    system.left.push_back(-left * at.residual);
    system.yields.push_back(yields);
    system.definite = system.definite && B(0, 0) > 0 && B(0, 0) * own_(0, 0) <= 1 + 1e-9;
    if (yields && D == 1)
      system.softness += soft;
  }

  /// There is one answer then, but it may lie behind a front that runs from point to point.
  [[nodiscard]] bool cannot_snap() const { return steepest() <= hold_ + 1 / governed_; }

  /// Frees the forces that are none of W's business, and solves for the others.
  Correction correct(double part) {
    Vector others = -F_;
    for (Index const point : system_.points)
      others.segment<D>(D * point).setZero();
    bool const any = others.cwiseAbs().maxCoeff() > 0;
    double total = missing();
    if (any && wanted_.force)
      for (Index i = 0; i < n_; ++i)
        total -= others[D * i];
    Correction made{std::move(others), Vector::Zero(D * n_), 0, 0};
    if (any)
      surface_.add_product(made.force, made.motion);
    Vector right(D * system_.size());
    each_of(system_.points, [&](Index k) {
      Index const i = system_.points[ix(k)];
      right.segment<D>(D * k) = system_.left[ix(k)] - system_.B[ix(k)] * made.motion.segment<D>(D * i);
    });
    Krylov<D> krylov(surface_, system_, wanted_.force.has_value(), held_lift());
    Correction const inner = krylov.solve(right, total, part, most_inner);
    for (Index k = 0; k < system_.size(); ++k)
      made.force.segment<D>(D * system_.points[ix(k)]) += inner.force.segment<D>(D * k);
    made.motion += inner.motion;
    made.lift = inner.lift;
    answer_.krylov += inner.iterations;
    for (Index i = 0; made.lift != 0 && i < n_; ++i)
      made.motion[D * i] += made.lift;
    return made;
  }

  void move(Correction const& step, double length) {
    answer_.force += length * step.force;
    answer_.x += length * step.motion;
    answer_.lift += length * step.lift;
  }

  /// Newton's iterations, each as long as the residual allows; false where they lead nowhere.
  bool solve_from_here() {
    bool const dry = !problem_.adheres() && D == 1;
    double last = norm_, before = norm_, best = norm_;
    int vain = 0;
    for (int k = 0; k < wanted_.iterations && !enough(); ++k) {
      if (there() && settled())
        return true;
      reach_down();
      linearise();
      double const progress = k == 0 ? 1 : norm_ / last;
      double const part = std::clamp(0.5 * progress * progress, tightest, loosest);
      before = std::exchange(last, norm_);
      auto const step = correct(part);
      ++answer_.iterations;
      move(step, 1);
      evaluate();
      double length = 1;
      while (!dry && !(norm_ < 2 * last) && length > shortest) {
        move(step, -0.5 * length);
        length *= 0.5;
        evaluate();
      }
      if (!dry && k > 1 && length == 1 && norm_ > 0.9 * before) { // to and fro over a kink
        move(step, -0.5);
        evaluate();
      }
      if (!std::isfinite(norm_))
        return false;
      vain = norm_ < 0.99 * best ? 0 : vain + 1;
      best = std::min(best, norm_);
      if (vain > most_vain && (vain > most_vain_in_front || !cannot_snap()))
        return false;
    }
    return false;
  }

  /// Where a force presses and nothing touches.
  void reach_down() {
    if (!wanted_.force || hold_ > 0 || !(missing() > 0) || answer_.force.cwiseAbs().maxCoeff() > 0)
      return;
    double const drop = drop_until_touched<D>(problem_, answer_.x, missing() / natural_);
    if (drop == 0)
      return;
    answer_.lift -= drop;
    place();
    evaluate();
  }

  /// x was carried along; is it still what forces make of it?
  bool settled() {
    place();
    evaluate();
    return there();
  }

  /// Where a bond snaps or forms at once: points, and a counterpart that a force moves, are held near where
  /// they are, less and less, so that the energy falls from answer to answer until nothing is held.
  void solve_by_small_moves() {
    double const steepest = this->steepest();
    if (steepest == 0)
      return;
    if (!torn_ || !hold_bonds_at_start()) {
      answer_.force = guess_;
      answer_.lift = 0;
      place();
    }
    hold_ = 2 * steepest;
    lift_share_ = wanted_.force && reach_ > 0 ? std::abs(missing()) * far / (hold_ * reach_) : 0;
    double most_moved = 0, least = 1e-3 * steepest;
    for (int k = 0, since = 0; k < most_moves && !enough(); ++k) {
      near_ = answer_.x;
      lift_near_ = answer_.lift;
      evaluate();
      Station const station = here();
      if (!solve_from_here() || over_a_rise(station)) {
        hold_ *= 2;
        least = hold_;
        since = 0;
        back_to(station);
        if (hold_ > 1e6 * steepest)
          break;
        continue;
      }
      if (parted())
        break;
      if (++since % 8 == 0)
        least = std::max(0.5 * least, 1e-3 * steepest);
      double const hold = std::exchange(hold_, 0), moved = (answer_.x - near_).cwiseAbs().maxCoeff();
      most_moved = std::max(most_moved, moved);
      evaluate();
      // where nothing pulls any more, forces are no yardstick for what is left of them
      bool const arrived = verdict_.relative() < 1e-3 || moved < 1e-3 * most_moved;
      if (arrived && try_without_hold())
        return;
      hold_ = std::max(0.5 * hold, least);
    }
    hold_ = 0;
    evaluate();
  }
  /// Where it fails, all is as before.
  bool try_without_hold() {
    Station const held = here();
    if (solve_from_here() && !over_a_rise(held))
      return true;
    back_to(held);
    return false;
  }
  /// Is there nothing left that a force could pull at, or only what is open beyond the peak of its traction?
  [[nodiscard]] bool parted() const {
    auto const gaps = Eigen::Map<Vector const, 0, Eigen::InnerStride<D>>(answer_.x.data(), n_);
    return wanted_.force && *wanted_.force < 0 &&
           ((opening_ > 0 && gaps.minCoeff() > opening_) ||
            answer_.force.cwiseAbs().sum() < 1e-6 * std::abs(*wanted_.force));
  }

  void finish() {
    answer_.verdict = judge(problem_, answer_.force, answer_.x, answer_.lift);
    if (unfelt_)
      answer_.verdict.scale = std::min(answer_.verdict.scale, verdict_.scale);
    answer_.converged = !answer_.interrupted && answer_.verdict.relative() <= wanted_.tolerance && balanced();
    if (answer_.converged)
      return;
    if (answer_.interrupted)
      answer_.reason = "it was left off";
    else if (parted())
      answer_.reason = fmt::format("nothing is left that bears a pull of {:g} {}", -*wanted_.force,
                                   surface_.grid().line ? "N/m" : "N");
    else if (!balanced())
      answer_.reason = fmt::format("{:g} of the force of {:g} are not found", missing(), *wanted_.force);
    else
      answer_.reason = fmt::format("contact is solved to {:.2e} of the largest traction only, not to {:.2e}, "
                                   "after {} iterations",
                                   answer_.verdict.relative(), wanted_.tolerance, answer_.iterations);
  }

  static constexpr double loosest = 0.05, tightest = 1e-4, shortest = 1e-2;
  static constexpr double tolerance_held = 1e-6, rounding = 1e-9;
  static constexpr double little = 0.05; ///< of the opening of the strength: what moves less passes nothing
  static constexpr std::array looks{1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 0.01, 0.03, 0.06, 0.1, 0.15, 0.2,
                                    0.25, 0.3,  0.35, 0.4,  0.45, 0.5,  0.6,  0.7,  0.8, 0.9};
  static constexpr double far = 8; ///< over the opening of the strength: what adheres there hardly falls
  static constexpr int most_vain = 8, most_moves = 2000;
  static constexpr int most_vain_in_front = 40; ///< sets of points are found however residuals go
  static constexpr long most_inner = 200;

  Surface const& surface_;
  Problem const& problem_;
  Wanted const& wanted_;
  Index n_;
  double natural_; ///< as the judge weighs gaps, N/m
  double rho_;     ///< as the map does: slips of many points together follow from little force, N/m
  LocalMatrix<D> own_;
  double least_hold_ = 0, governed_ = 0;
  bool unfelt_ = false; ///< the mean force of a displacement
  double strength_ = 0; ///< of adhesion, Pa
  double reach_ = 0;    ///< of the law: beyond, it hardly falls, m
  double opening_ = 0;  ///< of the strength, the least, m
  Answer answer_;
  Vector F_, guess_, near_;               ///< N, N, m
  double hold_ = 0, norm_ = 0;            ///< N/m^3; N
  double lift_share_ = 0, lift_near_ = 0; ///< of the hold, m^2; m
  bool torn_ = false;                     ///< does the step tear bonds before any force changes?
  contact::Verdict verdict_;
  Linearised<D> system_;
};

} // namespace

Answer Solver::solve(Problem const& problem, Vector const& guess, Wanted const& wanted) const {
  return contact::by_dimension(problem.shared.dim,
                               [&]<int D>() { return Newton<D>(*surface_, problem, wanted).run(guess); });
}

} // namespace stiction::halfspace
