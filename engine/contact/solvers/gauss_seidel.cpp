// Nonsmooth Gauss-Seidel and bi-potential Uzawa: the same sweeps, an exact or a single-projection point
// update.
#include "contact/solvers/rounding.hpp"

namespace stiction::contact {

namespace {

/// One projection (28) with the adhesion of the same point kept implicit by a Newton step on x.
template<int D>
Local<D> correct_point(Problem const& problem, Index point, Local<D> const& free, Local<D> const& p,
                       double rho) {
  LocalMatrix<D> const W = problem.W.block<D>(point);
  Local<D> const x = free + W * p;
  auto const state = evaluate<D>(problem, point, p, x, rho);
  Local<D> const dry = state.dry - state.residual; // Proj(...)
  if (problem.points[ix(point)].adhesion < 0)
    return dry;
  // p' = dry + A rtilde(x'), x' = free + W p', linearised about x
  LocalMatrix<D> const I = LocalMatrix<D>::Identity();
  return solve_local<D>(I - state.adhesion_by_x * W, dry + (p - state.dry) - state.adhesion_by_x * (W * p));
}

struct Swept {
  bool found = true;  ///< has every point an answer of its own?
  double changed = 0; ///< points
};

/// One sweep over the points.
template<int D, class Update>
Swept sweep_once(Problem const& problem, Vector const& rho, Vector& p, Vector& x, Update& update) {
  Swept result;
  for (Index i = 0; i < problem.size(); ++i) {
    Local<D> const old = p.segment<D>(D * i), here = x.segment<D>(D * i);
    Local<D> const free = here - problem.W.block<D>(i) * old;
    PointAnswer<D> const answer = update(i, free, old, rho[i]);
    Local<D> const change = answer.force - old;
    result.found = result.found && answer.found;
    if (change.isZero(0))
      continue;
    p.segment<D>(D * i) += change;
    problem.W.add_column<D>(i, change, x);
    ++result.changed;
  }
  return result;
}

/// Sweeps over the points until the judge is content; the best forces judged if that never happens.
template<int D, class Update>
Solution sweep(Problem const& problem, Vector const& guess, double tolerance, int iterations,
               Update&& update) {
  Solution best;
  Vector p = open_where_given(problem, guess), x = displacement(problem, p);
  best.force = p;
  best.verdict = judge(problem, p);
  best.work = 2;
  double const column = 1.0 / std::max(1.0, static_cast<double>(problem.size()));
  Vector rho(problem.size());
  for (Index i = 0; i < problem.size(); ++i)
    rho[i] = natural_scale(problem, i);
  best.converged = best.verdict.relative() <= tolerance;
  int vain = 0;
  for (int sweeps = 1; !best.converged && best.iterations < iterations; sweeps = std::min(2 * sweeps, 32)) {
    for (int k = 0; k < sweeps && best.iterations < iterations; ++k, ++best.iterations) {
      auto const swept = sweep_once<D>(problem, rho, p, x, update);
      best.work += column * swept.changed;
      vain = swept.found ? 0 : vain + 1;
    }
    best.work += 2;
    x = displacement(problem, p); // no drift
    Verdict const verdict = judge(problem, p);
    best.converged = verdict.relative() <= tolerance && verdict.residual <= residual_felt(problem, p);
    if (best.converged || verdict.residual < best.verdict.residual) {
      best.force = p;
      best.verdict = verdict;
    } else if (within_rounding(problem, best)) {
      best.converged = best.rounded = true;
    } else if (vain >= vain_sweeps || !(verdict.residual <= 1e12 * best.verdict.residual)) {
      break; // in vain, or diverges
    }
  }
  if (best.converged && !felt(problem, best, forces_there(problem, guess)))
    best.converged = best.rounded = false;
  return best;
}

template<class Choice> class Sweeps : public Solver {
public:
  explicit Sweeps(Choice const& choice) : choice_(choice) {}
  Solution solve(Problem const& problem, Vector const& guess) override {
    auto solution = by_dimension(problem.dim, [&]<int D>() { return run<D>(problem, guess); });
    if (solution.converged)
      solution.method = std::is_same_v<Choice, BipotentialUzawa> ? Method::uzawa : Method::gauss_seidel;
    return solution;
  }

private:
  template<int D> Solution run(Problem const& problem, Vector const& guess) const {
    auto update = [&](Index i, Local<D> const& free, Local<D> const& p, double rho) {
      if constexpr (std::is_same_v<Choice, BipotentialUzawa>)
        return PointAnswer<D>{correct_point<D>(problem, i, free, p, choice_.relaxation * rho), true};
      else
        return solve_point<D>(problem, i, free, p, rho);
    };
    return sweep<D>(problem, guess, choice_.tolerance, choice_.iterations, update);
  }
  Choice choice_;
};

template<class Choice> core::Schema sweep_schema(core::Describe<Choice> start) {
  return start
      .number("tolerance", &Choice::tolerance, "1", {1e-16, 1, false, true}, core::Need::optional,
              "natural-map residual over the largest traction")
      .integer("iterations", &Choice::iterations, {1, 1e7, false, false}, core::Need::optional,
               "sweeps at most")
      .build();
}

} // namespace

core::Schema const& BipotentialUzawa::schema() {
  static auto const made =
      sweep_schema(core::Describe<BipotentialUzawa>{
          "uzawa", "bi-potential Uzawa: one cone projection per point and sweep", "(27)-(29)"}
                       .number("relaxation", &BipotentialUzawa::relaxation, "1", {0, 2, true, true},
                               core::Need::optional, "factor on rho = 1 / lambda_max(W of the point)"));
  return made;
}

core::Schema const& GaussSeidel::schema() {
  static auto const made = sweep_schema(
      core::Describe<GaussSeidel>{"gauss_seidel", "nonsmooth Gauss-Seidel: each point exactly in turn", ""});
  return made;
}

std::unique_ptr<Solver> BipotentialUzawa::make() const {
  return std::make_unique<Sweeps<BipotentialUzawa>>(*this);
}
std::unique_ptr<Solver> GaussSeidel::make() const {
  return std::make_unique<Sweeps<GaussSeidel>>(*this);
}

} // namespace stiction::contact
