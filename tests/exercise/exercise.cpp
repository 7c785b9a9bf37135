// The exercise's law by what visits laws, and under the tests that all laws are put to.
#include "interface/adhesion_laws.cpp"
#include "interface/law.cpp"
#include "record/law_text.cpp"

#include "core/reader.hpp"
#include "core/unit.hpp"
#include "scene/description/catalog.hpp"

namespace {

core::Input number(double value, char const* unit) {
  return {core::Quantity{value, core::parse_unit(unit)->dimension}, "", ""};
}

/// As a script's stiction.adhesion.delayed{w = ..., delta = ..., tau = ...}.
core::Input script(double w) {
  return {core::Table{{"w", number(w, "J/m^2")}, {"delta", number(0.02, "m")}, {"tau", number(0.2, "s")}}, "",
          "stiction.adhesion.delayed"};
}

AdhesionLaw read(core::Input const& input, core::Complaints& complaints) {
  return core::Reader(input, "pairs.sole.adhesion", complaints).alternative<AdhesionLaw>();
}

} // namespace

TEST_SUITE("exercise") {
  TEST_CASE("help has the new law and what it takes") {
    auto const& categories = scene::catalog();
    auto const adhesion = std::ranges::find(categories, "adhesion", &scene::Category::name);
    REQUIRE(adhesion != categories.end());
    auto const delayed = std::ranges::find(adhesion->kinds, "delayed", &core::Schema::name);
    REQUIRE(delayed != adhesion->kinds.end());
    CHECK(delayed->meaning.find("lags behind") != std::string::npos);
    REQUIRE(delayed->find("tau") != nullptr);
    CHECK(delayed->find("tau")->unit == "s");
  }

  TEST_CASE("scripts make it, and are told what is wrong") {
    core::Complaints complaints;
    auto const law = read(script(3), complaints);
    CHECK(complaints.empty());
    CHECK(std::get<Delayed>(law).w == 3);
    CHECK(bond_time(law) == doctest::Approx(0.2));
    static_cast<void>(read(script(-1), complaints));
    REQUIRE(complaints.size() == 1);
    CHECK(complaints[0].path == "pairs.sole.adhesion.w");
  }

  TEST_CASE("the manifest tells it, and a saved contact problem holds it") {
    core::Complaints complaints;
    contact::Problem problem, again;
    problem.adhesions = {read(script(3), complaints)};
    auto const& law = std::get<Delayed>(problem.adhesions[0]);
    CHECK(record::describe(&law, law.schema())["tau"]["value"] == 0.2);
    CHECK(record::read_laws(record::text_of_laws(problem), again).empty());
    REQUIRE(again.adhesions.size() == 1);
    CHECK(std::get<Delayed>(again.adhesions[0]).delta == 0.02);
  }

  TEST_CASE("error control and audit ask it, and the samples of the tests hold it") {
    Delayed const law{3, 0.02, 0.2};
    CHECK(evolves(law));
    CHECK_FALSE(grows(law));
    CHECK(bond_time(law) == doctest::Approx(0.2));
    auto const all = adhesions();
    CHECK(std::ranges::count(all, "delayed", &NamedAdhesion::name) == 1);
  }

  TEST_CASE("in a step of no length a bond stays as it is, whatever its time") {
    for (double const tau : {0.0, 0.2}) {
      Delayed const law{3, 0.02, tau};
      BondStep step;
      step.old.beta = 0.7;
      step.dt = 0;
      auto const pull = adhere<2>(law, step, {0.03, 0});
      CHECK(pull.beta == 0.7);
      CHECK(pull.traction.allFinite());
      CHECK(law.steepest_fall(step) == 0);
    }
  }
}
