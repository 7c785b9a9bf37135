// Law by law and shape by shape: what a formula asks for, and what it cannot know.
#include "scene/build/formula_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "formula/line.hpp"
#include "formula/punch.hpp"
#include "formula/sphere.hpp"
#include "formula/wave.hpp"

namespace stiction::scene {

using Choice = std::variant<FormulaChoice, std::string>;
using std::numbers::pi;

bool changes(dynamics::Path const& path) {
  return std::ranges::any_of(path.values, [&](double value) { return value != path.values.front(); });
}

namespace {

constexpr double short_ranged =
    5; ///< Maugis' lambda from which adhesion is JKR's: Johnson and Greenwood 1997
constexpr double long_ranged = 0.1;  ///< that up to which it is DMT's, same place
constexpr double all_but_jkr = 1000; ///< from which Maugis' states are JKR's to a thousandth

FormulaChoice choice(std::unique_ptr<formula::Formula> formula, std::string fits, std::string neglects = "") {
  FormulaChoice made;
  made.normal = std::move(formula);
  made.fits = std::move(fits);
  made.neglects = std::move(neglects);
  return made;
}

using halfspace::coordinate;

std::function<double(double, double)> distance_of(halfspace::Sphere const& part) {
  return [apex = part.apex](double x, double y) {
    return std::hypot(x - coordinate(apex, 0), y - coordinate(apex, 1));
  };
}
std::function<double(double, double)> distance_of(halfspace::Cylinder const& part) {
  return [apex = part.apex](double x, double) { return std::abs(x - apex); };
}
std::function<double(double, double)> distance_of(halfspace::Punch const& part) {
  return [centre = part.centre](double x, double y) {
    return std::hypot(x - coordinate(centre, 0), y - coordinate(centre, 1));
  };
}
std::function<double(double, double)> distance_of(halfspace::Wave const& part) {
  return [along_y = !(coordinate(part.wavelengths, 0) > 0)](double x, double y) { return along_y ? y : x; };
}
template<class Other> std::function<double(double, double)> distance_of(Other const&) {
  return {}; // it has no formula
}

/// Pull of bonds that never opened, where surfaces touch, Pa.
double grip_of(interface::Law const& law) {
  if (!law.adhesion)
    return 0;
  interface::BondStep const still{interface::initial_bond(*law.adhesion, 0), 0, true};
  return -interface::adhere<1>(*law.adhesion, still, interface::Local<1>::Zero()).traction[0];
}

/// The law as formulas know it.
struct Sticking {
  double work = 0, traction = 0; ///< J/m^2, Pa; 0: nothing adheres
  bool constant = false;         ///< is the traction, up to its range?
};

struct Chooser {
  halfspace::Model const& model;
  halfspace::Compliance compliance;
  Sticking sticking;

  [[nodiscard]] double modulus() const { return 1 / compliance.plane(); }
  [[nodiscard]] bool line() const { return model.grid.line; }
  [[nodiscard]] bool sticks() const { return sticking.work > 0; }
  [[nodiscard]] double lowest() const { return std::ranges::min(model.shift[2].values); }

  [[nodiscard]] std::string unfit_law() const;
  [[nodiscard]] std::string unfit_motion() const;
  [[nodiscard]] std::string unfit_range(double radius) const;
  [[nodiscard]] Choice adhesive_sphere(formula::Sphere const& sphere) const;

  [[nodiscard]] Choice of(halfspace::Sphere const& part) const;
  [[nodiscard]] Choice of(halfspace::Cylinder const& part) const;
  [[nodiscard]] Choice of(halfspace::Punch const& part) const;
  [[nodiscard]] Choice of(halfspace::Wave const& part) const;
  template<class Other> [[nodiscard]] Choice of(Other const&) const {
    return "its heights are no sphere, cylinder, punch or wave";
  }
};

Sticking sticking_of(interface::Law const& law) {
  if (!law.adhesion)
    return {};
  auto const scales = interface::scales(*law.adhesion);
  return {scales.work, scales.strength, interface::constant_traction(*law.adhesion)};
}

/// What keeps any formula from the pair's law; empty: nothing.
std::string Chooser::unfit_law() const {
  auto const& law = model.law;
  if (law.adhesion && law.friction)
    return "no formula here has both adhesion and friction";
  if (law.adhesion && (interface::evolves(*law.adhesion) || law.lasts() || law.tangential()))
    return "its bonds have a memory, a rate or hold along the surface, and formulas take adhesion that is "
           "reversible and normal (dugdale, potential)";
  if (law.mu_follows() || law.mu(interface::Status::slip) != law.mu(interface::Status::stick))
    return "formulas take friction of a constant coefficient (coulomb) only";
  double const coupling = std::abs(2 * compliance.coupling / compliance.normal);
  if (law.tangential() && coupling > 1e-9)
    return fmt::format(
        "with friction pressure and shear of these bodies act on each other (coupling {:.3g}), "
        "which formulas leave out; they want alike sides, or a rigid one and nu = 0.5",
        coupling);
  return "";
}

/// What keeps friction from a formula; empty: nothing.
std::string Chooser::unfit_motion() const {
  bool const x = changes(model.shift[0]), y = changes(model.shift[1]);
  if (!model.law.tangential() || !(x || y))
    return "";
  if (x && y)
    return "it is moved along x and y, and Mindlin's formula has one direction";
  auto const& along = model.shift[x ? 0 : 1];
  auto const& pressing = model.force ? *model.force : model.shift[2];
  std::size_t first = 0;
  while (along.values[first + 1] == along.values[first])
    ++first;
  double const begins = along.times[first], pressed = pressing.value(begins);
  for (std::size_t k = 0; k < pressing.times.size(); ++k)
    if (pressing.times[k] > begins && pressing.values[k] != pressed)
      return fmt::format(
          "it is moved along from {:g} s on while what presses changes, and Mindlin's formula is of "
          "a constant pressure",
          begins);
  return "";
}

/// What keeps adhesion at a crest of this radius from that of no range.
std::string Chooser::unfit_range(double radius) const {
  double const lambda = formula::transition({modulus(), radius}, sticking.work, sticking.traction);
  return lambda >= short_ranged
             ? ""
             : fmt::format("its adhesion has no short range (lambda = {:.3g}, from {:g} on it has), and "
                           "formulas of lines and waves take that only",
                           lambda, short_ranged);
}

Choice Chooser::adhesive_sphere(formula::Sphere const& sphere) const {
  double const w = sticking.work, lambda = formula::transition(sphere, w, sticking.traction);
  auto const number = fmt::format("lambda = {:.3g}", lambda);
  if (sticking.constant && lambda < all_but_jkr)
    return choice(std::make_unique<formula::Maugis>(sphere, w, sticking.traction),
                  "a sphere under a constant traction up to a range, " + number, "the ramps of the traction");
  if (lambda >= short_ranged)
    return choice(std::make_unique<formula::Jkr>(sphere, w),
                  "a sphere that adheres at short range, " + number, "the range of adhesion");
  if (lambda <= long_ranged && model.force)
    return choice(std::make_unique<formula::Dmt>(sphere, w),
                  "a sphere that adheres without deforming, " + number, "what adhesion deforms");
  return choice(std::make_unique<formula::Maugis>(sphere, w, sticking.traction),
                "a sphere that adheres, " + number,
                "how the traction falls off: it is taken for constant, of the same work and strength");
}

Choice Chooser::of(halfspace::Sphere const& part) const {
  if (line())
    return "a sphere in plane strain is a cylinder; give stiction.surface.cylinder";
  if (model.grid.periodic)
    return "a sphere over a periodic half space has neighbours, which its formula has not; with boundary = "
           "\"free\" it has none";
  formula::Sphere const sphere{modulus(), part.radius};
  if (sticks())
    return adhesive_sphere(sphere);
  auto made = choice(std::make_unique<formula::Hertz>(sphere), "a sphere without adhesion");
  if (model.law.tangential()) {
    made.along.emplace(compliance.normal + compliance.shear, model.law.mu());
    made.fits += ", pressed and then moved along (Cattaneo, Mindlin)";
    made.neglects = "slip across the motion";
  }
  return made;
}

/// What acts along a line or a punch moves it by what no formula here gives.
constexpr char const* only_spheres =
    "it is moved along under friction, which only spheres have a formula for";

Choice Chooser::of(halfspace::Cylinder const& part) const {
  if (!line())
    return "a cylinder in three dimensions ends at the edge of the points; in plane strain it does not";
  if (model.grid.periodic)
    return "a cylinder over a periodic half space has neighbours, which its formula has not; with boundary = "
           "\"free\" it has none";
  if (!model.force)
    return "the depth of a line is not defined in a half plane: it grows with the logarithm of the distance "
           "from "
           "which it is measured; give a force in place of y";
  if (model.law.tangential() && changes(model.shift[0]))
    return only_spheres;
  if (auto const unfit = sticks() ? unfit_range(part.radius) : ""; !unfit.empty())
    return unfit;
  return choice(std::make_unique<formula::Line>(modulus(), part.radius, sticking.work),
                sticks() ? "a cylinder that adheres at short range" : "a cylinder without adhesion",
                sticks() ? "the range of adhesion" : "");
}

Choice Chooser::of(halfspace::Punch const& part) const {
  if (line())
    return "the depth of a strip is not defined in a half plane, and its pressure has no bound: nothing is "
           "left "
           "that a formula gives";
  if (model.grid.periodic)
    return "a punch over a periodic half space has neighbours, which its formula has not; with boundary = "
           "\"free\" it has none";
  if (sticks())
    return "there is no formula here of a flat punch that adheres";
  if (model.law.tangential() && (changes(model.shift[0]) || changes(model.shift[1])))
    return only_spheres;
  double const most = model.force ? std::ranges::max(model.force->values) : 0;
  double const deepest = model.force ? most / (2 * modulus() * part.radius) : -lowest();
  if (deepest >= part.clearance)
    return fmt::format(
        "it goes {:.3g} m deep, more than its clearance of {:g} m, and its formula has nothing outside "
        "it",
        deepest, part.clearance);
  return choice(std::make_unique<formula::Punch>(modulus(), part.radius), "a flat punch without adhesion");
}

Choice Chooser::of(halfspace::Wave const& part) const {
  auto const& grid = model.grid;
  auto const length = [&](std::size_t k) { return k < part.wavelengths.size() ? part.wavelengths[k] : 0.0; };
  double const along_y = line() ? 0 : length(1), one = std::max(length(0), along_y);
  if (!grid.periodic)
    return "a wave of a free half space ends; its formula is of one that is repeated: boundary = "
           "\"periodic\"";
  if (!((length(0) > 0) != (along_y > 0)))
    return "waves along both axes have no formula, nor has a plane; give one wave length above 0";
  if (model.law.tangential() && (changes(model.shift[0]) || changes(model.shift[1])))
    return only_spheres;
  auto const unfit = sticks() ? unfit_range(one * one / (4 * pi * pi * part.amplitude)) : "";
  if (!unfit.empty())
    return unfit;
  double const mean_yield = compliance.mean_normal;
  if (sticks() && !model.force && mean_yield == 0 && -lowest() >= part.amplitude)
    return "it goes down to where all of it touches, and adheres: its force is any";
  formula::Waves const taken{modulus(), part.amplitude, one, grid.Lx * (line() ? 1 : grid.Ly), mean_yield};
  return choice(std::make_unique<formula::Wave>(taken, sticking.work),
                sticks() ? "a wave that adheres at short range" : "a wave without adhesion",
                sticks() ? "the range of adhesion" : "");
}

} // namespace

Choice choose_formula(halfspace::Model const& model, halfspace::Shape const& surface) {
  auto const* counterpart = model.counterpart ? &*model.counterpart : nullptr;
  Chooser const chooser{model, halfspace::Compliance::of(model.body, counterpart), sticking_of(model.law)};
  for (auto const& unfit : {chooser.unfit_law(), chooser.unfit_motion()})
    if (!unfit.empty())
      return unfit;
  auto made = std::visit([&](auto const& part) { return chooser.of(part); }, surface);
  if (auto* fitting = std::get_if<FormulaChoice>(&made)) {
    fitting->drive = model.force ? formula::Drive::force : formula::Drive::depth;
    fitting->distance = std::visit([](auto const& part) { return distance_of(part); }, surface);
    fitting->grip = grip_of(model.law);
    fitting->moved = fitting->along && (changes(model.shift[0]) || changes(model.shift[1]));
  }
  return made;
}

} // namespace stiction::scene
