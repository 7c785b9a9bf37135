// The dimensionless numbers that decide what a model needs (physics.md 2; Johnson 1985).
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

void add(Section& section, std::string name, double value, std::string meaning, char const* unit = "1") {
  if (std::isfinite(value))
    section.lines.push_back({std::move(name), human(value, unit), value, unit, std::move(meaning)});
}

void add_body_numbers(Facts const& all, BodyFacts const& facts, Explanation& explanation) {
  Section section{"Numbers of body " + facts.body->name, {}};
  double const shear = facts.shear_speed(), transit = facts.extent() / shear;
  add(section, "c_s", shear, "shear wave speed sqrt(G / density)", "m/s");
  if (all.speed > 0)
    add(section, "speed / c_s", all.speed / shear,
        "inertia: waves count above 0.1, nothing moves by inertia below 0.001");
  add(section, "run / transit", all.end / transit,
      fmt::format("duration over the time {} of a wave through the body", human(transit, "s")));
  if (all.dynamic())
    add(section, "step / transit of a cell", all.longest_step * facts.pressure_speed() / facts.smallest_edge,
        "Courant number of the longest step; free to choose, above 1 waves are smeared");
  add(section, "K / G", facts.moduli.bulk() / facts.moduli.shear(),
      "above 10 (nu > 0.45) plain linear cells lock");
  explanation.sections.push_back(std::move(section));
}

/// What a bond with a rate of its own adds: bonding takes time, and speed raises the peak.
void add_viscosity(Facts const& all, PairFacts const& facts, Section& section) {
  auto const& law = *facts.pair->law.adhesion;
  double const bonding = interface::bond_time(law);
  if (bonding == 0)
    return;
  auto const scales = interface::scales(law);
  auto const wording = interface::wording(law);
  auto const& motion = facts.motion;
  add(section, "bonding time", bonding, std::string(wording.time), "s");
  if (motion.closed_time > 0)
    add(section, "closed / bonding time", motion.closed_time / bonding,
        fmt::format("{} of contact by the motions; below 1 no bond is full", human(motion.closed_time, "s")));
  add(section, "V* normal", motion.normal_speed() * bonding / scales.opening, std::string(wording.speed));
  if (scales.along > 0)
    add(section, "V* along", motion.sliding * bonding / scales.along, "the same along the surface");
  add(section, "bonding per step", all.longest_step / bonding, "growth of beta in the longest step");
}

char const* besides(RelativeMotion const& motion) {
  return motion.forced ? "; what springs, loads, gravity and free obstacles do is not in it" : "";
}

/// sigma0, u0 and what follows from them.
void add_adhesion(Facts const& all, PairFacts const& facts, Section& section) {
  auto const scales = interface::scales(*facts.pair->law.adhesion);
  auto const wording = interface::wording(*facts.pair->law.adhesion);
  auto const& motion = facts.motion;
  double const length = facts.cohesive_length(), elastic = facts.elastic_length();
  auto const spaced = [](std::string_view formula) {
    return formula.empty() ? std::string() : " " + std::string(formula);
  };
  add(section, "sigma0", scales.strength, "peak traction" + spaced(wording.strength), "Pa");
  add(section, "u0", scales.opening, "opening" + spaced(wording.opening) + " at that peak", "m");
  add(section, "sigma0 / E*", scales.strength / facts.modulus,
      "strain that the bonds can put into the bodies");
  add(section, "cohesive length", length,
      fmt::format("{}, over which a bond fails",
                  length > elastic                 ? "sqrt(surface stress u0 / sigma0)"
                  : elastic < facts.thick_length() ? "(E' h^3 w / sigma0^2)^(1/4), h: thickness of what bends"
                                                   : wording.length),
      "m");
  add(section, "cohesive length / cell", length / facts.size, "below 3 the pull-off depends on the mesh");
  bool const product = wording.softening.find(' ') != std::string_view::npos;
  add(section,
      fmt::format("stiffness / {1}{0}{2}", wording.softening, product ? "(" : "", product ? ")" : ""),
      facts.column / scales.softening,
      "bodies as columns against the softening bond (physics.md 3): below 1 a bond without viscosity "
      "snaps, of a ball where its Tabor-like number is above 0.7");
  if (facts.radius > 0)
    add(section, "Tabor-like", facts.tabor(),
        fmt::format("(R w^2 / E*^2)^(1/3) {}: above 5 JKR, below 0.1 DMT", wording.tabor));
  add_viscosity(all, facts, section);
  add(section, "opening per step / u0", motion.opening_step / scales.opening,
      std::string("at most; above 0.25 the peak may be cut off") + besides(motion));
  if (scales.along > 0)
    add(section, "sliding per step / u0", motion.sliding_step / scales.along,
        "above 0.25 the peak is cut off");
}

void add_pair_numbers(Facts const& all, PairFacts const& facts, Explanation& explanation) {
  Section section{"Numbers of pair " + facts.pair->name, {}};
  auto const& motion = facts.motion;
  add(section, "E*", facts.modulus, "1 / sum of (1 - nu^2) / E", "Pa");
  if (facts.primary && *facts.primary != facts.secondary) {
    auto const &a = all.bodies[facts.secondary], &b = all.bodies[*facts.primary];
    bool const first = a.plane_modulus() >= b.plane_modulus();
    add(section, "stiffness contrast",
        first ? a.plane_modulus() / b.plane_modulus() : b.plane_modulus() / a.plane_modulus(),
        fmt::format("{} over {}, E / (1 - nu^2); above 1000 the stiffer may be rigid",
                    (first ? a : b).body->name, (first ? b : a).body->name));
  }
  if (facts.radius > 0)
    add(section, "radius", facts.radius, "1 / sum of the curvatures of both sides", "m");
  std::string const normal = std::string("of the motions, along the normal") + besides(motion);
  add(section, "closing speed", motion.closing, normal, "m/s");
  add(section, "opening speed", motion.opening, normal, "m/s");
  add(section, "sliding speed", motion.sliding,
      std::string("of the motions, along the surface") + besides(motion), "m/s");
  if (motion.depth > 0) {
    add(section, "depth", motion.depth, "approach of the motions beyond the first touch", "m");
    add(section, "strain", std::max(facts.strain[0], facts.strain[1]),
        "expected, of the more strained body: by depth over thickness, where it bends 6 h depth / L^2, or "
        "0.4 E*/E sqrt(depth / R)");
  }
  if (facts.size > 0)
    add(section, "closing per step / cell", motion.closing_step / facts.size, "above 8 steps may be halved");
  if (facts.adheres())
    add_adhesion(all, facts, section);
  add_half_space(all, facts, section);
  explanation.sections.push_back(std::move(section));
}

} // namespace

void describe_numbers(Facts const& facts, Explanation& explanation) {
  for (auto const& body : facts.bodies)
    add_body_numbers(facts, body, explanation);
  for (auto const& pair : facts.pairs)
    add_pair_numbers(facts, pair, explanation);
}

} // namespace stiction::scene
