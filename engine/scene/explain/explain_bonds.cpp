// What bonds ask of cells and steps: where they fail, form and snap.
#include <fmt/format.h>
#include <numbers>
#include <set>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

std::string more_steps(SchedulePart const& schedule, std::size_t stage, double factor) {
  auto const& part = schedule.stages[stage];
  return fmt::format("{:.0f} steps instead of {} in the stage to {}", std::ceil(part.steps * factor - 1e-6),
                     part.steps, human(part.until, "s"));
}

std::string more_steps(Facts const& all, std::size_t stage, double factor) {
  return more_steps(all.scene->part.schedule, stage, factor);
}

namespace {

/// A ball gives way beneath its contact, not as a column: at small Tabor numbers it lets go without a snap
/// (of two balls 0.62 and 0.67 did, 0.80 and 0.94 did not), unless its body gives way more than all that
/// holds it.
bool lets_go_steadily(Facts const& all, PairFacts const& pair) {
  constexpr double steady = 0.7;
  bool const ball = pair.radius > 0 && all.scene->part.kinematics != solid::Kinematics::plane_strain;
  return ball && pair.tabor() < steady &&
         pair.column * pair.radius > 2 * interface::scales(*pair.pair->law.adhesion).strength;
}

} // namespace

bool snaps(Facts const& all, PairFacts const& pair) {
  auto const& law = *pair.pair->law.adhesion;
  return interface::bond_time(law) == 0 && pair.column < interface::scales(law).softening &&
         !nothing_gives_way(all, pair) && !lets_go_steadily(all, pair);
}

namespace {

constexpr double cohesive_cells = 3, good_cells = 6;      // over the cohesive length: the limit, the aim
constexpr double radius_cells = 3, good_radius = 4;       // over what holds a ball as it lets go
constexpr double bonded_cells = 10, good_bonded = 30;     // over what touched, where bonds are as many as did
constexpr double part_of_opening = 0.25, good_part = 0.1; // of u0 in a step: the limit, and what to aim at
constexpr double part_of_gone = 0.4, good_gone = 0.2;     // of 2 w / sigma0 in a step, the same
constexpr double part_of_growth = 0.05, good_growth = 0.02; // of the time that it is closed, in a step
constexpr double part_of_bond = 0.25;                       // beta in a step

using Warnings = std::vector<Warning>;

void cohesive_length(PairFacts const& pair, Warnings& warnings) {
  double const length = pair.cohesive_length();
  double const cell = std::max(pair.size, 0.0);
  if (length >= cohesive_cells * cell)
    return;
  warnings.push_back(
      {fmt::format("pair {}: cohesive length {}, mesh {}, that is {:.2g} of a cell: the pull-off will depend "
                   "on the mesh",
                   pair.pair->name, human(length, "m"), human(cell, "m"), length / cell),
       fmt::format("cells of {} or less at {}, which leave a few per cent", human(length / good_cells, "m"),
                   pair.part->secondary)});
}

/// Over which a ball touched, m, where all bonds are made by touching and hold on together until they let go,
/// as their number does; 0 elsewhere. holding: radius over which bonds are not open beyond their peak, m.
double bonded_radius(PairFacts const& pair, double holding) {
  auto const& law = *pair.pair->law.adhesion;
  bool const by_touch = interface::grows(law) && pair.pair->law.range() == 0 && !pair.motion.unknown;
  double const touched = by_touch ? std::sqrt(pair.radius * pair.motion.depth) : 0;
  return touched < holding ? touched : 0;
}

/// What holds a ball when it lets go: contact by JKR (Johnson, Kendall and Roberts 1971), bonds of long range
/// where they are not open beyond their peak, or all there are. The last are counted in whole cells: of three
/// scenes the pull-off was off by up to 1.5 cells over the radius.
void let_go_radius(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  if (all.scene->part.kinematics == solid::Kinematics::plane_strain || !(pair.radius > 0))
    return;
  auto const scales = interface::scales(*pair.pair->law.adhesion);
  double const R = pair.radius,
               holding = std::max(std::cbrt(9 * std::numbers::pi / 8 * R * R * scales.work / pair.modulus),
                                  std::sqrt(2 * R * scales.opening)),
               bonded = bonded_radius(pair, holding), radius = bonded > 0 ? bonded : holding;
  if (!std::isfinite(radius) || radius >= (bonded > 0 ? bonded_cells : radius_cells) * pair.size)
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: when it lets go it holds on over a radius of {}, {:.2g} cells of {}: the pull-off "
           "will depend on the mesh",
           pair.pair->name, human(radius, "m"), radius / pair.size, human(pair.size, "m")),
       fmt::format("cells of {} or less at {}, which leave {}",
                   human(radius / (bonded > 0 ? good_bonded : good_radius), "m"), pair.part->secondary,
                   bonded > 0 ? "up to five per cent, as bonds are made in whole cells"
                              : "about one per cent")});
}

/// Does a motion move points of a pair themselves, and not only what is beside them?
bool takes_points(Facts const& all, PairFacts const& pair) {
  auto const& points = pair.pair->nodes();
  std::set<Index> const own(points.begin(), points.end());
  return std::ranges::any_of(all.scene->model->motions, [&](dynamics::Motion const& motion) {
    return motion.farthest() > 0 &&
           std::ranges::any_of(motion.nodes, [&](Index node) { return own.contains(node); });
  });
}

/// Where the motions take hold at an end of the bonds, which then open from there: as long as no bond is gone
/// there is more and more to lift, up to a first peak.
void first_peak(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const scales = interface::scales(*pair.pair->law.adhesion);
  double const gone = 2 * scales.work / scales.strength, part = pair.motion.opening_step / gone;
  if (!std::isfinite(part) || part <= part_of_gone || !(pair.bond > 0) || !takes_points(all, pair))
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: the motions open the bonds at an end of it by up to {:.2g} times 2 w / sigma0 in "
           "a step, where they are gone: the first peak of the force is passed over",
           pair.pair->name, part),
       more_steps(all, pair.motion.opening_stage, part / good_gone)});
}

/// Steps that jump over the opening at which the traction peaks.
void opening_steps(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const scales = interface::scales(*pair.pair->law.adhesion);
  auto const& motion = pair.motion;
  if (motion.beside)
    return first_peak(all, pair, warnings);
  auto const check = [&](char const* what, double step, double opening, std::size_t stage) {
    double const part = step / opening;
    if (std::isfinite(part) && part > part_of_opening)
      warnings.push_back(
          {fmt::format(
               "pair {}: the motions {} by up to {:.2g} u0 in a step: the peak of the adhesion is cut off "
               "where it opens so fast, not where it peels from an edge",
               pair.pair->name, what, part),
           more_steps(all, stage, part / good_part) + ", which see it to within 8 %"});
  };
  check("open it", motion.opening_step, scales.opening, motion.opening_stage);
  check("slide", motion.sliding_step, scales.along, motion.sliding_stage);
}

/// Bonds that are not full as long as they grow count the step in which contact ends, or do not.
void growing_steps(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const& stages = all.scene->part.schedule.stages;
  std::size_t const last = pair.motion.opening_stage;
  double const before = last > 0 ? stages[last - 1].until : 0, closed = pair.motion.closed_time,
               part = (stages[last].until - before) / stages[last].steps / closed;
  if (pair.motion.opening_step > 0 && part > part_of_growth)
    warnings.push_back(
        {fmt::format(
             "pair {}: its bonds grow as long as it is closed, {}, and the step in which it opens is {} "
             "of that: they come out wrong by about as much",
             pair.pair->name, human(closed, "s"), percent(part)),
         more_steps(all, last, part / good_growth) + ", which leave two per cent"});
}

void bonding_steps(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const& law = *pair.pair->law.adhesion;
  if (!interface::grows(law))
    return;
  double const bonding = interface::bond_time(law), part = all.longest_step / bonding;
  if (bonding == 0 || bonding < 0.05 * pair.motion.closed_time || pair.motion.closed_time == 0)
    return; // quick bonds are full whatever the step
  if (pair.motion.closed_time < bonding)
    return growing_steps(all, pair, warnings);
  if (part > part_of_bond)
    warnings.push_back({fmt::format("pair {}: a bond forms in {}, {:.2g} steps: its growth is not resolved",
                                    pair.pair->name, human(bonding, "s"), 1 / part),
                        fmt::format("steps of {} or less", human(good_part * bonding, "s"))});
}

/// A bond that softens faster than the bodies give way, and no viscosity that would slow it.
void snapping(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const& law = *pair.pair->law.adhesion;
  if (all.dynamic() || !snaps(all, pair))
    return;
  auto const wording = interface::wording(law);
  bool const viscous = !wording.viscosity.empty(); // if its parameter were more than 0
  auto const& body = all.bodies[pair.secondary];
  double const transit = body.extent() / body.pressure_speed();
  std::string inertia = "scheme.theta_xi{}";
  if (all.longest_step > transit)
    inertia += fmt::format(", whose steps see the snap where they are {} or less, as long as a wave goes "
                           "through the body; longer ones get past it, and damp what follows",
                           human(transit, "s"));
  warnings.push_back(
      {fmt::format("pair {}: the bodies give way more than the bonds soften (E / thickness = {:.2g} N/m^3 < "
                   "{}: the pull-off snaps, and a quasi-static run may not get past it",
                   pair.pair->name, pair.column,
                   viscous ? fmt::format("{}) and {} = 0", wording.softening, wording.viscosity)
                           : fmt::format("{:.2g} N/m^3)", interface::scales(law).softening)),
       viscous ? fmt::format("a small viscosity {} > 0, or {}", wording.viscosity, inertia) : inertia});
}

void no_bond(PairFacts const& pair, Warnings& warnings) {
  auto const where = pair.gap > 0 ? fmt::format(", {} or more apart", human(pair.gap, "m")) : std::string();
  warnings.push_back({fmt::format("pair {}: none of its points has a bond at the start{}, and this law makes "
                                  "none: nothing will adhere",
                                  pair.pair->name, where),
                      "surfaces that touch at the start, beta0 > 0, or a law whose bonds form where surfaces "
                      "touch: adhesion.rcc{bonding = \"contact\"}"});
}

} // namespace

void warn_of_bonds(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  if (!pair.adheres())
    return;
  if (pair.bondless())
    return no_bond(pair, warnings);
  if (!nothing_gives_way(all, pair)) { // to what the bonds pull
    cohesive_length(pair, warnings);
    let_go_radius(all, pair, warnings);
  }
  opening_steps(all, pair, warnings);
  bonding_steps(all, pair, warnings);
  snapping(all, pair, warnings);
}

} // namespace stiction::scene
