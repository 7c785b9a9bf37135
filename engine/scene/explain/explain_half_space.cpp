// Numbers of a half space before its first step.
#include "scene/explain/explain_half_space.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "formula/follow.hpp"
#include "halfspace/surface.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "scene/explain/forecast.hpp"
#include "scene/explain/machine.hpp"

namespace stiction::scene {

namespace {

struct GridFacts {
  Scene const& scene;
  halfspace::Model const& model;
  halfspace::Compliance compliance;
  [[nodiscard]] double modulus() const { return 1 / compliance.plane(); }
  [[nodiscard]] double spacing() const {
    auto const& grid = model.grid;
    return grid.line ? grid.dx() : std::max(grid.dx(), grid.dy());
  }
  [[nodiscard]] double steps() const {
    long sum = 0;
    for (auto const& stage : scene.part.schedule.stages)
      sum += stage.steps;
    return static_cast<double>(sum);
  }
};

void say(Section& section, std::string name, std::string words, std::string meaning = "") {
  section.lines.push_back(
      {std::move(name), std::move(words), std::numeric_limits<double>::quiet_NaN(), "", std::move(meaning)});
}

void count(Section& section, std::string name, double value, char const* unit, std::string meaning) {
  section.lines.push_back({std::move(name), human(value, unit), value, unit, std::move(meaning)});
}

/// a/R of the largest contact at the knots of the drive; nothing where no radius goes with it.
std::optional<double> slenderness(GridFacts const& facts, FormulaChoice const& choice) {
  auto const& surface = facts.scene.part.height_maps.begin()->second.surface;
  auto const* sphere = std::get_if<halfspace::Sphere>(&surface);
  auto const* cylinder = std::get_if<halfspace::Cylinder>(&surface);
  if (sphere == nullptr && cylinder == nullptr)
    return std::nullopt;
  formula::Follower follower(*choice.normal, choice.drive);
  bool const forced = choice.drive == formula::Drive::force;
  double most = 0;
  for (double const drive : forced ? facts.model.force->values : facts.model.shift[2].values)
    if (auto const state = follower.follow(forced ? drive : -drive))
      most = std::max(most, state->area);
  return sphere != nullptr ? std::sqrt(most / std::numbers::pi) / sphere->radius
                           : 0.5 * most / cylinder->radius;
}

/// Which formula answers the scene, would answer it, or why none does.
void tell_of_formula(GridFacts const& facts, Section& section) {
  auto const words = [&](FormulaChoice const& choice) {
    auto const ratio = slenderness(facts, choice);
    return fmt::format("{} ({}), {}{}{}", choice.normal->name(), choice.normal->source(), choice.fits,
                       ratio ? fmt::format(", a/R at most {:.2g}", *ratio) : "",
                       choice.neglects.empty() ? "" : "; it leaves out " + choice.neglects);
  };
  if (facts.scene.formula)
    return say(section, "model", "formula", words(*facts.scene.formula));
  auto const choice = choose_formula(facts.model, facts.scene.part.height_maps.begin()->second.surface);
  if (auto const* unfit = std::get_if<std::string>(&choice))
    say(section, "model", "half space", "no formula: " + *unfit);
  else
    say(section, "model", "half space",
        "model = \"formula\" would do: " + words(std::get<FormulaChoice>(choice)));
}

Section describe_grid(GridFacts const& facts) {
  Section section{"Scene", {}};
  auto const& grid = facts.model.grid;
  say(section, "body " + facts.scene.bodies.front(),
      fmt::format("half space, {} {}, {}",
                  grid.line ? std::to_string(grid.nx) : fmt::format("{} x {}", grid.nx, grid.ny),
                  grid.line ? "points in plane strain" : "points",
                  grid.periodic ? "periodic" : "free around them"));
  say(section, "counterpart " + facts.scene.part.height_maps.begin()->first,
      facts.model.counterpart ? "elastic height map" : "rigid height map");
  say(section, "drive", facts.model.force ? "by force" : "by displacement");
  auto const& law = facts.model.law;
  say(section, "pair " + facts.scene.pairs.front(),
      fmt::format("{} force{} a point", facts.model.components(), facts.model.components() > 1 ? "s" : ""),
      law.tangential() ? "along the normal and the surface" : "nothing acts along the surface");
  tell_of_formula(facts, section);
  count(section, "steps", facts.steps(), "1", "nominal");
  return section;
}

/// Slopes of heights between neighbouring points along x, root mean square.
double rms_slope(halfspace::Model const& model) {
  double sum = 0;
  auto const& grid = model.grid;
  Index pairs = 0;
  for (Index i = 0; i + 1 < grid.size(); ++i)
    if (i % grid.nx + 1 < grid.nx) {
      sum += std::pow((model.heights[i + 1] - model.heights[i]) / grid.dx(), 2);
      ++pairs;
    }
  return pairs > 0 ? std::sqrt(sum / pairs) : 0;
}

/// s
double longest_step(std::vector<StagePart> const& stages) {
  double start = 0, longest = 0;
  for (auto const& stage : stages) {
    longest = std::max(longest, (stage.until - start) / stage.steps);
    start = stage.until;
  }
  return longest;
}

void bond_numbers(GridFacts const& facts, Section& section) {
  auto const& law = *facts.model.law.adhesion;
  auto const scales = interface::scales(law);
  count(section, "sigma0", scales.strength, "Pa", "largest traction of a bond");
  count(section, "u0", scales.opening, "m", "opening that goes with it");
  double const bonding = interface::bond_time(law);
  if (bonding == 0)
    return;
  auto const& schedule = facts.scene.part.schedule;
  count(section, "bonding time", bonding, "s", std::string(interface::wording(law).time));
  count(section, "bonding per step", longest_step(schedule.stages) / bonding, "1",
        schedule.accuracy ? "longest nominal step over that; the steps follow from the error of beta"
                          : "longest step over that; schedule.accuracy chooses steps from the error of beta");
}

Section grid_numbers(GridFacts const& facts) {
  Section section{"Numbers", {}};
  count(section, "E*", facts.modulus(), "Pa", "1 / sum of (1 - nu^2) / E");
  if (!facts.scene.formula)
    count(section, "spacing", facts.spacing(), "m",
          "of points; contacts smaller than some of it are not resolved");
  count(section, "coupling", 2 * facts.compliance.coupling / facts.compliance.normal, "1",
        "of pressure and shear, over the normal compliance: 0 for alike or incompressible sides (2 beta of "
        "Dundurs)");
  count(section, "rms slope", rms_slope(facts.model), "1",
        "of the heights along x, between points; a half space is of small slopes where it touches");
  if (facts.model.law.adhesion)
    bond_numbers(facts, section);
  if (facts.model.grid.periodic) {
    auto const moments = halfspace::moments(facts.model.heights, facts.model.grid);
    count(section, "rms height", moments.height, "m", "about the mean");
    count(section, "rms gradient", moments.slope, "1", "of the waves through the points");
    count(section, "rms curvature", moments.curvature, "1/m", "of their Laplacian");
    count(section, "full pressure", 0.5 * facts.modulus() * moments.slope, "Pa",
          "E* / 2 x rms gradient, rms about the mean where all touches; at mean pressures well below it, the "
          "part "
          "in contact is about 2 p / (E* x rms gradient)");
  }
  return section;
}

/// Products and their inverses in a step, as studies of this kind take them: the finer the grid the more.
double products_in_step(halfspace::Model const& model) {
  bool const along = model.components() > 1, adheres = model.law.adhesion.has_value();
  double const finer = std::max(model.grid.nx, model.grid.ny) / 64.0;
  double const space = !adheres ? along ? 75 * std::pow(finer, 0.35) : 55 * std::pow(finer, 0.25)
                       : along ? 90 * std::pow(finer, 0.35)
                                : 90 * std::pow(finer, 0.5);
  return model.grid.line ? 0.5 * space : space;
}

/// Of a product and what goes with it, measured on no more than so many points.
double seconds_of_product(halfspace::Model const& model) {
  constexpr Index most = 256;
  auto few = model.grid;
  few.nx = std::min(few.nx, few.line ? most * most : most);
  few.ny = std::min(few.ny, most);
  int const D = model.components();
  halfspace::Surface const surface(few, halfspace::Compliance::of(model.body, nullptr), D);
  double const part = halfspace::product_operations(model.grid, D) / halfspace::product_operations(few, D);
  constexpr double beside = 2; // of what is no product
  return part * beside * measure_product(surface);
}

Section grid_cost(GridFacts const& facts) {
  Section section{"Cost", {}};
  auto const& grid = facts.model.grid;
  int const D = facts.model.components();
  double const pad = grid.periodic ? 1 : 2, n = grid.size();
  // tables of waves, half of the transforms, and what state and solver keep of each point
  double const kept = (facts.model.law.adhesion ? 31.0 : 18.0) * D + (D > 1 ? D * D : 0);
  double const numbers = n * (pad * D + (D == 1 ? 1 : 2 * D) * (grid.periodic ? 0.25 : 1) + kept);
  count(section, "memory", program_bytes + 8 * numbers, "B", "about");
  if (facts.scene.formula)
    return section;
  double const products = facts.steps() * products_in_step(facts.model);
  count(section, "operations", products * halfspace::product_operations(grid, D), "1",
        fmt::format("of about {:.0f} products with the surface's compliance, or its inverse, a step",
                    products_in_step(facts.model)));
  count(section, "time", products * seconds_of_product(facts.model), "s",
        "at the speed of this machine as busy as it is; several times as long where much snaps");
  return section;
}

/// Bonds whose pull falls off within less than a point can follow: each point snaps by itself.
void warn_of_range(GridFacts const& facts, std::vector<Warning>& warnings) {
  auto const& law = facts.model.law;
  if (!law.adhesion)
    return;
  auto const scales = interface::scales(*law.adhesion);
  constexpr double square =
      1.1222; // (8 / pi) ln(1 + sqrt 2) / 2: a square's own sinking, E* u / (p h); Love 1929
  double const number = square * facts.spacing() * scales.softening / facts.modulus();
  if (!(number > 1))
    return;
  auto const eases = interface::wording(*law.adhesion).eases;
  auto const larger = eases.empty() ? "" : fmt::format(", or {:.2g} times its {}", 2 * number, eases);
  warnings.push_back(
      {fmt::format(
           "pair {}: adhesion falls off faster than one point of the grid follows ({:.3g} > 1 times, spacing "
           "{}): each point snaps by itself, and forces depend on the grid",
           facts.scene.pairs.front(), number, human(facts.spacing(), "m")),
       fmt::format("give points at most {} apart{}, or a law of longer range and the same work",
                   human(facts.spacing() / number / 2, "m"), larger)});
}

/// The shortest waves of a rough surface, in points.
void warn_of_shortest(GridFacts const& facts, std::vector<Warning>& warnings) {
  auto const& [name, part] = *facts.scene.part.height_maps.begin();
  auto const* rough = std::get_if<halfspace::Rough>(&part.surface);
  constexpr double wanted = 8;
  if (rough == nullptr || rough->shortest >= wanted * facts.spacing())
    return;
  auto const& grid = facts.model.grid;
  auto const enough = [&](Index points, double spacing) {
    return std::max(static_cast<double>(points), std::ceil(points * wanted * spacing / rough->shortest));
  };
  auto const along_y = grid.line ? "" : fmt::format(" and {:g} along y", enough(grid.ny, grid.dy()));
  warnings.push_back(
      {fmt::format(
           "obstacle {}: its shortest waves, of {}, have {:.3g} points (< {:g}): areas of contact are those "
           "of the grid",
           name, human(rough->shortest, "m"), rough->shortest / facts.spacing(), wanted),
       fmt::format("give {:g} points along x{}, which show the same surface, or shortest = {}",
                   enough(grid.nx, grid.dx()), along_y, human(wanted * facts.spacing(), "m"))});
}

/// Heights of a script that end other than they begin: a ramp, or a texture with an edge there.
void warn_of_seam(GridFacts const& facts, std::vector<Warning>& warnings) {
  auto const& [name, part] = *facts.scene.part.height_maps.begin();
  auto const* map = std::get_if<halfspace::Map>(&part.surface);
  auto const& grid = facts.model.grid;
  if (map == nullptr || !grid.periodic)
    return;
  double const steps = halfspace::seam({grid.nx, grid.ny, map->heights, "", {}, {}});
  if (!(steps > halfspace::Measured().seam))
    return;
  warnings.push_back(
      {fmt::format("obstacle {}: where its heights are repeated their steps are {:.3g} times those "
                   "between neighbours (rms): it is not periodic",
                   name, steps),
       "boundary = \"free\", or heights whose rims fit; an edge of a texture lies better within "
       "the period"});
}

/// Half spaces and formulas alike leave out what goes with the square of the slope, a/R at the rim.
void warn_of_slope(GridFacts const& facts, std::vector<Warning>& warnings) {
  constexpr double steep = 0.42; // root mean square slope 0.3 of a sphere, which runs remark on
  auto const choice = choose_formula(facts.model, facts.scene.part.height_maps.begin()->second.surface);
  auto const* formula = std::get_if<FormulaChoice>(&choice);
  auto const ratio = formula != nullptr ? slenderness(facts, *formula) : std::nullopt;
  if (ratio && *ratio > steep)
    warnings.push_back(
        {fmt::format("the contact grows to a/R = {:.2g}: half spaces, and formulas, know small "
                     "slopes only",
                     *ratio),
         "a body of finite elements"});
}

/// A ball's contact on a handful of points: their number decides its force (13 % at 0.8 spacings).
void warn_of_few_points(GridFacts const& facts, std::vector<Warning>& warnings) {
  constexpr double fewest = 1.5, wanted = 2.5; // spacings: force of a dry ball off by up to 3 %, 1 %
  constexpr double between = 0.71;             // spacings: half the diagonal between four points
  auto const& surface = facts.scene.part.height_maps.begin()->second.surface;
  auto const choice = choose_formula(facts.model, surface);
  auto const* sphere = std::get_if<halfspace::Sphere>(&surface);
  auto const* formula = std::get_if<FormulaChoice>(&choice);
  if (sphere == nullptr || formula == nullptr)
    return;
  double const radius = slenderness(facts, *formula).value_or(0) * sphere->radius;
  if (!(radius > 0) || radius >= fewest * facts.spacing())
    return;
  warnings.push_back(
      {fmt::format("pair {}: the contact grows to a radius of {}, {:.2g} times the spacing of points: {}",
                   facts.scene.pairs.front(), human(radius, "m"), radius / facts.spacing(),
                   radius < between * facts.spacing() ? "it may lie between them, and give no force at all"
                                                      : "its force is off by a tenth or so"),
       fmt::format("points at most {} apart, or model = \"formula\"", human(radius / wanted, "m"))});
}

/// The way off the surface in a step as a ball leaves it for good, m, and the stage of that; none where it is
/// pressed at the end, or driven by force.
std::optional<std::pair<double, std::size_t>> leaving_step(GridFacts const& facts) {
  if (facts.model.force)
    return std::nullopt;
  auto const& [times, lifts] = facts.model.shift[2];
  double const touch = -facts.model.heights.minCoeff();
  auto const& stages = facts.scene.part.schedule.stages;
  for (std::size_t k = times.size(); k-- > 1;) {
    if (lifts[k - 1] >= touch || lifts[k] <= touch)
      continue;
    double const speed = (lifts[k] - lifts[k - 1]) / (times[k] - times[k - 1]),
                 when = times[k - 1] + (touch - lifts[k - 1]) / speed;
    double start = 0;
    for (std::size_t stage = 0; stage < stages.size(); start = stages[stage++].until)
      if (when < stages[stage].until)
        return std::pair{speed * (stages[stage].until - start) / stages[stage].steps, stage};
  }
  return std::nullopt;
}

/// A ball's pull is largest over a way of about u0 and what its contact by JKR stretches: 3/4 (pi^2 w^2 R /
/// E*^2)^(1/3). Of three scenes it was 13 to 16 % too small at 0.7 to 1.5 times that in a step, 4 % at 0.3.
void warn_of_leaving(GridFacts const& facts, std::vector<Warning>& warnings) {
  constexpr double limit = 0.25, aim = 0.1;
  auto const& surface = facts.scene.part.height_maps.begin()->second.surface;
  auto const* sphere = std::get_if<halfspace::Sphere>(&surface);
  auto const leaving = leaving_step(facts);
  if (!facts.model.law.adhesion || sphere == nullptr || !leaving)
    return;
  auto const scales = interface::scales(*facts.model.law.adhesion);
  double const pull = std::numbers::pi * scales.work / facts.modulus(),
               way = scales.opening + 0.75 * std::cbrt(pull * pull * sphere->radius);
  double const part = leaving->first / way;
  if (part > limit)
    warnings.push_back(
        {fmt::format("pair {}: the ball leaves by {} in a step, {:.2g} times the way of {} over which its "
                     "pull is largest: that is cut off",
                     facts.scene.pairs.front(), human(leaving->first, "m"), part, human(way, "m")),
         more_steps(facts.scene.part.schedule, leaving->second, part / aim) +
             ", which see it to within 10 %"});
}

/// A ball whose contact grows past the last points.
void warn_of_rim(GridFacts const& facts, std::vector<Warning>& warnings) {
  auto const& grid = facts.model.grid;
  auto const& surface = facts.scene.part.height_maps.begin()->second.surface;
  auto const choice = choose_formula(facts.model, surface);
  auto const* sphere = std::get_if<halfspace::Sphere>(&surface);
  auto const* formula = std::get_if<FormulaChoice>(&choice);
  double const half = 0.5 * (grid.line ? grid.Lx : std::min(grid.Lx, grid.Ly));
  if (sphere == nullptr || formula == nullptr)
    return;
  if (double const radius = slenderness(facts, *formula).value_or(0) * sphere->radius; radius > half)
    warnings.push_back(
        {fmt::format("pair {}: the contact grows to a radius of {}, past the last points, {} "
                     "from the middle",
                     facts.scene.pairs.front(), human(radius, "m"), human(half, "m")),
         fmt::format("size = {0} or more each way, with as many more points", human(2.2 * radius, "m"))});
}

} // namespace

Explanation explain_half_space(Scene const& scene) {
  auto const& model = *scene.half_space;
  GridFacts const facts{
      scene, model, halfspace::Compliance::of(model.body, model.counterpart ? &*model.counterpart : nullptr)};
  Explanation explanation;
  explanation.sections = {describe_grid(facts), grid_numbers(facts)};
  warn_of_slope(facts, explanation.warnings);
  if (scene.formula)
    return explanation;
  explanation.sections.push_back(grid_cost(facts));
  warn_of_few_points(facts, explanation.warnings);
  warn_of_rim(facts, explanation.warnings);
  warn_of_leaving(facts, explanation.warnings);
  warn_of_range(facts, explanation.warnings);
  warn_of_shortest(facts, explanation.warnings);
  warn_of_seam(facts, explanation.warnings);
  warn_of_idle_law(scene.part.pairs.begin()->first, model.law, model.grid.line ? 2 : 3, explanation.warnings);
  return explanation;
}

} // namespace stiction::scene
