// Sets that turn: without stress where all of a body does, with the moment that their work asks for.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "dynamics/space.hpp"
#include "scene/complaints.hpp"
#include "scene/probes/probes.hpp"

using namespace stiction;
using test::Vec3;

namespace {

test::Input turn(std::string set, std::vector<double> const& centre, std::vector<double> const& angle) {
  std::vector<double> times;
  for (std::size_t k = 0; k < angle.size(); ++k)
    times.push_back(2.0 * static_cast<double>(k) / static_cast<double>(angle.size() - 1));
  return test::make("motion.turn", {{"set", test::text(std::move(set))},
                                    {"times", test::values(times, "s")},
                                    {"angle", test::values(angle, "rad")},
                                    {"centre", test::values(centre, "m")}});
}

test::Input neo_hookean() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
}

/// Columns that a force probe adds to.
std::vector<double> sampled(scene::Scene const& scene, test::State const& state) {
  std::vector<double> row;
  scene::Columns const columns{[](auto const&...) {}, [](auto const&...) {}};
  for (auto const& sampler : scene::add_probes(scene, columns))
    sampler(state, row);
  return row;
}

/// The last state after so many steps up to 2 s, and the work of a probe's moment, its last column, by
/// trapezia.
struct Twisted {
  test::State state;
  double work = 0;              ///< J
  std::vector<double> row = {}; ///< of the probes, at the end
};
Twisted twist(scene::Scene const& scene, int steps, double angle) {
  scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*scene.model);
  Twisted result{stepper.initial()};
  double before = 0;
  for (int k = 0; k < steps; ++k) {
    result.state = test::march(stepper, result.state, 2.0 / steps, 1);
    result.row = sampled(scene, result.state);
    result.work += 0.5 * (before + result.row.back()) * angle / steps;
    before = result.row.back();
  }
  return result;
}

test::Input bar(double cells) {
  auto table = test::space();
  test::at(table, "bodies.bar") =
      test::box({{-0.5, -0.5, 0}, {1, 1, 2}, {cells, cells, 2 * cells}}, neo_hookean());
  test::at(table, "motions") =
      test::list({test::fix_in("bar.bottom", "xyz"), turn("bar.top", {0, 0, 2}, {0, 0.8})});
  test::at(table, "probes.drive") = test::make("probe.force", {{"set", test::text("bar.top")}});
  return table;
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("a body whose sides turn by two thirds of a circle and travel goes with them, without stress") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({}, neo_hookean());
  test::at(table, "obstacles") = test::Input{core::Table{}, "", ""};
  test::at(table, "pairs") = test::Input{core::Table{}, "", ""};
  std::vector<double> const angle{0, 2, 4};
  core::List motions;
  for (std::string const side : {"left", "bottom", "right"}) {
    auto motion = turn("foot." + side, {0.3, -0.2}, angle);
    test::at(motion, "x") = test::values({0, 1, 0.5}, "m");
    motions.push_back(motion);
  }
  test::at(table, "motions") = test::list(motions);
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const end = test::march(stepper, stepper.initial(), 0.1, 20);
  CHECK(end.ledger.strain < 1e-15 * 1000);
  Eigen::Matrix2d const R = Eigen::Rotation2Dd(4).toRotationMatrix();
  double worst = 0;
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    Eigen::Vector2d const X = scene.model->reference.row(i).transpose(), centre(0.3, -0.2), shift(0.5, 0);
    worst = std::max(worst, (X + end.u.segment<2>(2 * i) - (R * (X - centre) + centre + shift)).norm());
  }
  CHECK(worst < 1e-9);
}

TEST_CASE("pure bending: the moment of the turned end is E I angle / length") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, -0.5}, {4, 1}, {2, 1}}, test::linear_elastic(1000, 0));
  test::at(table, "bodies.foot.mesh.kind") =
      test::text("quad8"); // has the exact solution among its functions
  test::at(table, "obstacles") = test::Input{core::Table{}, "", ""};
  test::at(table, "pairs") = test::Input{core::Table{}, "", ""};
  double const angle = 1e-7;
  auto end = turn("foot.right", {4, 0}, {0, angle});
  test::at(end, "y") = test::values({0, angle * 2}, "m");
  test::at(table, "motions") = test::list({test::fix("foot.left"), end});
  test::at(table, "probes.drive") =
      test::make("probe.force", {{"set", test::text("foot.right")}, {"about", test::values({4, 0}, "m")}});
  auto const bent = twist(scene::build(table), 1, angle);
  double const exact = 1000.0 / 12 * angle / 4;
  REQUIRE(bent.row.size() == 3);
  CHECK(bent.row[2] == doctest::Approx(exact).epsilon(1e-6));
  CHECK(std::abs(bent.row[1]) < 1e-6 * exact);
}

TEST_CASE(
    "a twisted bar: moments balance, and their work is the strain energy, to the order of the trapezia") {
  auto const scene = scene::build(bar(2));
  auto const error = [&](Twisted const& twisted) {
    return std::abs(twisted.work / twisted.state.ledger.strain - 1);
  };
  auto const coarse = twist(scene, 4, 0.8), fine = twist(scene, 8, 0.8);
  CHECK(fine.state.ledger.strain > 1);
  CHECK(error(fine) < 0.01);
  CHECK(std::log2(error(coarse) / error(fine)) == doctest::Approx(2).epsilon(0.1));
  Vec3 const sum = test::moment(scene, fine.state, fine.state.drive);
  CHECK(sum.norm() < 1e-8 * fine.row.back());
  auto const lost = [](Twisted const& twisted) { return twisted.state.ledger.scheme_loss(); };
  CHECK(std::log2(lost(coarse) / lost(fine)) == doctest::Approx(2).epsilon(0.02));
}

TEST_CASE("turns that a scene cannot have") {
  auto table = bar(1);
  auto& motion = test::at(table, "motions[2]");
  auto const wrong = [&](char const* key, test::Input value, std::string const& words) {
    auto const kept = motion;
    test::at(motion, key) = std::move(value);
    auto const all = test::complaints(table);
    REQUIRE(all.size() == 1);
    INFO(all[0]);
    CHECK(all[0].find(words) != std::string::npos);
    CHECK(all[0].find("motions[2]") != std::string::npos);
    motion = kept;
  };
  CHECK(test::complaints(table).empty());
  wrong("axis", test::values({0, 0, 0}), "three numbers, not all 0");
  wrong("centre", test::values({0, 0}, "m"), "three are wanted");
  wrong("angle", test::values({0}, "rad"), "1 values for 2 times");
  wrong("set", test::text("bar.left"), "moves bar.left in x other than motions[1]");
  auto plane = test::foot_on_floor();
  test::at(plane, "motions") = test::list({turn("foot.top", {0, 1}, {0, 1})});
  CHECK(test::complaints(plane).empty());
  test::at(plane, "motions[1].axis") = test::values({1, 0, 0});
  CHECK(test::complaints(plane).front().find("leaves the plane") != std::string::npos);
  test::at(plane, "motions[1].axis") = test::values({0, 0, -1});
  CHECK(test::complaints(plane).empty());
  test::at(plane, "kinematics") = test::text("axisymmetric");
  CHECK(test::complaints(plane).front().find("leave the symmetry") != std::string::npos);
}

TEST_CASE("a turn agrees with a path that says the same, and with a fixed node on its axis") {
  auto table = test::foot_on_floor();
  auto const fixed = [&](double angle) {
    auto held = test::fix("foot.top");
    test::at(held, "near") = test::values({0, 1}, "m");
    test::at(table, "motions") = test::list({held, turn("foot.left", {0, 1}, {0, angle})});
    return test::complaints(table);
  };
  CHECK(fixed(1).empty());
  for (int const turns : {1, 2, 4, 6}) { // back where it was at the end, in the middle, at thirds of the way
    CAPTURE(turns);
    auto const whole = turn("foot.left", {0.5, 0.5}, {0, 2 * std::numbers::pi * turns});
    test::at(table, "motions") = test::list({test::fix("foot.top"), whole});
    REQUIRE(test::complaints(table).size() == 1);
    CHECK(test::complaints(table)[0].find("moves foot.left in x other than") != std::string::npos);
  }
}

TEST_SUITE_END();
