// Problems saved by runs: all solvers agree where an answer is due, and none lies where it is not.
#include <doctest/doctest.h>

#include "contact/saved.hpp"
#include "contact/solvers.hpp"
#include "contact/solvers/mixed_sweeps.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

TEST_SUITE("contact") {
  TEST_CASE("saved problems of a plate sliding on a cylinder, and of a 3D block: all solvers agree") {
    for (auto const* name :
         {"plate_mu00_descent", "plate_mu00_slide", "plate_mu04_descent", "plate_mu04_slide",
          "plate_mu04_end", "plate_mu08_descent", "plate_mu08_slide", "block_3d_flat"}) {
      auto const problem = saved(name);
      REQUIRE(problem.size() > 5);
      auto const newton = solve(BipotentialNewton{}, problem);
      for (auto const& [solver, choice] : all_solvers()) {
        INFO(name << ", " << solver);
        auto const answer = solve(choice, problem);
        CHECK(answer.converged);
        CHECK(answer.verdict.relative() <= 1e-10);
        CHECK((answer.force - newton.force).norm() <= 1e-6 * newton.force.norm());
      }
      CHECK(newton.iterations <= (plain(problem) && problem.free.size() >= 60 ? 40 : 10)); // sweeps, steps
    }
  }

  TEST_CASE("the saved problems hold what they are named for") {
    CHECK(saved("plate_mu00_slide").points[0].mu == 0);
    CHECK(saved("plate_mu04_slide").points[0].mu == 0.4);
    CHECK(saved("plate_mu08_slide").points[0].mu == 0.8);
    CHECK(saved("plate_mu04_slide").dim == 2);
    CHECK(saved("block_3d_flat").dim == 3);
    CHECK(std::get<interface::Rcc>(saved("plate_mu04_slide").adhesions.at(0)).w == 20);
    auto const sliding = saved("plate_mu04_end");
    auto const answer = solve(BipotentialNewton{}, sliding);
    int slides = 0;
    Vector const x = displacement(sliding, answer.force);
    for (Index i = 0; i < sliding.size(); ++i)
      slides += answer.force[2 * i] > 0 && std::abs(x[2 * i + 1]) > 1e-7 ? 1 : 0;
    CHECK(slides > 0);
  }

  TEST_CASE("a body that hardly gives way in volume: Newton stagnates and sweeps finish") {
    auto const problem = saved("nearly_incompressible");
    auto const answer = solve(BipotentialNewton{}, problem);
    CHECK(answer.converged);
    CHECK(answer.iterations > 60);
    auto const swept = solve(GaussSeidel{}, problem);
    CHECK((answer.force - swept.force).norm() <= 1e-6 * swept.force.norm());
  }

  TEST_CASE("an indefinite W: an answer is judged, its absence admitted, and nothing overflows") {
    for (auto const* name : {"plate_mu08_indefinite", "plate_mu08_indefinite_late"}) {
      auto const problem = saved(name);
      int answered = 0;
      for (auto const& [solver, choice] : all_solvers()) {
        INFO(name << ", " << solver);
        auto const answer = solve(choice, problem);
        CHECK(answer.force.allFinite());
        CHECK(std::isfinite(answer.verdict.relative()));
        CHECK(answer.converged == (judge(problem, answer.force).relative() <= 1e-10));
        answered += answer.converged ? 1 : 0;
      }
      CHECK(answered >= 1);
    }
  }
}
