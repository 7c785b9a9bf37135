// Runs that have no single answer say so, and those that have one do not.
#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "folder.hpp"
#include "record/problem_file.hpp"
#include "scene/run/run.hpp"
#include "scene/run/solve.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

scene::RunResult run(test::Input const& table, test::Folder const& folder) {
  scene::RunOptions options;
  options.out = folder / "case";
  return scene::run(table, options);
}

/// A bar of two cells, 1 m long, on RCC bonds without viscosity, pulled off; E / L = ratio C.
test::Input pulled_bar(double ratio) {
  double const C = 1e5;
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {2, 4}}, test::linear_elastic(ratio * C, 0));
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, C, 0);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(1);
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1}, {}, {0, 0.01}), test::fix("foot.all", true, false)});
  test::at(table, "schedule") = test::schedule({{1, 50}});
  return table;
}

/// A stiff thin rod, 1 m long, upright on a plane whose slope is 1/2 and along which it slides, m/s > 0:
/// down.
test::Input rod(double mu, double slide) {
  auto table = test::make("scene");
  test::at(table, "bodies.rod") = test::block({{0, 0}, {0.01, 1}, {1, 20}}, test::linear_elastic(1e9, 0), 1);
  test::at(table, "bodies.rod.velocity") = test::values({0.9 * slide - 0.045, -0.45 * slide - 0.09}, "m/s");
  test::at(table, "obstacles.floor") =
      test::make("obstacle", {{"shape", test::make("rigid.plane", {{"normal", test::values({0.5, 1})}})}});
  test::at(table, "pairs.tip") = test::pair("rod.bottom", "floor");
  test::at(table, "pairs.tip.friction") = test::coulomb(mu);
  test::at(table, "scheme") =
      test::make("scheme.theta_xi", {{"theta", test::value(1)}, {"xi", test::value(1)}});
  test::at(table, "schedule") = test::schedule({{0.04, 4}});
  // what rounding leaves of forces from 1e10 N/m and a way of centimetres is 4e-7 of them
  test::at(table, "control") = test::make("control", {{"force_tolerance", test::value(1e-6)}});
  return table;
}

std::string all(std::vector<std::string> const& texts) {
  std::string joined;
  for (auto const& text : texts)
    joined += text + "\n";
  return joined;
}

} // namespace

TEST_CASE("a bar of E / L = 2 C on softening bonds snaps and the run says so, one of 4 C does not") {
  test::Folder const folder;
  auto const snaps = run(pulled_bar(2), folder);
  CHECK(snaps.verdict == "finished");
  REQUIRE(snaps.remarks.size() == 1);
  CAPTURE(snaps.remarks[0]);
  CHECK(snaps.remarks[0].find("of pair sole") != std::string::npos);
  CHECK(snaps.remarks[0].find("snap") != std::string::npos);
  CHECK(snaps.remarks[0].find("of 50 steps)") != std::string::npos);
  auto const manifest = nlohmann::json::parse(std::ifstream(folder / "case/manifest.json"));
  CHECK(manifest.at("remarks").at(0) == snaps.remarks[0]);
  auto const follows = run(pulled_bar(4), folder);
  CHECK(follows.verdict == "finished");
  CHECK(all(follows.remarks) == "");
  CHECK_FALSE(nlohmann::json::parse(std::ifstream(folder / "case/manifest.json")).contains("remarks"));
}

TEST_CASE(
    "friction that falls with speed leaves a long column in short steps more answers than one and says so") {
  test::Folder const folder;
  // p_n (mu_s - mu_k) / (v_ref dt): a tenth of the shear stiffness, a hundred times it
  for (double const seconds : {10.0, 1e-2}) {
    auto table = test::foot_on_floor();
    test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {1, 2}}, test::linear_elastic(1e5, 0));
    test::at(table, "pairs.sole.friction") = test::make(
        "friction.velocity",
        {{"mu_s", test::value(0.6)}, {"mu_k", test::value(0.1)}, {"v_ref", test::value(1e-3, "m/s")}});
    test::at(table, "motions") =
        test::list({test::drive("foot.top", {0, 10 * seconds}, {0, 0.01}, {0, -1e-3})});
    test::at(table, "schedule") = test::schedule({{10 * seconds, 10}});
    auto const result = run(table, folder);
    CAPTURE(all(result.remarks));
    CHECK((all(result.remarks).find("by which friction may fall per slip") != std::string::npos) ==
          (seconds < 1));
  }
}

TEST_CASE("a tilted rod that slides with more friction than 4/3 is remarked on, with less it is not") {
  test::Folder const folder;
  auto const jams = run(rod(1.6, -1), folder);
  CAPTURE(all(jams.remarks));
  REQUIRE(jams.remarks.size() == 1);
  CHECK(jams.remarks[0].find("mu |W_nt|") != std::string::npos);
  CHECK(jams.remarks[0].find("mu below 1.3") != std::string::npos);
  CHECK(jams.remarks[0].find("; here only this one was found") != std::string::npos); // it slides freely
  CHECK(all(run(rod(1.2, -1), folder).remarks) == "");
}

TEST_CASE("a rod that slides downhill jams with more friction than 4/3, and the run says why") {
  test::Folder const folder;
  auto const jams = run(rod(1.6, 1), folder);
  CAPTURE(all(jams.remarks));
  REQUIRE(jams.remarks.size() == 2);
  CHECK(jams.remarks[0].find("more than one answer, or none") != std::string::npos);
  CHECK(std::regex_search(jams.remarks[0], std::regex("; here (it is|none|only|all|\\d+ answers)")));
  CHECK(jams.remarks[1].find("lost energy") != std::string::npos); // it stands still at once
  auto const slides = run(rod(1.2, 1), folder);
  CHECK(slides.cuts == 0);
  CHECK(all(slides.remarks).find("answer") == std::string::npos);
}

TEST_CASE("solving a saved problem tells of what theory does not promise") {
  test::Folder const folder;
  auto table = rod(1.6, -1);
  test::at(table, "output") = test::make("output", {{"problems_every", test::value(1)}});
  static_cast<void>(run(table, folder));
  auto const report = scene::solve_file(folder / "case/problems/000001.h5", "all", 1e-8);
  INFO(report.text);
  REQUIRE(report.doubts.size() == 1);
  CHECK(report.text.find(report.doubts[0]) != std::string::npos);
  CHECK(report.doubts[0].find("contact 1 (1 such): W_nn") != std::string::npos);
  CHECK(report.answers.size() == 3);
  CHECK(report.contacts == 1);
}

TEST_CASE("solvers that answer a saved problem differently are told, and only those: none without friction") {
  test::Folder const folder;
  Eigen::Matrix<double, 6, 1> mobility, velocity;
  mobility << 1, 1, 1, 2.5, 2.5, 1.7; // of a rigid box, that comes down on 50 points and slides
  velocity << 1, 0, -1, 0.3, -0.1, 1;
  int told = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    double const mu = seed <= 6 ? 0.8 : 0;
    auto const any = [&] { return 2.0 * static_cast<double>(random()) / 4294967296.0 - 1; };
    Dense H(150, 6);
    contact::Problem problem;
    problem.dim = 3;
    for (Index k = 0; k < 50; ++k) {
      double const x = any(), y = any(), z = -1;
      H.middleRows<3>(3 * k) << 0, 0, 1, y, -x, 0, 1, 0, 0, 0, z, -y, 0, 1, 0, -z, 0, x;
      problem.points.push_back({1, mu, -1, {}});
    }
    problem.W = Dense(H * mobility.asDiagonal() * H.transpose());
    problem.free = H * velocity;
    record::save_problem(folder / "box.h5", problem);
    auto const report = scene::solve_file(folder / "box.h5", "all", 1e-10);
    REQUIRE(report.converged);
    bool differ = false;
    for (auto const& answer : report.answers)
      differ = differ || (answer.displacement - report.answers[0].displacement).norm() >
                             1e-2 * report.answers[0].displacement.norm();
    bool const says = report.text.find("answer differently") != std::string::npos;
    CHECK((says || !differ));
    CHECK_FALSE((says && mu == 0));
    told += says ? 1 : 0;
  }
  CHECK(told > 0);
}

TEST_CASE(
    "a rod that flies off keeps its energy, one that is stopped in four steps loses it and the run says so") {
  test::Folder const folder;
  auto const remarks = [&](double speed) {
    auto table = rod(0.1, 0);
    test::at(table, "bodies.rod.velocity") = test::values({0.0, speed}, "m/s");
    return all(run(table, folder).remarks);
  };
  CHECK(remarks(1).find("energy") == std::string::npos);
  CHECK(remarks(1).find("pair tip: nothing of it touched") == 0);
  CHECK(remarks(-1).find("lost energy") != std::string::npos);
  CHECK(remarks(-1).find("nothing of it touched") == std::string::npos);
}

TEST_CASE("tolerances below what rounding allows are met as far as it goes and the run says so") {
  test::Folder const folder;
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.mesh.origin") = test::values({7, 0}, "m");
  test::at(table, "bodies.foot.material") =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  CHECK(all(run(table, folder).remarks) == "");
  test::at(table, "control") = test::make("control", {{"force_tolerance", test::value(1e-16)}});
  for (char const* kind : {"newton", "uzawa", "gauss_seidel"}) {
    CAPTURE(std::string(kind));
    test::at(table, "solver") =
        test::make(std::string("solver.") + kind, {{"tolerance", test::value(1e-16)}});
    auto const result = run(table, folder);
    CHECK(result.verdict == "finished");
    CHECK(result.cuts == 0);
    auto const said = all(result.remarks);
    CAPTURE(said);
    CHECK(said.find("control.force_tolerance = 1e-16 is less than rounding allows") != std::string::npos);
    CHECK(said.find("solver.tolerance = 1e-16 is less than rounding allows") != std::string::npos);
  }
}
