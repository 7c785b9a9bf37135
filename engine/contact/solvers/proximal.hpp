// Proximal points (Rockafellar 1976): an answer by way of problems with more compliance, less and less of it.
#pragma once
#include <functional>

#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// Some solver: of a problem, from these forces.
using Answering = std::function<Solution(Problem const&, Vector const&)>;

/// W + a D and free - a D p have the same answer once p stays; D: the largest compliance of each point. Each
/// of them is answered by `answer`, and from there the problem itself by `polish`. For problems that nothing
/// answers at once; W must take no energy from any forces. Converged, or the last that was tried.
[[nodiscard]] Solution approach(Problem const& problem, Vector const& guess, Answering const& answer,
                                Answering const& polish);

} // namespace stiction::contact
