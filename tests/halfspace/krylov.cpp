// Systems of a half space that is about to snap.
#include "halfspace/krylov.hpp"

#include <cmath>
#include <doctest/doctest.h>

#include "halfspace/green.hpp"

using namespace stiction;
using halfspace::Compliance;
using halfspace::Surface;

namespace {

/// Points within a disc that soften, all alike: 1 / B = W_own + S.
halfspace::Linearised<1> softening(Surface const& surface, double radius, double S) {
  halfspace::Linearised<1> system;
  system.own = surface.delassus().block<1>(0);
  for (Index i = 0; i < surface.grid().size(); ++i) {
    if (std::hypot(surface.grid().x(i), surface.grid().y(i)) > radius)
      continue;
    system.points.push_back(i);
    system.B.emplace_back(halfspace::LocalMatrix<1>(1 / (system.own(0, 0) + S)));
    system.yields.push_back(false);
  }
  system.definite = false;
  return system;
}

/// What is left of the right side.
double residual(Surface const& surface, halfspace::Linearised<1> const& system, Vector const& right,
                Vector const& force) {
  Vector all = Vector::Zero(surface.rows()), moved = all;
  halfspace::scatter<1>(system.points, force, all);
  surface.add_product(all, moved);
  Vector left = right;
  for (Index k = 0; k < system.size(); ++k)
    left[k] -= force[k] + system.B[ix(k)](0, 0) * (moved[system.points[ix(k)]] - system.own(0, 0) * force[k]);
  return left.norm() / right.norm();
}

} // namespace

/// Some ways of the disc give, others hold: restarts after few vectors would go round without end.
TEST_CASE("a disc of a half space that is about to snap is solved") {
  Surface const surface({64, 64, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  double const own = surface.delassus().block<1>(0)(0, 0);
  for (double const S : {-2.8, -3.0, -3.2}) {
    CAPTURE(S);
    auto const system = softening(surface, 0.3, S * own);
    Vector const right = Vector::LinSpaced(system.size(), 1, 2);
    halfspace::Krylov<1> krylov(surface, system, false);
    auto const made = krylov.solve(right, 0, 1e-6, 200);
    CHECK(residual(surface, system, right, made.force) < 1e-6);
  }
}

/// A counterpart that a force moves, and that is held or not: forces and lift keep both equations, whether
/// the points only yield or some soften.
TEST_CASE("systems of a half space with a lift are solved, held or not") {
  Surface const surface({32, 32, 1, 1, false, false}, Compliance::of({1e4, 0.2, 0}, nullptr), 1);
  double const own = surface.delassus().block<1>(0)(0, 0), total = 7;
  for (bool const definite : {true, false})
    for (double const held : {0.0, 3e3, 3e5}) {
      CAPTURE(definite);
      CAPTURE(held);
      auto system = softening(surface, 0.3, definite ? 0.5 * own : -1.5 * own);
      system.definite = definite;
      system.softness = 0.5 * own;
      system.yields.assign(system.points.size(), definite);
      Vector const right = Vector::LinSpaced(system.size(), 1, 2);
      auto const made = halfspace::Krylov<1>(surface, system, true, held).solve(right, total, 1e-9, 400);
      Vector without = right;
      for (Index k = 0; k < system.size(); ++k)
        without[k] -= system.B[ix(k)](0, 0) * made.lift;
      CHECK(residual(surface, system, without, made.force) * without.norm() < 1e-7 * right.norm());
      CHECK(made.force.sum() - held * made.lift == doctest::Approx(total).epsilon(1e-6));
    }
}
