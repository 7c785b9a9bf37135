// Coulomb friction with a constant coefficient.
#pragma once
#include "core/schema.hpp"
#include "interface/friction.hpp"

namespace stiction::interface {

struct Coulomb {
  double mu = 0; ///< 1

  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Coulomb>{"coulomb", "dry friction |r_t| <= mu r_n", "(17), physics.md 3"}
            .number("mu", &Coulomb::mu, "1", coefficients, core::Need::required, "friction coefficient")
            .build();
    return made;
  }
  /// Whether the coefficient follows pressure or speed within a step.
  static constexpr bool follows = false;
  /// The coefficient of a step that a point starts from this status.
  [[nodiscard]] double mu_from(Status) const { return mu; }
  [[nodiscard]] double steepest_fall(double) const { return 0; }
};

template<int D> [[nodiscard]] Coefficient<D> coefficient(Coulomb const& law, Sliding<D> const&) {
  return {law.mu};
}

} // namespace stiction::interface
