// Proximal points (Rockafellar 1976): an answer by way of problems with more compliance, less and less of it.
#pragma once
#include <functional>

#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// W + a D and free - a D p, which have the same answer once p stays; D is diagonal.
class Nearby {
public:
  /// D: [dim n], m/N or a part of it.
  Nearby(Problem const& problem, Vector D);
  /// For this a and these forces.
  [[nodiscard]] Problem const& at(double a, Vector const& force);

private:
  Problem const& problem_;
  Problem nearby_;
  Vector D_;
};

/// Some solver: of a problem, from these forces.
using Answering = std::function<Solution(Problem const&, Vector const&)>;

/// By problems nearby, D the largest compliance of each point: each is answered by `answer`, and from there
/// the problem itself by `polish`. For problems that nothing answers at once; W must take all but no energy
/// from any forces. Converged, or where it was given up: sooner where there are many rows, or bonds.
[[nodiscard]] Solution approach(Problem const& problem, Vector const& guess, Answering const& answer,
                                Answering const& polish);

} // namespace stiction::contact
