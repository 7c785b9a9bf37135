// Semismooth Newton on the natural map of the bi-potential, all points at once.
#include <algorithm>
#include <limits>

#include "contact/solvers/coupled_newton.hpp"
#include "contact/solvers/damping.hpp"
#include "contact/solvers/minimum.hpp"
#include "contact/solvers/mixed_sweeps.hpp"
#include "contact/solvers/newton.hpp"
#include "contact/solvers/newton_run.hpp"
#include "contact/solvers/pivoting.hpp"
#include "contact/solvers/proximal.hpp"
#include "contact/solvers/rounding.hpp"
#include "contact/solvers/solver.hpp"
#include "contact/solvers/uphill.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr int sweeps = 200, most_sweeps = 5000; // after Newton has stagnated; between two judgements, in all
constexpr int refinements = 3;
constexpr double near_by = 0.3; // residual of a guess that Newton takes first
constexpr int projections_at_last = 1000;
constexpr long huge = 150;        // rows, from which on sweeps cost less than its factorizations
constexpr int quick = 12;         // iterations, before what is sure takes over
constexpr int proximals = 80;     // in which the residual has to halve: rigid walls take many
constexpr int few_proximals = 25; // of them, before another map is tried
constexpr double near_answer = 1e-4, nearer = 0.1; // residuals at which proximal points are finished
constexpr int last_steps = 10;                     // in which that succeeds or not
constexpr int held_frictions = 4;                  // descents between which friction changes
constexpr double all_but_monotone = 1e-2;          // of the mean of W's diagonal, that it may take
constexpr Index bonded_rows = 400;                 // up to which problems on the way cost little
constexpr int pivotings = 12;                      // with the bonds linear about the last answer

/// The same as this method's, if it converged.
Solution by(Method method, Solution solution) {
  if (solution.converged)
    solution.method = method;
  return solution;
}

/// Does W take no energy from any forces, or this part of it at most?
bool monotone(Problem const& problem, double part = 1e-10) {
  Dense const& W = problem.W.dense();
  return linear::monotone(W, part * W.diagonal().mean());
}

/// What Newton may do where it stagnates; hand_over: where slow, too.
enum class Stuck { give_up, hand_over, sweep };

class NewtonSolver : public Solver {
public:
  explicit NewtonSolver(BipotentialNewton const& settings) : settings_(settings) {}
  Solution solve(Problem const& problem, Vector const& guess) override {
    if (problem.W.together())
      return coupled_newton(problem, guess, settings_.tolerance, settings_.iterations);
    spent_ = {};
    none_ = false;
    there_ = forces_there(problem, guess);
    auto solution = swept(problem, guess);
    if (!solution.converged)
      solution = frictionless(problem) ? without_friction(problem, guess) : with_friction(problem, guess);
    solution.iterations = spent_.iterations;
    solution.work = spent_.work;
    return solution;
  }

  void forget() override {
    if (memory_)
      memory_->forget();
  }

  /// Newton's steps from the guess.
  [[nodiscard]] Solution polish(Problem const& problem, Vector const& guess, Stuck stuck) {
    auto solution = by_dimension(problem.dim, [&]<int D>() { return run<D>(problem, guess, stuck); });
    spend(solution.iterations, solution.work);
    if (solution.converged && !felt(problem, solution, there_)) {
      double const enough = 0.5 * residual_felt(problem, solution.force) / solution.verdict.scale;
      if (enough < settings_.tolerance && !sharpens_)
        return sharpened(problem, solution.force, stuck, enough);
      solution.converged = solution.rounded = false;
      solution.method = Method::none;
    }
    return solution;
  }

private:
  /// Large forces have to leave less than the tolerance makes of them.
  [[nodiscard]] Solution sharpened(Problem const& problem, Vector const& guess, Stuck stuck,
                                   double tolerance) {
    auto settings = settings_;
    settings.tolerance = tolerance;
    NewtonSolver sharper(settings);
    sharper.sharpens_ = true;
    sharper.there_ = there_;
    auto solution = sharper.polish(problem, guess, stuck);
    spend(sharper.spent_.iterations, sharper.spent_.work);
    return solution;
  }
  [[nodiscard]] bool solved(Problem const& problem, Vector const& force) const {
    return judge(problem, force).relative() <= settings_.tolerance;
  }

  /// Many plain points by sweeps, which cost less than one factorization while they take hold, unless the
  /// guess is so near that Newton needs hardly more; then Newton from where they end, and where it stagnates
  /// too, with more compliance, less and less of it.
  [[nodiscard]] Solution swept(Problem const& problem, Vector const& guess) {
    auto const rows = static_cast<long>(problem.free.size());
    if (rows < many || !plain(problem))
      return {};
    if (rows < huge && judge(problem, guess).relative() <= near_by)
      if (auto found = polish(problem, guess, Stuck::hand_over); found.converged)
        return found;
    return plainly(problem, sweep_and_polish(problem, guess, settings_.tolerance));
  }

  /// What a plain problem is answered by where Newton's descent is not.
  [[nodiscard]] Solution plainly(Problem const& problem, Solution solution) {
    if (solution.converged || !plain(problem))
      return solution;
    double part = 0.1 * problem.W.dense().diagonal().mean();
    solution = proximal(problem, std::move(solution), few_proximals, part);
    if (solution.converged)
      return solution;
    auto other = go_on(problem, settings_.tolerance);
    spend(other.iterations, other.work);
    if (other.converged) // the same, but for what rounding leaves, and no forces without bounds
      other = by(Method::uphill, polish(problem, other.force, Stuck::give_up));
    if (other.converged)
      return other;
    return proximal(problem, std::move(solution), proximals, part);
  }

  [[nodiscard]] Solution sweep_and_polish(Problem const& problem, Vector const& guess, double tolerance) {
    auto const rows = static_cast<long>(problem.free.size());
    auto solution = mix_sweeps(problem, guess, tolerance, std::max(100L, rows / 2));
    spend(solution.iterations, solution.work);
    return solution.converged && felt(problem, solution, there_)
               ? solution
               : polish(problem, solution.force, Stuck::give_up);
  }

  /// The proximal point method (Rockafellar 1976): W + a 1 and free - a p have the same answer once p stays.
  /// It goes there where W takes no energy from any forces. part: a, and what it has become.
  [[nodiscard]] Solution proximal(Problem const& problem, Solution solution, int most, double& part) {
    if (solution.converged || !monotone(problem))
      return solution;
    Nearby nearby(problem, Vector::Ones(problem.free.size()));
    double halved = solution.verdict.residual, finished = near_answer;
    for (int idle = 0; idle < most && !solution.converged; ++idle) {
      double const close = std::max(settings_.tolerance, 1e-2 * solution.verdict.relative());
      auto const inner = sweep_and_polish(nearby.at(part, solution.force), solution.force, close);
      part *= inner.converged ? 0.4 : 2;
      auto const verdict = judge(problem, inner.force);
      if (!inner.converged && !(verdict.residual < solution.verdict.residual))
        continue;
      solution.force = inner.force;
      solution.verdict = verdict;
      solution.converged = verdict.relative() <= settings_.tolerance && felt(problem, solution, there_);
      solution = by(Method::proximal, std::move(solution));
      if (!solution.converged && verdict.relative() < finished) {
        take_last_steps(problem, solution);
        finished = nearer * solution.verdict.relative();
      }
      if (solution.verdict.residual < 0.5 * halved) {
        halved = solution.verdict.residual;
        idle = 0;
      }
    }
    return solution;
  }

  /// Proximal points are sure and slow; near an answer Newton's smallest steps may find the rest of the way.
  void take_last_steps(Problem const& problem, Solution& solution) {
    auto next = finish(problem, solution.force, settings_.tolerance, last_steps);
    spend(next.iterations, next.work);
    if (!(next.verdict.residual < solution.verdict.residual))
      return;
    solution.force = std::move(next.force);
    solution.verdict = next.verdict;
    solution.converged = next.verdict.relative() <= settings_.tolerance && felt(problem, solution, there_);
    solution = by(Method::proximal, std::move(solution));
  }

  /// There is a potential: downhill first where a root might be on another branch, else where Newton fails.
  [[nodiscard]] Solution without_friction(Problem const& problem, Vector const& guess) {
    bool const downhill_first = may_snap(problem) && !solved(problem, guess);
    Solution solution;
    if (!downhill_first) {
      solution = polish(problem, guess, Stuck::hand_over);
      if (solution.converged)
        return solution;
    }
    for (auto const method : {Method::descent, Method::minimisation}) {
      // the minimum goes where a descent cannot, on through a snap of all bonds, one front after the other
      long const most = (method == Method::descent ? 20L : 100L) * settings_.iterations;
      if (auto const end = method == Method::descent ? descend(problem, guess, most)
                                                     : minimise(problem, guess, most, memory_)) {
        solution = by(method, landed(problem, *end));
        if (solution.converged)
          return solution;
      }
    }
    if (!downhill_first)
      return at_last(problem, polish(problem, guess, Stuck::sweep));
    auto last = near(problem, guess); // where a descent does not settle, Newton may answer
    return last.converged || solution.force.size() == 0 ? last : swept_on(problem, solution);
  }

  /// From where a descent has ended, short of the tolerance for what rounding makes of a singular W, by
  /// sweeps.
  [[nodiscard]] Solution swept_on(Problem const& problem, Solution const& solution) {
    auto swept = polish(problem, solution.force, Stuck::sweep);
    return swept.converged && !leaps(problem, solution.force, swept.force) ? swept : solution;
  }

  [[nodiscard]] Solution landed(Problem const& problem, Descended const& end) {
    spend(end.iterations, end.work);
    if (end.settled)
      return polish(problem, end.force, Stuck::give_up);
    Solution solution;
    solution.force = end.force;
    solution.verdict = judge(problem, end.force);
    return solution;
  }

  /// Newton's answer if no bond is leaped over: else it went to another branch.
  [[nodiscard]] Solution near(Problem const& problem, Vector const& guess) {
    Solution solution = polish(problem, guess, Stuck::give_up);
    if (solution.converged && leaps(problem, guess, solution.force)) {
      solution.converged = false;
      solution.method = Method::none;
    }
    return solution;
  }

  /// Pivoting where all that starts from the guess fails.
  [[nodiscard]] Solution pivoted(Problem const& problem, Vector const& guess) {
    Solution solution = polish(problem, guess, Stuck::sweep);
    Vector const stuck = solution.force;
    for (auto const from : {From::nothing, From::statuses, From::closed})
      if (!solution.converged)
        pivot_from(problem, from, from == From::statuses ? guess : stuck, solution);
    return solution;
  }

  [[nodiscard]] Solution with_friction(Problem const& problem, Vector const& guess) {
    Solution solution = pivoted(problem, guess);
    if (!solution.converged)
      if (auto beside = beside_bonds(problem, guess); beside.converged)
        return beside;
    if (!solution.converged)
      solution = damped(problem, guess, std::move(solution));
    solution = at_last(problem, std::move(solution));
    if (!solution.converged && !on_the_way_)
      solution = projected(problem, std::move(solution));
    if (!solution.converged)
      solution = approached(problem, guess, std::move(solution));
    return solution.converged ? solution : last_of_all(problem, std::move(solution));
  }

  /// Projections are slow, but where they contract nothing is in their way. From where the others have ended,
  /// then from nothing.
  [[nodiscard]] Solution projected(Problem const& problem, Solution solution) {
    BipotentialUzawa projections;
    projections.tolerance = settings_.tolerance;
    projections.iterations = projections_at_last;
    Vector const stuck = solution.force;
    for (auto const& start : {stuck, Vector(Vector::Zero(stuck.size()))}) {
      auto found = projections.make()->solve(problem, start);
      spend(found.iterations, found.work);
      if (found.converged && felt(problem, found, there_))
        return found;
    }
    return solution;
  }

  /// Bonds that soften faster than bodies give way snap in a motion that is resisted.
  [[nodiscard]] Solution damped(Problem const& problem, Vector const& guess, Solution solution) {
    if (on_the_way_ || problem.free.size() > bonded_rows || problem.adhesions.empty())
      return solution;
    auto settings = settings_;
    settings.tolerance = std::max(settings.tolerance, 1e-9); // of problems on the way
    auto found = come_to_rest(
        problem, guess,
        [&](Problem const& nearby, Vector const& from) { return on_the_way(settings, nearby, from); },
        [&](Problem const& same, Vector const& from) { return polish(same, from, Stuck::give_up); });
    return found.converged ? by(Method::damping, std::move(found)) : solution;
  }

  /// Newton's answer if it has one, else that of all methods but those that pose problems on the way.
  [[nodiscard]] Solution on_the_way(BipotentialNewton const& settings, Problem const& nearby,
                                    Vector const& from) {
    auto answer = newton_from(nearby, from, settings.tolerance);
    spend(answer.iterations, answer.work);
    if (answer.converged)
      return answer;
    NewtonSolver whole(settings);
    whole.on_the_way_ = true;
    answer = whole.solve(nearby, from);
    spend(answer.iterations, answer.work);
    return answer;
  }

  /// A problem that takes no energy has an answer, which may be far from all that was tried; of bodies that
  /// hardly give way along the surface, where rows of W are as good as none, forces are all but undecided.
  [[nodiscard]] Solution approached(Problem const& problem, Vector const& guess, Solution solution) {
    Index const most = problem.adhesions.empty() ? pivoting_rows : bonded_rows;
    if (on_the_way_ || none_ || problem.free.size() > most || !monotone(problem, all_but_monotone))
      return solution;
    auto settings = settings_;
    settings.tolerance *= 0.1; // of problems on the way: at no less they would stay where they are
    auto found = approach(
        problem, guess,
        [&](Problem const& nearby, Vector const& from) { return on_the_way(settings, nearby, from); },
        [&](Problem const& same, Vector const& from) { return polish(same, from, Stuck::give_up); });
    return found.converged ? by(Method::proximal, std::move(found)) : solution;
  }

  /// From where bonds go downhill while friction stays as it is, and again with what that makes of it.
  [[nodiscard]] Solution beside_bonds(Problem const& problem, Vector const& guess) {
    Solution solution;
    solution.force = guess;
    for (int k = 0; k < held_frictions && !solution.converged; ++k) {
      auto const end = descend_beside_friction(problem, solution.force, 20L * settings_.iterations);
      if (!end)
        break;
      spend(end->iterations, end->work);
      solution = by(Method::descent, polish(problem, end->force, Stuck::give_up));
    }
    return solution;
  }

  /// Few rows were not swept, and nothing of what many are answered by was tried.
  [[nodiscard]] Solution at_last(Problem const& problem, Solution solution) {
    bool const tried = static_cast<long>(problem.free.size()) >= many;
    return tried ? solution : plainly(problem, std::move(solution));
  }

  /// Again and again with the bonds linear about the last answer.
  void pivot_from(Problem const& problem, From from, Vector about, Solution& solution) {
    for (int k = 0; k < pivotings && !solution.converged; ++k) {
      auto const found = pivot(problem, about, from);
      none_ = none_ || (found && found->none);
      if (!found || found->force.size() == 0 || !found->force.allFinite())
        return;
      spend(1, static_cast<double>(found->pivots));
      auto next = by(Method::pivoting, polish(problem, found->force, Stuck::give_up));
      if (next.converged || next.verdict.residual < solution.verdict.residual)
        solution = std::move(next);
      if (found->force == about || (plain(problem) && from != From::statuses)) // again it would be the same
        return;
      about = found->force;
    }
  }

  /// Where W is indefinite, sweeps from nothing find what pivots do not, and so does trying everything.
  [[nodiscard]] Solution last_of_all(Problem const& problem, Solution solution) {
    if (auto swept = from_nothing(problem); swept.converged)
      return swept;
    for (auto const& force : enumerate(problem, solution.force).answers)
      if (auto tried = polish(problem, force, Stuck::give_up); tried.converged)
        return by(Method::enumeration, std::move(tried));
    return solution;
  }

  [[nodiscard]] Solution from_nothing(Problem const& problem) {
    GaussSeidel sweeps_alone;
    sweeps_alone.tolerance = settings_.tolerance;
    sweeps_alone.iterations = sweeps;
    auto solution = sweeps_alone.make()->solve(problem, Vector::Zero(problem.free.size()));
    spend(solution.iterations, solution.work);
    return solution;
  }

  void spend(long iterations, double work) {
    spent_.iterations += iterations;
    spent_.work += work;
  }

  template<int D> Solution run(Problem const& problem, Vector const& guess, Stuck stuck) const {
    NewtonRun<D> newton(problem, guess);
    Solution solution;
    int restarts = 0;
    bool stagnated = false;
    double judgements = 0;
    auto judged = [&] {
      ++judgements;
      solution.verdict = newton.verdict();
      return solution.converged = solution.verdict.relative() <= settings_.tolerance;
    };
    auto rounding_ends = [&] {
      solution.force = newton.force();
      return solution.converged = solution.rounded = within_rounding(problem, solution);
    };
    int const most = stuck == Stuck::hand_over ? std::min(quick, settings_.iterations) : settings_.iterations;
    while (!judged() && solution.iterations < most) {
      ++solution.iterations;
      if (newton.step())
        continue;
      if (rounding_ends())
        break;
      if (++restarts > 5 || stuck != Stuck::sweep) {
        stagnated = !judged();
        break;
      }
      newton.sweep(10 * restarts);
    }
    if (!solution.converged && solution.iterations >= most)
      rounding_ends();
    // Sweeps are slow where Newton is quick, but they do not cycle. Where the residual no longer falls there
    // may be nothing to sweep to.
    double before = std::numeric_limits<double>::infinity();
    auto method = Method::newton;
    for (int swept = 0; stuck == Stuck::sweep && stagnated && !solution.converged && swept < most_sweeps;
         swept += sweeps) {
      if (!(solution.verdict.relative() < 0.99 * before) || newton.in_vain())
        break;
      before = solution.verdict.relative();
      newton.sweep(sweeps);
      method = Method::gauss_seidel;
      solution.iterations += sweeps;
      judged();
    }
    solution.force = newton.force();
    for (int k = 0; k < refinements && solution.converged && restarts > 0 && solution.verdict.residual > 0 &&
                    newton.step();
         ++k) {
      ++solution.iterations; // what sweeps leave, Newton finds in one step where no point changes its status
      auto const swept = solution;
      if (!judged() || swept.verdict.residual <= solution.verdict.residual) {
        solution = swept;
        break;
      }
      solution.force = newton.force();
    }
    solution.work = newton.work() + judgements;
    return by(method, std::move(solution));
  }

  struct Spent {
    long iterations = 0;
    double work = 0;
  };
  Spent spent_;
  std::unique_ptr<MinimumMemory> memory_;
  double there_ = std::numeric_limits<double>::infinity(); ///< Pa
  bool none_ = false;                                      ///< has pivoting shown that there is no answer?
  bool sharpens_ = false;   ///< does it solve to less than the tolerance asked for?
  bool on_the_way_ = false; ///< is this a step on the way to another problem's answer?
  BipotentialNewton settings_;
};

} // namespace

Solution newton_from(Problem const& problem, Vector const& guess, double tolerance) {
  BipotentialNewton settings;
  settings.tolerance = tolerance;
  return NewtonSolver(settings).polish(problem, guess, Stuck::give_up);
}

std::unique_ptr<Solver> BipotentialNewton::make() const {
  return std::make_unique<NewtonSolver>(*this);
}

} // namespace stiction::contact
