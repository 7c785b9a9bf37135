// Schemas of the probes.
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;

core::Schema const& PointProbe::schema() {
  static auto const made = Describe<PointProbe>{"contact_point", "history of one contact point", ""}
                               .text("pair", &PointProbe::pair, Need::required, "name of the pair")
                               .numbers("near", &PointProbe::near, "m", Need::required,
                                        "the secondary node nearest to {x, y [, z]} at the start")
                               .build();
  return made;
}

core::Schema const& ContactProbe::schema() {
  static auto const made =
      Describe<ContactProbe>{
          "contact", "history of a pair, or of a patch of it: forces, points by status, largest and least",
          ""}
          .text("pair", &ContactProbe::pair, Need::required, "name of the pair")
          .text("set", &ContactProbe::set, Need::optional,
                "only what its points on this set of the secondary body do, \"body.set\"")
          .build();
  return made;
}

core::Schema const& LineProbe::schema() {
  static auto const made = Describe<LineProbe>{"contact_line",
                                               "history of every contact point of a pair: position, gap, "
                                               "tractions, bond, and the area they act on",
                                               ""}
                               .text("pair", &LineProbe::pair, Need::required, "name of the pair")
                               .build();
  return made;
}

core::Schema const& ForceProbe::schema() {
  static auto const made =
      Describe<ForceProbe>{
          "force",
          "force and moment that a motion exerts on its nodes (for those on an obstacle see probe.rigid)", ""}
          .text("set", &ForceProbe::set, Need::required, "driven or fixed nodes, \"body.set\"")
          .numbers("near", &ForceProbe::near, "m", Need::optional, "only its node nearest to {x, y [, z]}")
          .numbers(
              "about", &ForceProbe::about, "m", Need::optional,
              "fixed point {x, y [, z]} that the moment is about; the origin unless given. An axisymmetric "
              "scene has no moments")
          .build();
  return made;
}

core::Schema const& NodeProbe::schema() {
  static auto const made = Describe<NodeProbe>{"node", "displacement and velocity of one node", ""}
                               .text("set", &NodeProbe::set, Need::required, "where to look, \"body.set\"")
                               .numbers("near", &NodeProbe::near, "m", Need::required,
                                        "its node nearest to {x, y [, z]} at the start")
                               .build();
  return made;
}

core::Schema const& RigidProbe::schema() {
  static auto const made =
      Describe<RigidProbe>{"rigid",
                           "where a rigid obstacle is, with a mass or without, and the force and moment "
                           "of the contacts on it",
                           ""}
          .text("obstacle", &RigidProbe::obstacle, Need::required, "name of the obstacle")
          .build();
  return made;
}

core::Schema const& SpringProbe::schema() {
  static auto const made =
      Describe<SpringProbe>{"spring", "force, elongation and energy of a spring with its dashpot", ""}
          .text("spring", &SpringProbe::spring, Need::required, "name of the spring")
          .build();
  return made;
}

core::Schema const& GasProbe::schema() {
  static auto const made =
      Describe<GasProbe>{"gas", "pressure of a load.gas and volume of its cavity", ""}
          .text("set", &GasProbe::set, Need::required, "the cavity's wall, as its load says")
          .build();
  return made;
}

core::Schema const& EnergyProbe::schema() {
  static auto const made =
      Describe<EnergyProbe>{"energy", "the energy ledger of the run", "physics.md 6"}
          .flag("audit", &EnergyProbe::audit,
                "also predict the scheme's loss by its formulas, and show what the ledger then leaves open")
          .build();
  return made;
}

core::Schema const& MomentumProbe::schema() {
  static auto const made =
      Describe<MomentumProbe>{
          "momentum",
          "linear and angular momentum of each body and of all, with the impulses since the "
          "start that changed them: of each pair on its secondary side, of both sides "
          "together, of loads and weight, of motions, and what these leave unaccounted",
          ""}
          .numbers("about", &MomentumProbe::about, "m", Need::optional,
                   "fixed point {x, y [, z]} that angular momenta are about; the origin unless given. An "
                   "axisymmetric scene has no angular momentum, and a linear one along its axis only")
          .build();
  return made;
}

} // namespace stiction::scene
