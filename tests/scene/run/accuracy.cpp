// Runs whose steps follow from their error: bounds that hold, events met, moments kept, convergence.
#include "dynamics/adaptivity/accuracy.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

struct Ran {
  scene::RunResult result;
  record::SeriesData series;
  std::string log; ///< steps.csv
  [[nodiscard]] std::vector<double> const& column(std::string const& name) const {
    return series.columns.at(name).values;
  }
};

Ran run(test::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.case_id = "one";
  Ran ran;
  ran.result = scene::run(table, options);
  ran.series = record::read_series(folder / "case/series.h5");
  std::stringstream text;
  text << std::ifstream(folder / "case/steps.csv").rdbuf();
  ran.log = text.str();
  return ran;
}

/// A foot 2 mm over the floor: lands at 0.2 s, is pressed and bonds until 1 s, is then lifted by 50 mm in 1
/// s.
test::Input landing(double b) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0.002}, {1, 1}, {2, 2}}, test::linear_elastic(1e4, 0));
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e4, b);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, -0.01, 0.04})});
  test::at(table, "schedule") = test::schedule({{1, 20}, {2, 20}});
  auto const sole = std::pair<std::string const, test::Input>{"pair", test::text("sole")};
  test::at(table, "probes.whole") = test::make("probe.contact", {sole});
  test::at(table, "probes.line") = test::make("probe.contact_line", {sole});
  test::at(table, "probes.push") = test::make("probe.force", {{"set", test::text("foot.top")}});
  test::at(table, "output") = test::make("output", {{"frames", test::value(0)}});
  return table;
}

test::Input with(test::Input table, std::vector<std::pair<std::string, test::Input>> const& entries) {
  test::at(table, "schedule.accuracy") = test::make("accuracy");
  for (auto const& [name, value] : entries)
    test::at(table, "schedule.accuracy." + name) = value;
  return table;
}

test::Input with_frames(test::Input table) {
  test::at(table, "output.frames") = test::value(1);
  return table;
}

double highest(std::vector<double> const& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Row after which `values`, [rows, width], first fulfil the condition, all of them.
template<class Condition> std::size_t first_row(Ran const& ran, std::string const& name, Condition&& holds) {
  auto const& column = ran.series.columns.at(name);
  for (std::size_t row = 0; row < ran.series.time.size(); ++row) {
    auto const from = column.values.begin() + static_cast<std::ptrdiff_t>(row * column.width);
    if (std::all_of(from, from + static_cast<std::ptrdiff_t>(column.width), holds))
      return row;
  }
  FAIL("never");
  return 0;
}

} // namespace

TEST_CASE("without an accuracy the steps are as ever and tell no error") {
  auto const ran = run(landing(0.5));
  CHECK(ran.result.steps == 40);
  CHECK_FALSE(ran.series.columns.contains("step/error_beta"));
  for (char const* change : {",cut,", ",grown,", ",at_floor,", ",aimed,"})
    CHECK(ran.log.find(change) == std::string::npos);
}

TEST_CASE("steps.csv tells of every step what answered its contact problems") {
  auto const ran = run(with_frames(landing(0.5)));
  REQUIRE(ran.log.starts_with("time_s,dt_s,next_dt_s,what,cause,reason,contact\n"));
  std::regex const row(R"([^,]+,[^,]+,[^,]+,step,,"",((newton|descent) \d+)( descent \d+)?)"); // nothing rubs
  std::regex const count(R"(\d+)");
  long problems = 0, steps = 0;
  std::istringstream log(ran.log);
  std::string line;
  for (std::getline(log, line); std::getline(log, line); ++steps) {
    REQUIRE(std::regex_match(line, row));
    auto const contact = line.substr(line.rfind(',') + 1);
    for (std::sregex_iterator at(contact.begin(), contact.end(), count), end; at != end; ++at)
      problems += std::stol(at->str());
  }
  INFO(ran.log);
  CHECK(problems == static_cast<long>(ran.result.counters.at("contact_problems")));
  CHECK(steps > 30);
  CHECK(std::regex_match(ran.result.contact, std::regex(R"(newton \d+ descent \d+|newton \d+|descent \d+)")));
}

TEST_CASE(
    "without fields steps.csv tells of the steps that did not go as always, and is not there for others") {
  std::string const head = "time_s,dt_s,next_dt_s,what,cause,reason,contact\n";
  auto const eventful = [&](test::Input const& table) { // rows of a scene with fields that are to be left
    std::istringstream rows(run(with_frames(table)).log);
    std::string left, line;
    for (std::getline(rows, line); std::getline(rows, line);)
      if (line.find(",step,") == std::string::npos || line.find(" descent ") != std::string::npos)
        left += line + "\n";
    return left;
  };
  auto const adaptive = with(landing(0.5), {});
  auto const left = eventful(adaptive);
  REQUIRE_FALSE(left.empty());
  CHECK(run(adaptive).log == head + left);
  auto dry = landing(0.5);
  std::get<core::Table>(test::at(dry, "pairs.sole").value).erase("adhesion");
  REQUIRE_FALSE(run(with_frames(dry)).log.empty());
  CHECK(eventful(dry).empty());
  CHECK(run(dry).log.empty());
}

TEST_CASE("no step changes a bond by more than allowed or is off by more than the tolerance") {
  for (double const change : {0.1, 0.02}) {
    CAPTURE(change);
    auto const ran =
        run(with(landing(0.5), {{"beta_change", test::value(change)}, {"tolerance", test::value(0.005)}}));
    REQUIRE(ran.result.verdict == "finished");
    CHECK(ran.result.counters.at("at_floor") == 0);
    CHECK(highest(ran.column("step/beta_change")) <= change * (1 + 1e-6));
    CHECK(highest(ran.column("step/beta_change")) > 0.5 * change);
    CHECK(highest(ran.column("step/error_beta")) <= 0.005);
    auto const& beta = ran.series.columns.at("line/beta");
    for (std::size_t k = beta.width; k < beta.values.size(); ++k)
      CHECK(std::abs(beta.values[k] - beta.values[k - beta.width]) <= change * (1 + 1e-6));
  }
}

TEST_CASE("steps meet the ends of stages and the moments of frames and cover the time") {
  auto table = with(landing(0.5), {});
  test::at(table, "output.frames") = test::value(3);
  auto const ran = run(table);
  auto const& time = ran.series.time;
  for (double const moment : {0.35, 0.7, 1.0, 1.35, 1.7, 2.0})
    CHECK(std::ranges::any_of(time, [&](double t) { return std::abs(t - moment) < 1e-12; }));
  CHECK(std::ranges::count(time, 1.0) == 1);
  CHECK(time.back() == 2.0);
  double covered = 0;
  for (double const dt : ran.column("step/dt"))
    covered += dt;
  CHECK(covered == doctest::Approx(2).epsilon(1e-12));
}

TEST_CASE("every cut and growth is told with its reason and counted") {
  auto const ran = run(with(landing(0.5), {{"tolerance", test::value(1e-3)}}));
  auto const& counters = ran.result.counters;
  double const cuts = counters.at("cut_error") + counters.at("cut_beta_change") + counters.at("cut_event") +
                      counters.at("cut_not_converged");
  CHECK(static_cast<double>(ran.result.cuts) == cuts);
  CHECK(counters.at("cut_error") > 0);
  CHECK(counters.at("grown") > 0);
  double lines = 0;
  CHECK(ran.log.find(",cut,error,\"the local error of beta is") != std::string::npos);
  std::istringstream log(ran.log);
  std::string line;
  std::getline(log, line);
  while (std::getline(log, line)) {
    std::smatch found;
    REQUIRE(std::regex_match(line, found, std::regex("[^,]*,([^,]*),([^,]*),([a-z_]*),.*")));
    double const dt = std::stod(found[1]), next = std::stod(found[2]);
    CAPTURE(line);
    if (found[3] == "step")
      continue;
    ++lines;
    CHECK((found[3] == "cut" ? next < dt : found[3] == "grown" ? next > dt : next == dt));
  }
  CHECK(lines == cuts + counters.at("grown") + counters.at("at_floor"));
}

TEST_CASE("events are met within their time and only where asked") {
  double const within = 1e-4;
  auto const loose =
      run(with(landing(0.5), {{"tolerance", test::value(0.1)}, {"beta_change", test::value(1)}}));
  auto const met = run(with(landing(0.5), {{"tolerance", test::value(0.1)},
                                           {"beta_change", test::value(1)},
                                           {"events", test::value(within, "s")}}));
  CHECK(loose.result.counters.at("cut_event") == 0);
  CHECK(met.result.steps < loose.result.steps + 8); // only next to an event are steps short
  auto const closed = [](double status) { return status > 0; };
  double const touch = 0.2, bonded = touch + 0.5; // b / w
  double const until = within + 1e-15;            // times of about 1 s have such last digits
  auto const at = first_row(met, "line/status", closed);
  // the step that lands begins or ends next to the landing
  CHECK(std::min(std::abs(met.series.time[at] - touch), std::abs(met.series.time[at - 1] - touch)) <= until);
  auto const full = first_row(met, "line/beta", [](double beta) { return beta >= 1; });
  CHECK(std::min(std::abs(met.series.time[full] - bonded), std::abs(met.series.time[full - 1] - bonded)) <=
        until);
  // the bond yields at sqrt(w / C) = 10 mm
  auto const last_full =
      std::ranges::count_if(met.column("line/beta"), [](double beta) { return beta >= 1; });
  auto const width = met.series.columns.at("line/beta").width;
  auto const yields = full + static_cast<std::size_t>(last_full) / width - 1;
  CHECK(met.column("line/gap")[yields * width] == doctest::Approx(0.01).epsilon(1e-3));
  // without it the landing lies anywhere in its step, and the bond with it
  auto const missed = first_row(loose, "line/status", closed);
  CHECK(std::min(std::abs(loose.series.time[missed] - touch),
                 std::abs(loose.series.time[missed - 1] - touch)) > within);
}

TEST_CASE("aim at an event is told in words, and events are counted where they happen") {
  auto const ran = run(with(landing(0.5), {{"events", test::value(1e-4, "s")}}));
  CHECK(ran.result.counters.at("aimed") > 0);
  std::regex const aimed(",aimed,event,\"point [0-9]+ of pair 1 is expected to be next: it touches\"");
  CHECK(std::regex_search(ran.log, aimed)); // points touch two at a time: either may be named
  auto const& events = ran.column("step/events");
  CHECK(std::accumulate(events.begin(), events.end(), 0.0) >= 6); // two points: touch, full, yield
}

/// The foot falls as one: it has the speed of its top from the start, and inertia.
test::Input falling() {
  auto table = landing(0.5);
  test::at(table, "bodies.foot.velocity") = test::values({0, -0.01}, "m/s");
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "schedule") = test::schedule({{0.25, 25}});
  return table;
}

TEST_CASE("with inertia steps are the stage's own times powers of two, and events are met all the same") {
  double const within = 1e-4, touch = 0.2;
  auto const ran = run(with(falling(), {{"events", test::value(within, "s")}}));
  REQUIRE(ran.result.verdict == "finished");
  CHECK(ran.series.time.back() == 0.25);
  auto const& dt = ran.column("step/dt");
  for (std::size_t k = 1; k < dt.size(); ++k) {
    double const rung = std::log2(dt[k] / 0.01);
    CHECK(std::abs(rung - std::round(rung)) < 1e-9);
  }
  auto const at = first_row(ran, "line/status", [](double status) { return status > 0; });
  CHECK(std::min(std::abs(ran.series.time[at] - touch), std::abs(ran.series.time[at - 1] - touch)) <=
        within * (1 + 1e-6));
}

TEST_CASE("kept factors save factorizations and change nothing else beyond the tolerance of a step") {
  auto const events = std::pair<std::string, test::Input>{"events", test::value(1e-4, "s")};
  auto const few = run(with(falling(), {events, {"factors", test::value(2)}})),
             many = run(with(falling(), {events, {"factors", test::value(20)}}));
  CHECK(many.result.factorizations < few.result.factorizations);
  CHECK(many.result.steps == few.result.steps);
  CHECK(highest(many.column("push/force_y")) ==
        doctest::Approx(highest(few.column("push/force_y"))).epsilon(1e-6));
}

TEST_CASE("an explicit run under error control tries steps above its limit now and then only") {
  auto table = falling();
  for (char const* part : {"pairs", "obstacles", "probes"})
    test::remove(table, part);
  test::at(table, "scheme") = test::make("scheme.central_difference");
  test::at(table, "schedule") = test::schedule({{0.25, 100}});
  auto const ran = run(with(table, {{"tolerance", test::value(1)}}));
  REQUIRE(ran.result.verdict == "finished");
  CHECK(ran.log.find("above the stability limit") != std::string::npos);
  CHECK(ran.result.counters.at("cut_not_converged") > 0);
  CHECK(ran.result.counters.at("cut_not_converged") < 0.15 * static_cast<double>(ran.result.steps));
}

TEST_CASE("the same run under error control is the same to the last bit") {
  auto const table = with(falling(), {{"events", test::value(1e-4, "s")}});
  auto const one = run(table), two = run(table);
  CHECK(one.series.time == two.series.time);
  CHECK(one.column("push/force_y") == two.column("push/force_y"));
  CHECK(one.log == two.log);
}

TEST_CASE("where nothing has an error, that is remarked") {
  auto table = landing(0.5);
  test::remove(table, "pairs.sole.adhesion");
  auto const ran = run(with(table, {{"largest", test::value(0.05, "s")}})); // else works are told, too
  REQUIRE(ran.result.remarks.size() == 1);
  CHECK(ran.result.remarks[0].find("no error is seen by `accuracy`") != std::string::npos);
}

TEST_CASE("with the tolerance the pull-off force settles") {
  auto fine = landing(0.5);
  test::at(fine, "schedule") = test::schedule({{1, 4000}, {2, 8000}});
  auto const reference = highest(run(fine).column("push/force_y"));
  double last = 1;
  for (double const tolerance : {1e-2, 1e-3, 1e-4}) {
    CAPTURE(tolerance);
    auto const ran = run(with(landing(0.5), {{"tolerance", test::value(tolerance)}}));
    double const error = std::abs(highest(ran.column("push/force_y")) / reference - 1);
    CHECK(error < last);
    last = 0.6 * error;
  }
  CHECK(last < 0.003);
}

TEST_CASE("at the smallest step errors are accepted and told and counted") {
  auto const ran =
      run(with(landing(0.5), {{"tolerance", test::value(1e-9)}, {"smallest", test::value(0.01, "s")}}));
  CHECK(ran.result.verdict == "finished");
  CHECK(ran.result.counters.at("at_floor") > 0);
  CHECK(ran.log.find(",at_floor,smallest,\"the local error of ") != std::string::npos);
}

TEST_CASE("a smallest step above the largest is refused") {
  auto const table =
      with(landing(0.5), {{"smallest", test::value(1, "s")}, {"largest", test::value(0.1, "s")}});
  CHECK_THROWS_WITH_AS(scene::validate(table), doctest::Contains("smallest"), core::InputError);
}
