// Each problem starts from the answer of the last one, and is solved whole.
#include "contact/solvers/proximal.hpp"

namespace stiction::contact {

namespace {

constexpr int most = 100, most_failures = 25, few_failures = 5;
constexpr long patient_rows = 400;     // dry ones, up to which more failures cost little
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

Nearby::Nearby(Problem const& problem, Vector D) : problem_(problem), nearby_(problem), D_(std::move(D)) {
  nearby_.W = problem.W.dense();
}

Problem const& Nearby::at(double a, Vector const& force) {
  nearby_.W.entries().diagonal() = problem_.W.dense().diagonal() + a * D_;
  nearby_.free = problem_.free - a * D_.cwiseProduct(force);
  return nearby_;
}

Solution approach(Problem const& problem, Vector const& guess, Answering const& answer,
                  Answering const& polish) {
  Nearby nearby(problem, own_compliances(problem));
  bool const patient = problem.free.size() <= patient_rows && problem.adhesions.empty();
  int const patience = patient ? most_failures : few_failures;
  Solution reached;
  reached.force = guess;
  double part = 1;
  for (int k = 0, failures = 0; k < most && failures < patience; ++k) {
    auto const next = answer(nearby.at(part, reached.force), reached.force);
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
