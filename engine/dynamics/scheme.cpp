// Descriptions of the schemes.
#include "dynamics/scheme.hpp"

namespace stiction::dynamics {

core::Schema const& ThetaXi::schema() {
  using core::Need;
  static auto const made =
      core::Describe<ThetaXi>{"theta_xi", "Jean's first-order scheme, plain or cured", "(42)-(52), PHYSICS 5"}
          .number("theta", &ThetaXi::theta, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end velocity in the displacement")
          .number("xi", &ThetaXi::xi, "1", {0.5, 1, false, false}, Need::optional, "weight of the end forces")
          .number("contact_weight", &ThetaXi::contact_weight, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end reaction where contact_inertia = \"full\"; 1 is (45)")
          .choice("contact_inertia", &ThetaXi::contact_inertia, {"full", "implicit", "none"}, Need::optional,
                  "contact nodes: as all others, by backward Euler, or massless (mass redistribution)")
          .build();
  return made;
}

core::Schema const& QuasiStatic::schema() {
  static auto const made =
      core::Describe<QuasiStatic>{"quasi_static", "equilibrium without inertia", "PHYSICS 5"}.build();
  return made;
}

} // namespace stiction::dynamics
