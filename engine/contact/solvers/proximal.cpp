// Each problem starts from the answer of the last one, and is solved whole.
#include "contact/solvers/proximal.hpp"

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr int most = 100, most_failures = 25;
constexpr double less = 0.5, more = 4; // times the compliance after an answer, after none
constexpr double least = 1e-12;        // of a point's own compliance

/// The largest compliance of each point in all its components; of one that nothing moves, that of others.
Vector own_compliances(Problem const& problem) {
  int const dim = problem.dim;
  Vector const diagonal = problem.W.dense().diagonal();
  double const largest = diagonal.maxCoeff();
  Vector own(diagonal.size());
  for (Index i = 0; i < problem.size(); ++i) {
    double const here = diagonal.segment(dim * i, dim).maxCoeff();
    own.segment(dim * i, dim).setConstant(here > 0 ? here : largest);
  }
  return own;
}

} // namespace

Solution approach(Problem const& problem, Vector const& guess, Answering const& answer,
                  Answering const& polish) {
  Dense const& W = problem.W.dense();
  Vector const own = own_compliances(problem);
  Problem nearby = problem;
  nearby.W = W;
  Solution reached;
  reached.force = guess;
  double part = 1;
  for (int k = 0, failures = 0; k < most && failures < most_failures; ++k) {
    nearby.W.entries().diagonal() = W.diagonal() + part * own;
    nearby.free = problem.free - part * own.cwiseProduct(reached.force);
    auto const next = answer(nearby, reached.force);
    failures += next.converged ? 0 : 1;
    part = next.converged ? std::max(less * part, least) : more * part;
    if (!next.converged)
      continue;
    auto last = polish(problem, next.force);
    if (last.converged)
      return last;
    reached.force = next.force;
  }
  return reached;
}

} // namespace stiction::contact
