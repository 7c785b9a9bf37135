// Backward Euler steps of a flow; each problem is solved whole and starts from the answer of the last one.
#include "contact/solvers/damping.hpp"

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr int most_media = 100, most_refusals = 10;
constexpr double first_medium = 1e4;         // times the mean stiffness: points hardly move at first
constexpr double thinner = 0.5, thicker = 4; // times the medium after an answer, after none

/// What one step of the motion solves.
Problem resisted(Problem const& problem, double medium, Vector const& from) {
  Dense const& W = problem.W.dense();
  auto nearby = problem;
  Eigen::PartialPivLU<Dense> const lu(Dense(Dense::Identity(W.rows(), W.cols()) + medium * W));
  nearby.W = Dense(lu.solve(W));
  nearby.free = lu.solve(problem.free + medium * (W * from));
  return nearby;
}

} // namespace

Solution come_to_rest(Problem const& problem, Vector const& guess, Answering const& answer,
                      Answering const& polish) {
  Solution reached;
  reached.force = guess;
  Vector at = problem.start.size() > 0 ? problem.start : displacement(problem, guess);
  double medium = first_medium / problem.W.dense().diagonal().mean();
  for (int k = 0, failures = 0; k < most_media && failures < most_refusals; ++k) {
    auto const nearby = resisted(problem, medium, at);
    auto const next = answer(nearby, reached.force);
    medium *= next.converged ? thinner : thicker;
    failures += next.converged ? 0 : 1;
    if (!next.converged)
      continue;
    reached.force = next.force;
    at = displacement(nearby, next.force);
    if (auto last = polish(problem, next.force); last.converged)
      return last;
  }
  return reached;
}

} // namespace stiction::contact
