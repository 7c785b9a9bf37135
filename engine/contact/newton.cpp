// Semismooth Newton on the natural map of the bi-potential, all points at once.
#include <Eigen/LU>
#include <limits>

#include "contact/descent.hpp"
#include "contact/solver.hpp"

namespace stiction::contact {

namespace {

constexpr int sweeps = 200, most_sweeps = 5000; // after Newton has stagnated; between two judgements, in all

/// The unknown is the total force p, so that x = free + W p holds exactly and the matrix is dim n x dim n.
template<int D> class NewtonRun {
public:
  NewtonRun(Problem const& problem, Vector const& guess)
      : problem_(problem), p_(open_where_given(problem, guess)) {
    Index const n = problem.size();
    rho_.resize(n);
    for (Index i = 0; i < n; ++i)
      rho_[i] = natural_scale(problem, i);
    states_.resize(ix(n));
    merit_ = evaluate_all(p_, x_);
  }

  /// One Newton step with a line search on the residual; false if no decrease was found.
  bool step() {
    assemble();
    Vector step;
    if (!active_.empty())
      step = matrix_.partialPivLu().solve(right_);
    count_factorization();
    if (!step.allFinite())
      return false;
    Vector direction = Vector::Zero(p_.size());
    for (std::size_t k = 0; k < active_.size(); ++k)
      direction.segment<D>(D * active_[k]) = step.segment<D>(D * static_cast<Index>(k));
    for (Index const i : idle_)
      direction.segment<D>(D * i) = -p_.segment<D>(D * i);
    double const before = merit_;
    Vector const start = p_;
    double length = 1;
    for (int halvings = 0; halvings < 5; ++halvings, length *= 0.5) { // down to 1/16
      p_ = start + length * direction;
      merit_ = evaluate_all(p_, x_);
      if (merit_ <= (1 - 1e-4 * length) * before)
        return true;
    }
    p_ = start;
    merit_ = evaluate_all(p_, x_);
    return false;
  }

  void sweep(int times) {
    for (int k = 0; k < times; ++k)
      for (Index i = 0; i < problem_.size(); ++i) {
        Local<D> const old = p_.segment<D>(D * i);
        Local<D> const free = x_.segment<D>(D * i) - problem_.W.block<D, D>(D * i, D * i) * old;
        Local<D> const change = solve_point<D>(problem_, i, free, old, rho_[i]) - old;
        p_.segment<D>(D * i) += change;
        x_.noalias() += problem_.W.middleCols<D>(D * i) * change;
      }
    work_ += times;
    merit_ = evaluate_all(p_, x_);
  }
  [[nodiscard]] Vector const& force() const { return p_; }
  [[nodiscard]] Verdict verdict() const { return judge(problem_, p_); }
  [[nodiscard]] double work() const { return work_; }

private:
  double evaluate_all(Vector const& p, Vector& x) {
    x = displacement(problem_, p);
    work_ += 1;
    double sum = 0;
    for (Index i = 0; i < problem_.size(); ++i) {
      auto& state = states_[ix(i)];
      state = evaluate<D>(problem_, i, p.segment<D>(D * i), x.segment<D>(D * i), rho_[i]);
      sum += state.residual.squaredNorm();
    }
    return std::sqrt(sum);
  }

  /// Rows of points that are open and unbonded read p = 0 and leave the system.
  void assemble() {
    active_.clear();
    idle_.clear();
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const& state = states_[ix(i)];
      bool const idle = state.status == interface::Status::open && state.adhesion_by_x.isZero(0) &&
                        state.residual.isApprox(p_.segment<D>(D * i), 0);
      (idle ? idle_ : active_).push_back(i);
    }
    auto const n = D * static_cast<Index>(active_.size());
    matrix_.resize(n, n);
    right_.resize(n);
    for (std::size_t a = 0; a < active_.size(); ++a) {
      Index const i = active_[a], row = D * static_cast<Index>(a);
      auto const& state = states_[ix(i)];
      LocalMatrix<D> const by_x = state.residual_by_x - state.residual_by_dry * state.adhesion_by_x;
      for (std::size_t b = 0; b < active_.size(); ++b)
        matrix_.template block<D, D>(row, D * static_cast<Index>(b)).noalias() =
            by_x * problem_.W.block<D, D>(D * i, D * active_[b]);
      matrix_.template block<D, D>(row, row) += state.residual_by_dry;
      right_.template segment<D>(row) = -state.residual;
      for (Index const j : idle_) // their step is known: -p_j
        right_.template segment<D>(row) +=
            by_x * (problem_.W.block<D, D>(D * i, D * j) * p_.segment<D>(D * j));
    }
  }

  /// m^3 / 3 for the matrix of the m active rows, D m^2 to make it.
  void count_factorization() {
    auto const m = static_cast<double>(D) * static_cast<double>(active_.size());
    auto const whole = static_cast<double>(p_.size());
    work_ += whole > 0 ? (m / 3 + D) * m * m / (whole * whole) : 0;
  }

  Problem const& problem_;
  Vector p_, x_, rho_;
  std::vector<PointState<D>> states_;
  std::vector<Index> active_, idle_;
  Dense matrix_;
  Vector right_;
  double merit_ = 0, work_ = 0;
};

class NewtonSolver : public Solver {
public:
  explicit NewtonSolver(BipotentialNewton const& settings) : settings_(settings) {}
  Solution solve(Problem const& problem, Vector const& guess) override {
    bool const downhill_first = may_snap(problem) && !solved(problem, guess);
    if (downhill_first)
      if (auto answer = downhill(problem, guess))
        return *std::move(answer);
    Solution solution = polish(problem, guess);
    if (!solution.converged && !downhill_first && frictionless(problem))
      if (auto answer = downhill(problem, guess); answer && answer->converged)
        return *std::move(answer);
    return solution;
  }

private:
  [[nodiscard]] bool solved(Problem const& problem, Vector const& force) const {
    return judge(problem, force).relative() <= settings_.tolerance;
  }

  /// Nothing where there is no potential. Where a descent does not settle, Newton from the guess may answer
  /// if no bond is leaped over: else it went to another branch.
  [[nodiscard]] std::optional<Solution> downhill(Problem const& problem, Vector const& guess) const {
    auto const end = descend(problem, guess, 20L * settings_.iterations);
    if (!end)
      return std::nullopt;
    Solution solution = polish(problem, end->settled ? end->force : guess);
    if (!end->settled && solution.converged && leaps(problem, guess, solution.force)) {
      solution.converged = false;
      solution.force = end->force;
      solution.verdict = judge(problem, end->force);
    }
    solution.iterations += end->iterations;
    auto const descents = static_cast<double>(end->iterations), n = static_cast<double>(problem.free.size());
    solution.work += descents * (1 + n / 6); // a product and a symmetric factorization each
    return solution;
  }

  [[nodiscard]] Solution polish(Problem const& problem, Vector const& guess) const {
    return by_dimension(problem.dim, [&]<int D>() { return run<D>(problem, guess); });
  }
  template<int D> Solution run(Problem const& problem, Vector const& guess) const {
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
    while (!judged() && solution.iterations < settings_.iterations) {
      ++solution.iterations;
      if (newton.step())
        continue;
      if (++restarts > 5) {
        stagnated = !judged();
        break;
      }
      newton.sweep(10 * restarts);
    }
    // Sweeps are slow where Newton is quick, but they do not cycle. Where the residual no longer falls there
    // may be nothing to sweep to.
    double before = std::numeric_limits<double>::infinity();
    for (int swept = 0; stagnated && !solution.converged && swept < most_sweeps; swept += sweeps) {
      if (!(solution.verdict.relative() < 0.99 * before))
        break;
      before = solution.verdict.relative();
      newton.sweep(sweeps);
      solution.iterations += sweeps;
      judged();
    }
    solution.force = newton.force();
    solution.work = newton.work() + judgements;
    return solution;
  }

  BipotentialNewton settings_;
};

} // namespace

core::Schema const& BipotentialNewton::schema() {
  static auto const made =
      core::Describe<BipotentialNewton>{"newton", "bi-potential Newton (semismooth), all points at once",
                                        "(27)-(29)"}
          .number("tolerance", &BipotentialNewton::tolerance, "1", {1e-15, 1, false, true},
                  core::Need::optional, "natural-map residual over the largest traction")
          .integer("iterations", &BipotentialNewton::iterations, {1, 1e6, false, false}, core::Need::optional,
                   "Newton iterations at most")
          .build();
  return made;
}

std::unique_ptr<Solver> BipotentialNewton::make() const {
  return std::make_unique<NewtonSolver>(*this);
}

std::unique_ptr<Solver> make_solver(SolverChoice const& choice) {
  return std::visit([](auto const& settings) { return settings.make(); }, choice);
}

} // namespace stiction::contact
