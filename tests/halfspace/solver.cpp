// Contact of half spaces: Hertz, counts of products, and answers against the solvers of dense problems.
#include "halfspace/solver.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <memory>
#include <numbers>

#include "interface/laws.hpp"

namespace {

using namespace stiction;
using halfspace::Compliance;
using halfspace::Grid;
using halfspace::Surface;
using std::numbers::pi;

/// A problem and what it starts from.
struct Posed {
  std::shared_ptr<halfspace::State> old = std::make_shared<halfspace::State>();
  halfspace::Problem problem;
  Posed(Surface const& surface, interface::Law const& law) : problem(surface, law) {
    old->status.assign(ix(problem.size()), 0);
    if (law.adhesion)
      old->beta.setZero(problem.size());
    if (problem.shared.dim > 1)
      old->stretch.setZero(2 * problem.size());
    problem.old = old.get();
    problem.dt = 0.01;
  }
  [[nodiscard]] int dim() const { return problem.shared.dim; }
  [[nodiscard]] Vector& free() { return problem.shared.free; }
  void set_bond(Index i, interface::Bond const& bond) {
    old->beta[i] = bond.beta;
    if (dim() > 1)
      old->stretch.segment<2>(2 * i) = bond.stretch;
  }
  /// The next step is to start where points are.
  void start(Vector const& x) {
    old->gap = Eigen::Map<Vector const, 0, Eigen::InnerStride<>>(x.data(), problem.size(),
                                                                 Eigen::InnerStride<>(dim()));
  }
};

Posed problem_of(Surface const& surface, double radius, double depth, interface::Law const& law = {}) {
  auto const& grid = surface.grid();
  Posed posed(surface, law);
  for (Index i = 0; i < grid.size(); ++i)
    posed.free()[posed.dim() * i] = (grid.x(i) * grid.x(i) + grid.y(i) * grid.y(i)) / (2 * radius) - depth;
  return posed;
}

struct Setup {
  Grid grid;
  int components;
};
Setup const setups[] = {{{8, 7, 0.4, 0.35, false, false}, 3}, {{8, 7, 0.4, 0.35, false, true}, 3},
                        {{8, 7, 0.4, 0.35, false, false}, 1}, {{24, 1, 0.4, 1, true, false}, 2},
                        {{24, 1, 0.4, 1, true, true}, 2},     {{24, 1, 0.4, 1, true, true}, 1}};

/// A sphere or cylinder pressed on and moved along, its law the same at all points.
Posed pressed(Surface const& surface, interface::Law const& law, double depth) {
  auto posed = problem_of(surface, 1, depth, law);
  for (Index i = 0; i < posed.problem.size(); ++i) {
    double const gap = posed.free()[posed.dim() * i];
    posed.problem.closed[ix(i)] = gap < 0 ? 1 : 0;
    if (law.adhesion)
      posed.set_bond(i, interface::initial_bond(*law.adhesion, std::max(0.0, gap)));
    if (posed.dim() > 1)
      posed.free()[posed.dim() * i + 1] = -2e-3;
  }
  return posed;
}

double normal(Vector const& force, int components) {
  double sum = 0;
  for (Index i = 0; i < force.size(); i += components)
    sum += force[i];
  return sum;
}

/// The same answer by its force, from another height of the counterpart.
void by_force(Surface const& surface, halfspace::Problem problem, halfspace::Answer const& known) {
  double const lift = -1.5e-3, wanted = normal(known.force, problem.shared.dim);
  for (Index i = 0; i < problem.size(); ++i)
    problem.shared.free[problem.shared.dim * i] -= lift;
  halfspace::Wanted asked;
  asked.force = wanted;
  auto const mine = halfspace::Solver(surface).solve(problem, Vector::Zero(surface.rows()), asked);
  CHECK_MESSAGE(mine.converged, mine.reason);
  CHECK(normal(mine.force, problem.shared.dim) == doctest::Approx(wanted).epsilon(1e-9));
  CHECK(mine.lift == doctest::Approx(lift).epsilon(1e-6));
  CHECK((known.force - mine.force).norm() <= 1e-6 * mine.force.norm());
}

void same_as_dense(Setup const& setup, interface::Law const& law, std::string const& name) {
  CAPTURE(name);
  CAPTURE(setup.components);
  CAPTURE(setup.grid.periodic);
  Surface const surface(setup.grid, Compliance::of({1e4, 0.2, 0.1}, nullptr), setup.components);
  auto const posed = pressed(surface, law, 6e-3);
  auto const& problem = posed.problem;
  auto const mine = halfspace::Solver(surface).solve(problem, Vector::Zero(surface.rows()), {});
  CHECK_MESSAGE(mine.converged, mine.reason);
  auto dense = problem.listed();
  dense.W = contact::Delassus(dense.W.dense());
  CHECK(contact::judge(dense, mine.force).relative() <= 1.1e-10);
  CHECK(judge(problem, mine.force, mine.x, 0).relative() <= 1e-10);
  auto const theirs = contact::BipotentialNewton{}.make()->solve(dense, Vector::Zero(surface.rows()));
  CHECK((theirs.force - mine.force).norm() <= 1e-8 * mine.force.norm());
  by_force(surface, problem, mine);
}

TEST_CASE("contact of half spaces with each law is that of the dense problem") {
  for (auto const& setup : setups) {
    same_as_dense(setup, {}, "dry");
    for (auto const& [name, friction] : test::frictions())
      if (setup.components > 1)
        same_as_dense(setup, {friction, {}}, name);
    for (auto const& [name, adhesion] : test::adhesions())
      same_as_dense(setup,
                    {setup.components > 1 ? std::optional<interface::FrictionLaw>(interface::Coulomb{0.3})
                                          : std::nullopt,
                     adhesion},
                    name);
  }
}

struct Hertz {
  double force, peak; ///< relative errors
  long products;
};

/// A sphere of radius 1 m down by 1 m on 4 m x 4 m of an incompressible half space, E* = 1 Pa, from no force.
Hertz hertz(Index n) {
  Surface const surface({n, n, 4, 4, false, false}, Compliance::of({0.75, 0.5, 0}, nullptr), 1);
  auto const posed = problem_of(surface, 1, 1);
  auto const answer = halfspace::Solver(surface).solve(posed.problem, Vector::Zero(surface.rows()), {});
  CHECK_MESSAGE(answer.converged, answer.reason);
  CHECK(answer.verdict.relative() <= 1e-10);
  return {answer.force.sum() / (4.0 / 3) - 1, answer.force.maxCoeff() / surface.grid().area() / (2 / pi) - 1,
          surface.products()};
}

TEST_CASE("Hertz's force and pressure come with the second power of the spacing, in few products") {
  auto const coarse = hertz(64), middle = hertz(128), fine = hertz(256);
  CHECK(std::abs(fine.force) < 3e-5);
  CHECK(std::abs(fine.peak) < 1e-4);
  CHECK(std::log2(coarse.force / fine.force) / 2 > 1.8);
  CHECK(std::log2(coarse.peak / fine.peak) / 2 > 1.8);
  CHECK(coarse.products < 32);
  CHECK(middle.products < 34);
  CHECK(fine.products < 38); // 1024^2 takes 58
}

TEST_CASE("a force finds a half space that it does not touch yet, and leaves it") {
  Surface const surface({16, 16, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  auto const posed = problem_of(surface, 1, -0.02);
  halfspace::Wanted wanted;
  wanted.force = 3;
  halfspace::Solver const solver(surface);
  auto const pressed = solver.solve(posed.problem, Vector::Zero(surface.rows()), wanted);
  CHECK_MESSAGE(pressed.converged, pressed.reason);
  CHECK(pressed.force.sum() == doctest::Approx(3).epsilon(1e-9));
  CHECK(pressed.lift < -0.02);
  wanted.force = 0;
  auto const left = solver.solve(posed.problem, pressed.force, wanted);
  CHECK_MESSAGE(left.converged, left.reason);
  CHECK(std::abs(left.force.sum()) < 1e-9);
}

TEST_CASE("a half space that is left off says so") {
  Surface const surface({16, 16, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  halfspace::Wanted wanted;
  wanted.enough = [] { return true; };
  auto const posed = problem_of(surface, 1, 0.01);
  auto const answer = halfspace::Solver(surface).solve(posed.problem, Vector::Zero(surface.rows()), wanted);
  CHECK(answer.interrupted);
  CHECK_FALSE(answer.converged);
}

/// Adhesion so strong that the surface jumps: in from a gap, or bonded from the start, and off again. One
/// falls far beyond the opening of its strength.
TEST_CASE("a half space that snaps is answered, with less energy than before") {
  interface::Bilinear const bilinear{1e7, 1000, 1000, 2, 2};
  for (interface::AdhesionLaw const& adhesion :
       {interface::AdhesionLaw{interface::Dugdale{1000, 2e-3, 0.2}}, interface::AdhesionLaw{bilinear}}) {
    CAPTURE(adhesion.index());
    Surface const surface({32, 32, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
    auto posed = pressed(surface, {{}, adhesion}, 2e-3);
    auto const& problem = posed.problem;
    halfspace::Solver const solver(surface);
    auto answer = solver.solve(problem, Vector::Zero(surface.rows()), {});
    CHECK_MESSAGE(answer.converged, answer.reason);
    double strongest = 0;
    for (int step = 0; step < 16; ++step) {
      posed.start(answer.x);
      for (Index i = 0; i < problem.size(); ++i)
        posed.set_bond(i, interface::advance<1>(adhesion, problem.bond(i), answer.x.segment<1>(i)));
      posed.free().array() += 2e-3;
      answer = solver.solve(problem, answer.force, {});
      CHECK_MESSAGE(answer.converged, answer.reason);
      strongest = std::min(strongest, answer.force.sum());
    }
    CHECK(strongest < -1);
    CHECK(answer.force.isZero(0)); // let go
  }
}

/// What a sphere adheres with under forces, one after the other: heights of the counterpart, m. Answers are
/// those of a displacement as far.
std::vector<double> under_forces(std::vector<double> const& forces, interface::AdhesionLaw const& adhesion) {
  Surface const surface({32, 32, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  auto posed = pressed(surface, {{}, adhesion}, 0);
  auto const& problem = posed.problem;
  halfspace::Solver const solver(surface);
  halfspace::Answer answer;
  answer.force = Vector::Zero(surface.rows());
  std::vector<double> lifts;
  double height = 0;
  for (double const force : forces) {
    CAPTURE(force);
    halfspace::Wanted wanted;
    wanted.force = force;
    answer = solver.solve(problem, answer.force, wanted);
    CHECK_MESSAGE(answer.converged, answer.reason);
    posed.free().array() += answer.lift;
    lifts.push_back(height += answer.lift);
    auto const moved = solver.solve(problem, answer.force, {});
    CHECK_MESSAGE(moved.converged, moved.reason);
    CHECK((moved.force - answer.force).norm() < 1e-6 * answer.force.norm());
    posed.start(answer.x);
    for (Index i = 0; i < problem.size(); ++i)
      posed.set_bond(i, interface::initial_bond(adhesion, answer.x[i]));
  }
  halfspace::Wanted wanted;
  wanted.force = -100;
  auto const parted = solver.solve(problem, answer.force, wanted);
  CHECK_FALSE(parted.converged);
  CHECK(parted.reason == "nothing is left that bears a pull of 100 N");
  return lifts;
}

/// It jumps in under no force at all, is farther up the more it is pulled, on the same way back and forth,
/// and lets go.
TEST_CASE("a force on a half space that snaps finds what bears it, or that nothing does") {
  for (interface::AdhesionLaw const& law : {interface::AdhesionLaw{interface::Dugdale{1000, 2e-3, 0.2}},
                                            interface::AdhesionLaw{interface::Potential{2, 5e-4}}}) {
    auto const lifts = under_forces({0.01, 1, -1, -2, 1}, law);
    CHECK(lifts[0] < 0);
    CHECK(lifts[1] < lifts[0]);
    CHECK(lifts[2] > lifts[0]);
    CHECK(lifts[3] > lifts[2]);
    CHECK(lifts[4] == doctest::Approx(lifts[1]).epsilon(0.02));
  }
}

/// Guesses where traction falls faster than the body springs back: the state between bonded and free, where
/// Newton's iteration ends, has more energy than they.
TEST_CASE("a half space is not left where energy has its maximum") {
  Surface const surface({1, 1, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  double const W = surface.delassus().dense()(0, 0);
  interface::Dugdale const law{1000, 2e-3, 0.2};
  auto posed = pressed(surface, {{}, law}, 0);
  double const unstable = 500; // N, half of what the bond holds at most
  double const gap = law.h0 + 0.5 * law.rise();
  posed.free()[0] = gap + W * unstable;
  for (double const held : {0.999 * unstable, 1.001 * unstable}) {
    CAPTURE(held);
    auto const answer = halfspace::Solver(surface).solve(posed.problem, Vector::Constant(1, -held), {});
    CHECK_MESSAGE(answer.converged, answer.reason);
    CHECK(std::abs(answer.x[0] - gap) > 0.5 * law.rise());
  }
}

Surface few_points() {
  return {{12, 1, 0.01, 1, true, false}, Compliance::of({1e6, 0.5, 0}, nullptr), 2};
}

/// Far shorter than a step.
interface::Law short_bonds() {
  return {interface::Coulomb{0.3}, interface::Dugdale{1e6, 1e-6, 0.05}};
}

/// Points in a line under a roller that has come down so far, m.
Posed under_roller(Surface const& surface, interface::Law const& law, double down) {
  auto posed = pressed(surface, law, 0);
  for (Index i = 0; i < posed.problem.size(); ++i) {
    double const x = surface.grid().x(i);
    posed.free()[2 * i] = x * x / 0.1 - down;
    posed.free()[2 * i + 1] = 0;
  }
  return posed;
}

/// Points whose ramps are far finer than a step: with friction, and pressed on, an answer might leave them
/// open.
TEST_CASE("bonds of a half space do not break while it is pressed on") {
  Surface const surface = few_points();
  interface::Law const law = short_bonds();
  auto posed = under_roller(surface, law, 0);
  auto const& problem = posed.problem;
  halfspace::Solver const solver(surface);
  Vector force = Vector::Zero(surface.rows());
  Index most = 0;
  for (int step = 0; step < 20; ++step) {
    for (Index i = 0; i < problem.size(); ++i)
      posed.free()[2 * i] -= 5e-6;
    auto const answer = solver.solve(problem, force, {});
    CHECK_MESSAGE(answer.converged, answer.reason);
    force = answer.force;
    Index bonded = 0;
    for (Index i = 0; i < problem.size(); ++i)
      bonded += answer.x[2 * i] < law.range() ? 1 : 0;
    CHECK(bonded >= most);
    most = bonded;
  }
  CHECK(most > 2);
}

/// A step beyond the bonds' range is not to tear them: that takes more energy than it can do work.
TEST_CASE("bonds of a half space do not break because a step is longer than their range") {
  Surface const surface = few_points();
  interface::Law const law = short_bonds();
  auto posed = under_roller(surface, law, 1e-4);
  auto const& problem = posed.problem;
  halfspace::Solver const solver(surface);
  auto answer = solver.solve(problem, Vector::Zero(surface.rows()), {});
  CHECK_MESSAGE(answer.converged, answer.reason);
  auto const bonds = [&] {
    Index sum = 0;
    for (Index i = 0; i < problem.size(); ++i)
      sum += answer.x[2 * i] < law.range() ? 1 : 0;
    return sum;
  };
  Index const before = bonds();
  CHECK(before > 2);
  for (double const step : {1e-5, 2.75e-5, 2e-5}) {
    CAPTURE(step);
    posed.start(answer.x);
    for (Index i = 0; i < problem.size(); ++i) {
      posed.set_bond(i, interface::initial_bond(*law.adhesion, answer.x[2 * i]));
      posed.free()[2 * i] += step;
      posed.free()[2 * i + 1] -= answer.x[2 * i + 1];
    }
    answer = solver.solve(problem, answer.force, {});
    CHECK_MESSAGE(answer.converged, answer.reason);
    CHECK(bonds() == before);
  }
}

/// The mean of a periodic surface stays: forces that are the same at all points lead nowhere, however large.
TEST_CASE("forces that a periodic half space does not feel are no yardstick") {
  double const L = 1e-3, D = 1e-5, w = 0.002, modulus = 4e6, R = L * L / (4 * pi * pi * D);
  double const sigma0 = 6 / std::cbrt(9 * R / (2 * pi * w * modulus * modulus)); // Maugis' lambda is 6
  Surface const surface({500, 1, L, 1, true, true}, Compliance::of({3e6, 0.5, 0}, nullptr), 1);
  auto posed = pressed(surface, {{}, interface::Dugdale{sigma0, w / sigma0}}, 0);
  auto const& problem = posed.problem;
  halfspace::Solver const solver(surface);
  Vector force = Vector::Zero(surface.rows());
  for (int step = 1; step <= 6; ++step) {
    for (Index i = 0; i < problem.size(); ++i)
      posed.free()[i] = D * (1 - std::cos(2 * pi * surface.grid().x(i) / L)) - 1e-6 * step;
    auto const answer = solver.solve(problem, force, {});
    CAPTURE(step);
    if (!answer.converged)
      continue; // too long a step: a run halves it
    CHECK(answer.force.maxCoeff() / surface.grid().area() < 10 * pi * modulus * D / L);
    force = answer.force;
  }
  CHECK(force.sum() / L > 0);
}

} // namespace
