// Which answers a contact problem has where theory leaves several or none: what was found, what is shown.
#pragma once
#include <string>

#include "contact/solvers/solver.hpp"

namespace stiction::contact {

struct Answers {
  std::vector<Vector> found; ///< forces told apart, [dim n], N; first the given ones, if they are an answer
  bool given = false;        ///< they are
  bool all = false;          ///< shown: there are no others
  bool sought = false;       ///< false: too large, nothing was tried
  bool promised = false;     ///< by theory: dry, W positive definite, coefficients that are constant
};

/// From no force, from all points closed, from friction that leans to either side, and where the problem is
/// small by pivoting and by every status of every point. force: what a solver left, converged or not, [dim
/// n].
[[nodiscard]] Answers seek_answers(Problem const& problem, Vector const& force, double tolerance = 1e-8);

/// What is shown of a problem that nothing has answered.
[[nodiscard]] Answers without_answer(Problem const& problem, Vector const& force);

/// "2 answers were found from several starts: largest forces 0 N (this one), 1.5 N"; "" where nothing was
/// sought.
[[nodiscard]] std::string words(Answers const& answers, int dim);

} // namespace stiction::contact
