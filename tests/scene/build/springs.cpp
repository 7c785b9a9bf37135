// Springs of a scene: what they are made of, what they cannot be, what explain and probes say of them.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"
#include "scene/complaints.hpp"
#include "scene/explain/explain.hpp"
#include "scene/probes/probes.hpp"

using namespace stiction;

namespace {

test::Input spring(std::string from, core::Table entries = {}) {
  entries["from"] = test::text(std::move(from));
  entries.try_emplace("stiffness", test::value(2, "N/m"));
  return test::make("spring", std::move(entries));
}

test::Input held_foot(test::Input one) {
  auto table = test::foot_on_floor();
  test::at(table, "springs.tie") = std::move(one);
  return table;
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("the mean of a surface is by area, of other sets by mass") {
  auto table = held_foot(spring("foot.left"));
  auto const one = scene::build(table).model->springs[0];
  REQUIRE(one.from.nodes.size() == 5);
  std::vector<double> shares = one.from.shares;
  std::sort(shares.begin(), shares.end());
  CHECK(shares.front() == doctest::Approx(0.125));
  CHECK(shares.back() == doctest::Approx(0.25));
  CHECK(one.from.at.isApprox(Eigen::Vector3d(0, 0.5, 0)));
  test::at(table, "springs.tie.from") = test::text("foot.all");
  auto const all = scene::build(table).model->springs[0];
  CHECK(all.from.at.isApprox(Eigen::Vector3d(0.5, 0.5, 0)));
  CHECK(*std::max_element(all.from.shares.begin(), all.from.shares.end()) == doctest::Approx(1.0 / 16));
}

TEST_CASE("about an axis a mean acts along the axis, a bedding along both") {
  auto table = held_foot(spring("foot.top"));
  test::at(table, "kinematics") = test::text("axisymmetric");
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  CHECK(scene::build(table).model->springs[0].axes.isApprox(Eigen::Vector3d(0, 1, 0)));
  test::at(table, "springs.tie.axes") = test::values({1, 0});
  REQUIRE(test::complaints(table).size() == 1);
  CHECK(test::complaints(table)[0].find("mean of a ring does not move") != std::string::npos);
  test::at(table, "springs.tie.spread") = test::flag(true);
  CHECK(test::complaints(table).empty());
}

TEST_CASE("what springs cannot be is told once, with the remedy") {
  auto const wrong = [](core::Table entries, std::string const& words, std::string from = "foot.left") {
    auto const all = test::complaints(held_foot(spring(from, std::move(entries))));
    CAPTURE(words);
    REQUIRE(all.size() == 1);
    INFO(all[0]);
    CHECK(all[0].find(words) != std::string::npos);
    CHECK(all[0].find("springs.tie") != std::string::npos);
  };
  using test::text, test::value, test::values, test::flag;
  CHECK(test::complaints(held_foot(spring("foot.left"))).empty());
  wrong({{"stiffness", value(0, "N/m")}}, "neither pulls nor damps");
  wrong({{"stiffness", value(-1, "N/m")}}, "it must be >= 0 N/m");
  wrong({{"damping", value(1, "N s/m")}}, "quasi-static run has no rates");
  wrong({}, "did you mean \"foot.left\"", "foot.leff");
  wrong({}, "obstacle that its paths carry", "floor");
  wrong({{"to", text("foot.left")}}, "is `from` itself");
  wrong({{"to", text("flor")}}, "did you mean \"floor\"");
  wrong({{"to", text("floor")}, {"anchor", values({0, 0}, "m")}}, "`to` names the other end");
  wrong({{"anchor", values({0, 0, 0}, "m")}}, "two are wanted");
  wrong({{"times", values({0, 2}, "s")}}, "has no values beside it");
  wrong({{"times", values({0, 1}, "s")}, {"x", values({0, 1}, "m")}}, "before the run does");
  wrong({{"direction", values({0, 0})}}, "is no direction");
  wrong({{"direction", values({1, 0})}, {"along", text("line")}}, "leave one of them out");
  wrong({{"direction", values({1, 0})}, {"axes", values({1, 0})}}, "for springs along the axes");
  wrong({{"axes", values({1, -1})}}, "at least 0");
  wrong({{"along", text("line")}}, "both ends are at the same place");
  wrong({{"rest", value(1, "m")}}, "along a line or a direction");
  wrong({{"spread", flag(true)}, {"along", text("line")}, {"anchor", values({-1, 0}, "m")}},
        "axes or a direction");
  wrong({{"spread", flag(true)}, {"to", text("foot.right")}}, "nodes of a set and a place");
  auto table = held_foot(spring("foot.left"));
  test::at(table, "probes.pull") = test::make("probe.spring", {{"spring", text("tye")}});
  REQUIRE(test::complaints(table).size() == 1);
  CHECK(test::complaints(table)[0].find("did you mean \"tie\"") != std::string::npos);
  table = held_foot(spring("foot.left", {{"damping", value(1, "N s/m")}}));
  test::at(table, "scheme") = test::make("scheme.central_difference");
  CHECK(test::complaints(table)[0].find("lag by a step") != std::string::npos);
}

TEST_CASE("a body is held at rest by springs alone, where they resist every rigid motion") {
  auto table = held_foot(spring("foot.left", {{"spread", test::flag(true)}}));
  test::at(table, "motions") = test::list({});
  CHECK(test::complaints(table).empty());
  test::at(table, "springs.tie.spread") = test::flag(false);
  REQUIRE(test::complaints(table).size() == 1);
  CHECK(test::complaints(table)[0].find("can turn: no motion holds it, nor a spring") != std::string::npos);
  test::at(table, "springs.other") = spring("foot.right", {{"direction", test::values({0, 1})}});
  CHECK(test::complaints(table).empty());
  test::at(table, "springs.other.stiffness") = test::value(0.9e-4, "N/m"); // E = 1000 Pa: as good as none
  REQUIRE(test::complaints(table).size() == 1);
  test::at(table, "springs.other.stiffness") = test::value(1.1e-4, "N/m");
  CHECK(test::complaints(table).empty());
}

TEST_CASE("a probe shows force, elongation and energy of a spring, and explain what it is") {
  auto table = held_foot(spring("foot.left", {{"anchor", test::values({-3, 0.5}, "m")},
                                              {"direction", test::values({2, 0})},
                                              {"rest", test::value(-2.5, "m")}}));
  test::at(table, "motions") = test::list({test::fix("foot.all")});
  test::at(table, "probes.pull") = test::make("probe.spring", {{"spring", test::text("tie")}});
  auto const scene = scene::build(table);
  std::vector<std::string> names;
  auto const samplers =
      scene::add_probes(scene, scene::Columns{[&](auto const&, auto const& column, auto const&, auto const&,
                                                  int) { names.push_back(column); },
                                              [](auto const&, auto const&, double) {}});
  dynamics::Stepper stepper(*scene.model);
  std::vector<double> row;
  auto const start = stepper.initial();
  samplers[0](start, row);
  CHECK(names == std::vector<std::string>{"force_x", "force_y", "elongation", "energy"});
  REQUIRE(row.size() == 4);
  CHECK(row[0] == doctest::Approx(2 * -0.5));
  CHECK(row[1] == 0);
  CHECK(row[2] == doctest::Approx(-0.5));
  CHECK(row[3] == doctest::Approx(0.25));
  CHECK(start.ledger.start == doctest::Approx(0.25));
  std::string words;
  for (auto const& section : scene::explain(scene).sections)
    if (section.title == "Spring tie")
      for (auto const& line : section.lines)
        words += line.name + " " + line.words + "\n";
  CHECK(words.find("the mean of 5 nodes of foot.left and a place, along the direction (2, 0)") !=
        std::string::npos);
  CHECK(words.find("stiffness 2 N/m^2") != std::string::npos);
}

TEST_SUITE_END();
