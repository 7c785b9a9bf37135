// Mixing of corrections: what a matrix that lacks a part of the derivative makes of linear and bent balances.
#include <doctest/doctest.h>

#include "dynamics/step/mixing.hpp"

using namespace stiction;

namespace {

/// Corrections until what is left is small; most if they lead nowhere. left(k): what the matrix leaves of the
/// k-th part of an error, a factor; bent: part of the factor that grows with the error.
template<class Left> int corrections(Left const& left, double bent, bool mixed) {
  constexpr int most = 40;
  Vector error = Vector::LinSpaced(50, 1, 2);
  dynamics::Mixing mixing;
  for (int made = 0; made < most; ++made) {
    if (error.norm() < 1e-9)
      return made;
    Vector correction(error.size());
    for (Eigen::Index k = 0; k < error.size(); ++k)
      correction[k] = -(1 - left(k) - bent * error[k]) * error[k];
    if (mixed)
      mixing.mix(correction);
    error += correction;
  }
  return most;
}

} // namespace

TEST_CASE("mixed corrections find back from a few directions in which an iteration leads away") {
  auto const astray = [](Eigen::Index k) { return k == 3 ? -1.6 : k == 20 ? 1.8 : k == 41 ? -3.0 : 0.0; };
  CHECK(corrections(astray, 0, false) == 40);
  CHECK(corrections(astray, 0, true) <= 6);
  auto const also_slow = [&](Eigen::Index k) { return k % 10 == 5 ? 0.1 : astray(k); };
  CHECK(corrections(also_slow, 0, true) <= 10);
  CHECK(corrections(astray, 1e-3, false) == 40);
  CHECK(corrections(astray, 1e-3, true) <= 14);
}

TEST_CASE("mixing leaves an exact correction as it is, and forgets") {
  dynamics::Mixing mixing;
  Vector first = Vector::Constant(4, 2.0), second = Vector::Constant(4, 1.0);
  mixing.mix(first);
  CHECK(first == Vector::Constant(4, 2.0));
  mixing.clear();
  mixing.mix(second);
  CHECK(second == Vector::Constant(4, 1.0));
}
