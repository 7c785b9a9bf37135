// Saved contact problems: every law comes back as it was, and what cannot be one is refused.
#include <doctest/doctest.h>
#include <filesystem>
#include <hdf5.h>

#include "contact/solvers.hpp"
#include "core/handle.hpp"
#include "folder.hpp"
#include "interface/laws.hpp"
#include "record/law_text.hpp"
#include "record/problem_file.hpp"

using namespace stiction;

namespace {

/// One point for each adhesion law, with the friction laws in turn.
contact::Problem with_all_laws() {
  auto const adhesions = test::adhesions();
  auto problem = test::random_problem(3, static_cast<int>(adhesions.size()), 7, 3);
  for (auto const& named : test::frictions())
    if (interface::Law{named.law, {}}.mu_follows())
      problem.frictions.push_back(named.law);
  for (std::size_t i = 0; i < adhesions.size(); ++i) {
    problem.adhesions.push_back(adhesions[i].law);
    auto& point = problem.points[i];
    point.adhesion = static_cast<int>(i);
    point.friction = static_cast<int>(i % (problem.frictions.size() + 1)) - 1;
    point.bond = {{0.7, {1e-3, -2e-3}}, 0.01, i % 2 == 0};
    point.shift = {1e-5, -2e-5, 3e-5};
  }
  return problem;
}

template<int D> Vector residuals(contact::Problem const& problem, Vector const& p) {
  Vector const x = contact::displacement(problem, p);
  Vector all(p.size());
  for (Index i = 0; i < problem.size(); ++i)
    all.segment<D>(D * i) =
        contact::evaluate<D>(problem, i, p.segment<D>(D * i), x.segment<D>(D * i), 1e4).residual;
  return all;
}

std::string refused(std::string const& text) {
  contact::Problem problem;
  return record::read_laws(text, problem);
}

} // namespace

TEST_CASE("a saved problem with every law asks the same again, bit by bit") {
  test::Folder const folder;
  auto const problem = with_all_laws();
  record::save_problem(folder / "problem.h5", problem);
  auto const back = record::load_problem(folder / "problem.h5");
  CHECK(record::text_of_laws(back) == record::text_of_laws(problem));
  CHECK(back.adhesions.size() == problem.adhesions.size());
  CHECK(back.frictions.size() == problem.frictions.size());
  for (double const size : {-3.0, 1.0, 40.0}) {
    Vector const p = Vector::LinSpaced(problem.free.size(), -size, size);
    CHECK(residuals<3>(back, p) == residuals<3>(problem, p));
  }
  auto const force = test::solve(contact::GaussSeidel{}, problem).force;
  CHECK(contact::judge(back, force).residual == contact::judge(problem, force).residual);
}

TEST_CASE("laws written as a text of any length, as by Python, are read") {
  test::Folder const folder;
  auto const path = folder / "problem.h5";
  auto const problem = with_all_laws();
  record::save_problem(path, problem);
  {
    using core::Handle;
    Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    REQUIRE(H5Adelete(file, "laws") >= 0);
    Handle const type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
    H5Tset_size(type, H5T_VARIABLE);
    Handle const attribute(H5Acreate2(file, "laws", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    auto const text = record::text_of_laws(problem);
    char const* start = text.c_str();
    REQUIRE(H5Awrite(attribute, type, &start) >= 0);
  }
  CHECK(record::text_of_laws(record::load_problem(path)) == record::text_of_laws(problem));
}

TEST_CASE("texts that are no laws are refused with the reason") {
  CHECK(refused("nonsense").find("no JSON object") != std::string::npos);
  CHECK(refused("{\"adhesions\": []}").find("no frictions") != std::string::npos);
  CHECK(refused("{\"adhesions\": [], \"frictions\": []}").empty());
  CHECK(refused("{\"adhesions\": [{\"kind\": \"glue\"}], \"frictions\": []}").find("unknown kind") !=
        std::string::npos);
  CHECK(refused("{\"adhesions\": [{\"kind\": \"potential\", \"w\": -1}], \"frictions\": []}")
            .find("w of law potential") != std::string::npos);
  CHECK(refused("{\"adhesions\": [{\"kind\": \"dugdale\", \"memory\": \"no\"}], \"frictions\": []}")
            .find("memory of law dugdale") != std::string::npos);
  auto const rcc = [](std::string const& more) {
    return refused("{\"adhesions\": [{\"kind\": \"rcc\", \"C_n\": 1, \"C_t\": 1, \"b\": 0" + more +
                   "}], \"frictions\": []}");
  };
  CHECK(rcc(", \"w\": 1").empty());
  CHECK(rcc("").find("law rcc lacks w") != std::string::npos);
  CHECK(rcc(", \"w\": 1, \"Cn\": 1").find("law rcc has no Cn") != std::string::npos);
  CHECK(refused(
            "{\"adhesions\": [{\"kind\": \"bilinear\", \"K\": 1, \"sigma_n\": 2, \"sigma_t\": 1, \"G_I\": 1, "
            "\"G_II\": 1}], \"frictions\": []}")
            .find("G_I") != std::string::npos); // less than is stored before damage begins
}
