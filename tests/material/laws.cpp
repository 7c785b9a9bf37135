// Properties that every bulk law must have: derivatives with their rate, rest, isotropy, the small-strain
// limit.
#include <Eigen/LU>
#include <doctest/doctest.h>

#include "differences.hpp"
#include "material/states.hpp"

using namespace stiction;
using namespace stiction::material;
using stiction::test::each_law;
using stiction::test::green;
using stiction::test::rotation;
using stiction::test::states;
using stiction::test::tensor;

namespace {

VoigtMatrix<6> hooke_matrix(Moduli const& moduli) {
  double const G = moduli.young / (2 * (1 + moduli.poisson));
  double const lame = 2 * G * moduli.poisson / (1 - 2 * moduli.poisson);
  VoigtMatrix<6> D = VoigtMatrix<6>::Zero();
  D.topLeftCorner<3, 3>().setConstant(lame);
  D.diagonal() << lame + 2 * G, lame + 2 * G, lame + 2 * G, G, G, G;
  return D;
}

template<int N, class Law> void check_derivatives(Law const& law) {
  for (auto const& F : states<N>()) {
    Voigt<N> const E = green<N>(F);
    auto const at = law.template respond<N>(E);
    double const modulus = law.moduli().young + at.tangent.cwiseAbs().maxCoeff();
    auto const energy = [&](Vector const& e) {
      return Vector::Constant(1, law.template respond<N>(Voigt<N>(e)).energy).eval();
    };
    auto const stress = [&](Vector const& e) { return Vector(law.template respond<N>(Voigt<N>(e)).stress); };
    auto const first = test::rate(energy, at.stress.transpose(), E, 1e-3, modulus);
    auto const second = test::rate(stress, at.tangent, E, 1e-3, modulus);
    INFO(law.schema().name << ", N = " << N << ", F =\n" << F);
    CHECK_MESSAGE(first.second_order, "stress: " << first.words());
    CHECK_MESSAGE(second.second_order, "tangent: " << second.words());
    CHECK(first.errors[2] < 1e-5 * modulus);
    CHECK(second.errors[2] < 1e-4 * modulus);
    CHECK((at.tangent - at.tangent.transpose()).norm() <= 1e-14 * at.tangent.norm());
  }
}

} // namespace

TEST_SUITE("material") {
  TEST_CASE("stress and tangent are derivatives, the error falls with the square of the step") {
    each_law([](auto const& law) {
      check_derivatives<4>(law);
      check_derivatives<6>(law);
    });
  }

  TEST_CASE("at rest energy and stress vanish, and the tangent is Hooke's with the law's own moduli") {
    each_law([](auto const& law) {
      CAPTURE(law.schema().name);
      auto const rest = law.template respond<6>(Voigt<6>(Voigt<6>::Zero()));
      Moduli const moduli = law.moduli();
      CHECK(std::abs(rest.energy) <= 1e-14 * moduli.young);
      CHECK(rest.stress.norm() <= 1e-14 * moduli.young);
      CHECK((rest.tangent - hooke_matrix(moduli)).norm() <= 1e-12 * moduli.young);
      CHECK(moduli.bulk() == doctest::Approx(moduli.lame() + 2 * moduli.shear() / 3));
    });
  }

  TEST_CASE("energy is positive away from rest") {
    each_law([](auto const& law) {
      auto const all = states<6>();
      for (std::size_t i = 1; i < all.size(); ++i)
        CHECK(law.template respond<6>(green<6>(all[i])).energy > 0);
    });
  }

  TEST_CASE("a rotation before or after the deformation changes no energy") {
    each_law([](auto const& law) {
      Matrix3 const Q = rotation();
      for (auto const& F : states<6>()) {
        CAPTURE(law.schema().name);
        auto const plain = law.template respond<6>(green<6>(F));
        auto const after = law.template respond<6>(green<6>(Q * F));  // objectivity
        auto const before = law.template respond<6>(green<6>(F * Q)); // isotropy
        double const size = plain.stress.norm() + law.moduli().young;
        CHECK(std::abs(after.energy - plain.energy) <= 1e-12 * size);
        CHECK((after.stress - plain.stress).norm() <= 1e-12 * size);
        CHECK(std::abs(before.energy - plain.energy) <= 1e-12 * size);
        CHECK((tensor(before.stress) - Q.transpose() * tensor(plain.stress) * Q).norm() <= 1e-12 * size);
      }
    });
  }

  TEST_CASE("four components answer as six do when there is no shear out of the plane") {
    each_law([](auto const& law) {
      for (auto const& F : states<4>()) {
        auto const four = law.template respond<4>(green<4>(F));
        auto const six = law.template respond<6>(green<6>(F));
        double const size = six.tangent.norm();
        CHECK(four.energy == doctest::Approx(six.energy).epsilon(1e-13));
        CHECK((four.stress - six.stress.template head<4>()).norm() <= 1e-14 * size);
        CHECK((four.tangent - six.tangent.template topLeftCorner<4, 4>()).norm() <= 1e-14 * size);
        CHECK(six.stress.template tail<2>().norm() <= 1e-14 * size);
        CHECK((six.tangent.template topRightCorner<4, 2>().norm()) <= 1e-14 * size);
      }
    });
  }

  TEST_CASE("small strains: the stress leaves Hooke's at second order") {
    Voigt<6> const direction = (Voigt<6>() << 0.3, -0.5, 0.2, 0.4, -0.1, 0.25).finished();
    each_law([&](auto const& law) {
      CAPTURE(law.schema().name);
      auto const hooke = hooke_matrix(law.moduli());
      auto const error = [&](double e) -> double {
        return (law.template respond<6>(Voigt<6>(e * direction)).stress - e * (hooke * direction)).norm();
      };
      double const coarse = error(1e-3), fine = error(1e-4);
      CHECK(fine <= std::max(coarse / 80, 1e-13 * law.moduli().young));
    });
  }
}
