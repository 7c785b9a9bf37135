// Coulomb friction with a constant coefficient.
#pragma once
#include "core/schema.hpp"

namespace stiction::interface {

struct Coulomb {
  double mu = 0; ///< 1

  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Coulomb>{"coulomb", "dry friction |r_t| <= mu r_n", "(17), PHYSICS 3"}
            .number("mu", &Coulomb::mu, "1", core::non_negative, core::Need::required, "friction coefficient")
            .build();
    return made;
  }
};

} // namespace stiction::interface
