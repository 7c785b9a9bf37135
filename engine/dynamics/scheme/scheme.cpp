// Descriptions of the schemes.
#include "dynamics/scheme/scheme.hpp"

#include <fmt/format.h>

namespace stiction::dynamics {

namespace {

using core::Need;

template<class T> core::Describe<T>& add_inertia(core::Describe<T>& description) {
  std::string meaning =
      "contact nodes: as all others (an impact rings, and with Newmark's trapezium it makes "
      "energy), by backward Euler (steps that are long beside the contact make energy when it "
      "ends; in bodies that turn it takes angular momentum, 22 % in eight turns of 250 steps), massless "
      "(mass redistribution; such steps make more)";
  std::vector<std::string> names{"full", "implicit", "none"};
  if constexpr (std::is_same_v<T, ThetaXi>) {
    names.emplace_back("cells");
    meaning +=
        ", or by backward Euler with the stress of their cells: keeps linear momentum in every step and "
        "makes no energy when contact ends, at a little more loss";
  }
  return description.choice("contact_inertia", &T::contact_inertia, names, Need::optional, meaning);
}

template<class T> core::Describe<T>& add_level(core::Describe<T>& description) {
  return description.choice(
      "contact_level", &T::contact_level, {"position", "velocity"}, Need::optional,
      "the contact condition bears on gap and slip, or on their rates at the step's end "
      "once the gap would close; bonds always see the gap itself");
}

template<class T> core::Schema cured(core::Describe<T> description) {
  return add_level(add_inertia(description)).build();
}

} // namespace

core::Schema const& ThetaXi::schema() {
  static auto const made = cured(
      core::Describe<ThetaXi>{"theta_xi", "Jean's first-order scheme, plain or cured",
                              "(42)-(52), physics.md 5"}
          .number("theta", &ThetaXi::theta, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end velocity in the displacement")
          .number("xi", &ThetaXi::xi, "1", {0.5, 1, false, false}, Need::optional, "weight of the end forces")
          .number("contact_weight", &ThetaXi::contact_weight, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end reaction where contact_inertia = \"full\"; 1 is (45)")
          .only("contact_inertia = \"full\"",
                [](ThetaXi const& scheme) { return scheme.contact_inertia == ContactInertia::full; }));
  return made;
}

core::Schema const& QuasiStatic::schema() {
  static auto const made =
      core::Describe<QuasiStatic>{"quasi_static", "equilibrium without inertia", "physics.md 5"}
          .number("stabilisation", &QuasiStatic::stabilisation, "1", core::unit_interval, Need::optional,
                  "for bodies that nothing but contact holds, say 1e-6: a viscous force of this times "
                  "(E / L^2) T v per volume meets the velocity v (E: Young's modulus at rest, L: diagonal of "
                  "the body's box, T: duration of the run) and is gone where nothing moves; its work is "
                  "stabilisation_loss of probe.energy; 0: none")
          .build();
  return made;
}

core::Schema const& Newmark::schema() {
  static auto const made = cured(
      core::Describe<Newmark>{"newmark", "Newmark's scheme; gamma = 1/2 is of second order", "Newmark 1959"}
          .number("beta", &Newmark::beta, "1", {0.25, 1, false, false}, Need::optional,
                  "weight of the end acceleration in the displacement; at least gamma / 2")
          .number("gamma", &Newmark::gamma, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end acceleration in the velocity"));
  return made;
}

core::Complaints Newmark::check() const {
  if (2 * beta >= gamma)
    return {};
  return {{"", "beta",
           fmt::format("= {} with gamma = {} is stable for short steps only; give beta >= gamma / 2 = {}",
                       beta, gamma, gamma / 2)}};
}

core::Schema const& GeneralisedAlpha::schema() {
  static auto const made =
      cured(core::Describe<GeneralisedAlpha>{"generalised_alpha", "second order, damps high frequencies",
                                             "Chung and Hulbert 1993"}
                .number("rho_inf", &GeneralisedAlpha::rho_inf, "1", core::unit_interval, Need::optional,
                        "spectral radius at endless frequency: 1 keeps all energy, 0 kills it in a step"));
  return made;
}

core::Schema const& Hht::schema() {
  static auto const made = cured(
      core::Describe<Hht>{"hht", "second order, damps high frequencies", "Hilber, Hughes and Taylor 1977"}
          .number("alpha", &Hht::alpha, "1", {-1.0 / 3, 0, false, false}, Need::optional,
                  "less than 0: part of the old forces in the balance"));
  return made;
}

core::Schema const& MoreauJean::schema() {
  static auto const made =
      core::Describe<MoreauJean>{"moreau_jean", "impulses and velocities at contact, with restitution",
                                 "Jean 1999"}
          .number("theta", &MoreauJean::theta, "1", {0.5, 1, false, false}, Need::optional,
                  "weight of the end velocity and of the end forces")
          .number("restitution", &MoreauJean::restitution, "1", core::unit_interval, Need::optional,
                  "e of 0 <= v_n1 + e v_n0 at closed points; only without adhesion")
          .build();
  return made;
}

core::Schema const& CentralDifference::schema() {
  static auto const made =
      core::Describe<CentralDifference>{"central_difference",
                                        "explicit, lumped mass, stable below a critical step",
                                        "Carpenter, Taylor and Katona 1991"}
          .build();
  return made;
}

} // namespace stiction::dynamics
