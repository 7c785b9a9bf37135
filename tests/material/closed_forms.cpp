// Closed forms of single laws, and the way of each script parameter to its formula.
#include <cmath>
#include <doctest/doctest.h>

#include "core/reader.hpp"
#include "material/states.hpp"

using namespace stiction;
using namespace stiction::material;
using stiction::test::cauchy;
using stiction::test::respond;
using stiction::test::shear;
using stiction::test::tensor;

namespace {

/// Reads a law from a script table of SI numbers.
template<class Law> Law read(std::vector<std::pair<std::string, double>> const& values) {
  core::Table table;
  for (auto const& [name, number] : values)
    table[name] = {core::Quantity{number, core::parse_unit(Law::schema().find(name)->unit)->dimension}, "",
                   ""};
  core::Input const input{table, "", ""};
  core::Complaints complaints;
  Law const law = core::Reader(input, "", complaints).record<Law>();
  CHECK(complaints.empty());
  return law;
}

} // namespace

TEST_SUITE("material") {
  TEST_CASE("Blatz-Ko in uniaxial tension: P = G (l^-1/2 - l^-3), free sides at l^-1/4") {
    BlatzKo const law{3.2e6};
    for (double const l : {0.4, 0.8, 1.0, 1.5, 3.0}) {
      Matrix3 F = Matrix3::Identity() * std::pow(l, -0.25);
      F(0, 0) = l;
      Matrix3 const P = F * tensor(respond(law, F).stress);
      double const exact = law.shear_modulus * (1 / std::sqrt(l) - 1 / (l * l * l));
      CHECK(F.determinant() == doctest::Approx(std::sqrt(l)).epsilon(1e-14));
      CHECK(std::abs(P(0, 0) - exact) <= 1e-10 * law.shear_modulus);
      CHECK(std::abs(P(1, 1)) + std::abs(P(2, 2)) <= 1e-10 * law.shear_modulus);
    }
  }

  TEST_CASE("Blatz-Ko in simple shear: s12 = G g, s22 = -G g^2, s11 = s33 = 0") {
    BlatzKo const law{3.2e6};
    double const G = law.shear_modulus;
    for (double const g : {0.1, 1.0, 2.5}) {
      Matrix3 exact = Matrix3::Zero();
      exact(0, 1) = exact(1, 0) = G * g;
      exact(1, 1) = -G * g * g;
      CHECK((cauchy(law, shear(g)) - exact).norm() <= 1e-10 * G);
    }
  }

  TEST_CASE("neo-Hookean: G g in shear, K (J - 1) in swelling, W by hand in between") {
    NeoHookean const law{5e6, 0.4};
    double const G = 5e6 / 2.8, K = 5e6 / 0.6;
    CHECK(cauchy(law, shear(0.7))(0, 1) == doctest::Approx(G * 0.7).epsilon(1e-13));
    Matrix3 const swollen = cauchy(law, 1.2 * Matrix3::Identity());
    CHECK((swollen - K * (1.2 * 1.2 * 1.2 - 1) * Matrix3::Identity()).norm() <= 1e-12 * K);
    Matrix3 F = Matrix3::Identity();
    F.diagonal() << 1.5, 0.9, 0.8;
    double const J = 1.5 * 0.9 * 0.8, I1 = 1.5 * 1.5 + 0.81 + 0.64;
    CHECK(
        respond(law, F).energy ==
        doctest::Approx(G / 2 * (std::pow(J, -2.0 / 3) * I1 - 3) + K / 2 * (J - 1) * (J - 1)).epsilon(1e-13));
  }

  TEST_CASE("St Venant-Kirchhoff: S = lambda tr E I + 2 G E at any strain, linear elasticity the same of its "
            "strain") {
    double const E = 3e6, nu = 0.2, lame = E * nu / (1.2 * 0.6), G = E / 2.4;
    Matrix3 const F = (Matrix3() << 1.4, 0.3, 0, 0.1, 0.7, 0.2, 0, -0.1, 1.1).finished();
    Matrix3 const strain = 0.5 * (F.transpose() * F - Matrix3::Identity());
    Matrix3 const exact = lame * strain.trace() * Matrix3::Identity() + 2 * G * strain;
    CHECK((tensor(respond(StVenantKirchhoff{E, nu}, F).stress) - exact).norm() <= 1e-12 * E);
    CHECK((tensor(respond(LinearElastic{E, nu}, F).stress) - exact).norm() <= 1e-12 * E);
    CHECK(respond(StVenantKirchhoff{E, nu}, F).energy ==
          doctest::Approx(lame / 2 * strain.trace() * strain.trace() + G * strain.squaredNorm()));
  }

  TEST_CASE("each script parameter reaches its own member") {
    auto const check = [](auto const& law) {
      CHECK(law.moduli().young == 7e6);
      CHECK(law.moduli().poisson == 0.2);
    };
    check(read<LinearElastic>({{"young", 7e6}, {"poisson", 0.2}}));
    check(read<StVenantKirchhoff>({{"young", 7e6}, {"poisson", 0.2}}));
    check(read<NeoHookean>({{"young", 7e6}, {"poisson", 0.2}}));
    CHECK(read<BlatzKo>({{"shear_modulus", 4e6}}).moduli().young == doctest::Approx(1e7));
    CHECK(moduli(Material{BlatzKo{4e6}}).poisson == 0.25);
  }

  TEST_CASE("no two parameters of a law share a member") {
    test::each_law([](auto law) {
      auto const& parameters = law.schema().parameters;
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        std::vector<core::Value> before;
        for (auto const& p : parameters)
          before.push_back(p.get(&law));
        bool const list = parameters[i].kind == core::Parameter::Kind::numbers;
        core::Value const other = list ? core::Value{core::Numbers{0.123}} : core::Value{0.123};
        parameters[i].set(&law, other);
        for (std::size_t j = 0; j < parameters.size(); ++j)
          CHECK(parameters[j].get(&law) == (i == j ? other : before[j]));
      }
    });
  }
}
