// A run that is killed at any moment leaves a series whose rows are right.
#include <csignal>
#include <doctest/doctest.h>
#include <random>
#include <sys/wait.h>
#include <unistd.h>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// Two stages of 600 steps together, and on request a third that outlasts every kill.
test::Input scene_of_many_steps(bool endless) {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1, 2, 1000}, {0, 0, 0.1, 0.1}, {0, -0.01, -0.01, -0.01})});
  test::at(table, "probes.line") = test::make("probe.contact_line", {{"pair", test::text("sole")}});
  test::at(table, "probes.energy") = test::make("probe.energy");
  test::at(table, "output") = test::make("output", {{"frames", test::value(20)}});
  if (endless)
    test::at(table, "schedule") = test::schedule({{1, 100}, {2, 500}, {1000, 1000000}});
  else
    test::at(table, "schedule") = test::schedule({{1, 100}, {2, 500}});
  return table;
}

scene::RunResult run(std::filesystem::path const& out, bool endless) {
  scene::RunOptions options;
  options.out = out;
  return scene::run(scene_of_many_steps(endless), options);
}

/// Rows that can be read, the first of them checked against those of the shorter run.
std::size_t checked_rows(std::filesystem::path const& path, record::SeriesData const& shorter) {
  if (!std::filesystem::exists(path))
    return 0;
  auto const data = record::read_series(path);
  auto const rows = std::min(data.time.size(), shorter.time.size());
  auto agree = [](std::vector<double> const& a, std::vector<double> const& b, std::size_t count) {
    return std::equal(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(count), b.begin());
  };
  CHECK(agree(data.time, shorter.time, rows));
  for (auto const& [name, column] : data.columns) {
    CAPTURE(name);
    REQUIRE(column.values.size() == data.time.size() * column.width);
    CHECK(agree(column.values, shorter.columns.at(name).values, rows * column.width));
  }
  return data.time.size();
}

} // namespace

TEST_CASE("rows survive a kill at random moments of a run") {
  test::Folder const folder;
  double const seconds = run(folder / "whole", false).seconds;
  auto const whole = record::read_series(folder / "whole/series.h5");
  REQUIRE(whole.time.size() == 601);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> moment(0.05, 2);
  int with_rows = 0;
  double patience = std::max(seconds, 0.05); // more where a busy machine brings it to no row
  for (int k = 0; k < 10 || (with_rows < 3 && k < 40); ++k) {
    auto const out = folder / ("killed" + std::to_string(k));
    pid_t const child = fork();
    if (child == 0) {
      static_cast<void>(run(out, true));
      _exit(0);
    }
    usleep(static_cast<useconds_t>(1e6 * patience * moment(random)));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    bool const any = checked_rows(out / "series.h5", whole) > 0;
    with_rows += any ? 1 : 0;
    patience *= any ? 1 : 1.5;
  }
  CHECK(with_rows >= 3);
}
