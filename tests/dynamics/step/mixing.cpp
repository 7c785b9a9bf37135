// Mixed iterations with an inexact inverse end where plain ones go.
#include "dynamics/step/mixing.hpp"

#include <doctest/doctest.h>

using namespace stiction;
using namespace stiction::dynamics;

TEST_SUITE("dynamics") {
  TEST_CASE("iterations that leave few parts of what was wrong are mixed to the end in as many") {
    Vector left(9); // of the imbalance after a plain iteration
    left << 0.5, -0.3, 0.2, 0.5, -0.3, 0.2, 0.5, -0.3, 0.2;
    Vector const end = Vector::LinSpaced(9, -1, 2);
    for (bool const mixed : {false, true}) {
      Mixing mixing;
      Vector x = Vector::Zero(9), imbalance = -end;
      for (int k = 0; k < 5; ++k) {
        Vector correction = -(Vector::Ones(9) - left).cwiseProduct(imbalance);
        Vector forces = x + correction; // what comes along is mixed in the same parts
        if (mixed)
          mixing.mix(imbalance, correction, forces);
        x += correction;
        CHECK((forces - x).norm() <= 1e-12);
        imbalance = x - end;
      }
      CHECK((imbalance.norm() <= 1e-12) == mixed);
      CHECK(imbalance.norm() <= 0.04 * end.norm());
    }
  }

  TEST_CASE("what has another size, or is forgotten, is not mixed") {
    Mixing mixing;
    Vector const imbalance = Vector::LinSpaced(4, 1, 2);
    auto const kept = [&](Eigen::Index points, double factor) {
      Vector correction = factor * Vector::Ones(4), forces = Vector::Ones(points);
      mixing.mix(factor * imbalance, correction, forces);
      return correction == Vector(factor * Vector::Ones(4));
    };
    CHECK(kept(2, 1));
    CHECK_FALSE(kept(2, 0.5));
    CHECK(kept(3, 0.25));
    mixing.forget();
    CHECK(kept(3, 0.1));
  }
}
