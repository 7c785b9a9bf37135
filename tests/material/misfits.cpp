// What the reader says of rubber parameters that do not fit together.
#include <doctest/doctest.h>

#include "core/reader.hpp"
#include "material/material.hpp"

using namespace stiction;
using namespace stiction::material;

namespace {

constexpr double K = 7e7;

core::Input number(double value, std::string const& unit) {
  return {core::Quantity{value, core::parse_unit(unit)->dimension}, "", ""};
}
core::Input list(std::vector<double> const& values, std::string const& unit) {
  std::vector<core::Input> all;
  for (double const value : values)
    all.push_back(number(value, unit));
  return {all, "", ""};
}

/// What the reader says of a law with these parameters and some bulk modulus, without the place.
template<class Law> std::string said(core::Table table) {
  table["bulk_modulus"] = number(K, "Pa");
  core::Input const input{table, "", ""};
  core::Complaints complaints;
  auto const law = core::Reader(input, "", complaints).record<Law>();
  CHECK(law.bulk_modulus == K);
  CHECK(complaints.size() <= 1);
  return complaints.empty() ? "" : complaints[0].path + " " + complaints[0].text;
}

} // namespace

TEST_SUITE("material") {
  TEST_CASE("parameters that fit are read, those that do not are named with value and remedy") {
    CHECK(said<MooneyRivlin>({{"C10", number(3e5, "Pa")}, {"C01", number(-1e5, "Pa")}}).empty());
    CHECK(said<MooneyRivlin>({{"C10", number(1e5, "Pa")}, {"C01", number(-3e5, "Pa")}}) ==
          "C01 is -300000 Pa, so that the shear modulus at rest 2 (C10 + C01) is -400000 Pa; it must be > 0 "
          "Pa: "
          "raise C01 above -100000 Pa or C10 above 300000 Pa");
    auto const ogden_said = [](std::vector<double> const& mu, std::vector<double> const& alpha) {
      return said<Ogden>({{"mu", list(mu, "Pa")}, {"alpha", list(alpha, "1")}});
    };
    CHECK(ogden_said({6e5, -1e4}, {1.3, -2}).empty());
    CHECK(ogden_said({6e5, 1e5}, {2}) == "alpha has 1 numbers and mu has 2; give one alpha for each mu");
    CHECK(ogden_said({}, {}) == "mu has 0 numbers; 1 to 6 are wanted");
    CHECK(ogden_said({1, 1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1, 1}) == "mu has 7 numbers; 1 to 6 are wanted");
    CHECK(ogden_said({6e5, 1e5}, {2, 0}) == "alpha[2] is 0; it must not be 0: drop it and its mu");
    CHECK(ogden_said({6e5, 1e5}, {2, -20}) == "mu gives with alpha a shear modulus at rest, sum of mu alpha "
                                              "/ 2, of -400000 Pa; it must be > 0 Pa: as a "
                                              "rule each mu has the sign of its alpha");
    CHECK(said<Yeoh>({{"C10", number(-1, "Pa")}, {"C20", number(0, "Pa")}, {"C30", number(0, "Pa")}}) ==
          "C10 is -1 Pa; it must be > 0 Pa");
    CHECK(said<ArrudaBoyce>({{"shear_modulus", number(1e5, "Pa")}, {"lambda_m", number(1, "1")}}) ==
          "lambda_m is 1; it must be > 1");
  }
}
