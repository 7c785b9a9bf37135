// Friction with one coefficient for a point that stuck and another for one that slides.
#pragma once
#include "core/schema.hpp"
#include "interface/friction.hpp"

namespace stiction::interface {

struct StaticKinetic {
  double mu_s = 0, mu_k = 0; ///< 1

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<StaticKinetic>{"static_kinetic",
                                      "coefficient mu_s for a step that starts stuck or open, mu_k once the "
                                      "point has slid",
                                      "Coulomb 1785; decided at the start of each step"}
            .number("mu_s", &StaticKinetic::mu_s, "1", coefficients, Need::required,
                    "coefficient unless the point slid in the last step")
            .number("mu_k", &StaticKinetic::mu_k, "1", coefficients, Need::required,
                    "coefficient if the point slid in the last step")
            .build();
    return made;
  }
  static constexpr bool follows = false;
  [[nodiscard]] double mu_from(Status last) const { return last == Status::slip ? mu_k : mu_s; }
  [[nodiscard]] double steepest_fall(double) const { return 0; }
};

template<int D> [[nodiscard]] Coefficient<D> coefficient(StaticKinetic const& law, Sliding<D> const&) {
  return {law.mu_s};
}

} // namespace stiction::interface
