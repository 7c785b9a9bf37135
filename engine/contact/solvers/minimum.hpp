// Minimum of the potential of a frictionless contact problem, whatever the rank and condition of its W.
#pragma once
#include <memory>
#include <optional>

#include "contact/solvers/descent.hpp"

namespace stiction::contact {

/// What a problem leaves to the next one of the same W: its factors.
class MinimumMemory {
public:
  MinimumMemory() = default;
  MinimumMemory(MinimumMemory const&) = delete;
  MinimumMemory& operator=(MinimumMemory const&) = delete;
  virtual ~MinimumMemory() = default;
  /// All that does not follow from W alone.
  virtual void forget() = 0;
};

/// With W = F F^T and x = free + F z, forces p = A rtilde(x) + (lambda, 0) at the minimum of
///   1/2 |z|^2 + sum of the bonds' energies, x_n >= shift_n,
/// by Newton steps that each solve a quadratic programme exactly: where the potential is convex they cannot
/// fail. Where bonds soften it goes downhill as `descend` does. Nothing where W is indefinite or no x is
/// admitted. The problem has no friction.
[[nodiscard]] std::optional<Descended> minimise(Problem const& problem, Vector const& guess, long iterations,
                                                std::unique_ptr<MinimumMemory>& memory);

} // namespace stiction::contact
