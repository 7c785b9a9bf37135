// Histories: what is written is read, whatever happens to the writer.
#include "record/series.hpp"

#include <cmath>
#include <csignal>
#include <doctest/doctest.h>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "folder.hpp"
#include "record/hdf5.hpp"
#include "record/intercept.hpp"

using namespace stiction;
using record::Series;

namespace {

double value(std::size_t row, std::size_t column) {
  return static_cast<double>(row) + 0.001 * static_cast<double>(column);
}

constexpr int wide = 40;

/// Columns force/y, contact/plate/beta [wide]; 1 + wide values a row.
void add_columns(Series& series) {
  series.add("force", "y", "N/m", "vertical force");
  series.add("contact/plate", "beta", "1", "bond intensity", wide);
}

void append_rows(Series& series, std::size_t rows) {
  std::vector<double> row(1 + wide);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t c = 0; c < row.size(); ++c)
      row[c] = value(i, c);
    series.append(0.5 * static_cast<double>(i), row);
  }
}

/// Number of rows, after checking that every one is right.
std::size_t checked_rows(std::filesystem::path const& path) {
  auto const data = record::read_series(path);
  auto const& force = data.columns.at("force/y").values;
  auto const& beta = data.columns.at("contact/plate/beta").values;
  REQUIRE(force.size() == data.time.size());
  REQUIRE(beta.size() == data.time.size() * wide);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < data.time.size(); ++i) {
    wrong += data.time[i] != 0.5 * static_cast<double>(i) || force[i] != value(i, 0);
    for (std::size_t c = 0; c < wide; ++c)
      wrong += beta[i * wide + c] != value(i, c + 1);
  }
  CHECK(wrong == 0);
  return data.time.size();
}

/// Writes `rows` rows in a child that dies at its call number `kill_at`; true if it died.
bool killed(std::filesystem::path const& path, std::size_t rows, long kill_at) {
  pid_t const child = fork();
  if (child == 0) {
    test::interception() = {0, kill_at, -1};
    Series series(path);
    add_columns(series);
    append_rows(series, rows);
    series.flush();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
}

/// What is said when the disk is full from call number `from` on; empty when there was room enough.
std::string message_of_full_disk(std::filesystem::path const& path, std::size_t rows, long from) {
  std::string message;
  test::interception() = {0, -1, from};
  try {
    Series series(path);
    add_columns(series);
    append_rows(series, rows);
    series.flush();
  } catch (core::RunError const& error) {
    message = error.what();
  }
  test::interception() = {};
  return message;
}

std::string message_of(std::filesystem::path const& path) {
  try {
    (void)record::read_series(path);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_SUITE_BEGIN("record");

TEST_CASE("a series reads back with units and meanings") {
  test::Folder const folder;
  auto const path = folder / "series.h5";
  {
    Series series(path);
    auto const y = series.add("force", "y", "N/m", "vertical force");
    auto const beta = series.add("contact/plate", "beta", "1", "bond intensity", wide);
    CHECK(y.offset == 0);
    CHECK(beta.offset == 1);
    CHECK(series.row_width() == 1 + wide);
    series.set_attribute("", "study", "plate");
    series.set_attribute("contact/plate", "x", 0.25);
    append_rows(series, 100);
    CHECK(series.rows() == 100);
  }
  CHECK(checked_rows(path) == 100);
  auto const data = record::read_series(path);
  CHECK(data.columns.at("force/y").unit == "N/m");
  CHECK(data.columns.at("contact/plate/beta").meaning == "bond intensity");
  CHECK(data.columns.at("contact/plate/beta").width == wide);
  CHECK_FALSE(std::filesystem::exists(folder / "series.h5.part"));
}

TEST_CASE("of columns that a kill left of unlike length the rows that all have are read") {
  test::Folder const folder;
  auto const path = folder / "series.h5";
  {
    Series series(path);
    add_columns(series);
    append_rows(series, 100);
  }
  {
    record::hdf5::Handle const file(H5Fopen(path.c_str(), H5F_ACC_RDWR, record::hdf5::file_access()),
                                    H5Fclose);
    record::hdf5::Handle const column(H5Dopen2(file, "force/y", H5P_DEFAULT), H5Dclose);
    hsize_t const rows = 60;
    REQUIRE(H5Dset_extent(column, &rows) >= 0);
  }
  CHECK(checked_rows(path) == 60);
}

TEST_CASE("a series without rows is readable and empty") {
  test::Folder const folder;
  {
    Series series(folder / "series.h5");
    add_columns(series);
  }
  CHECK(checked_rows(folder / "series.h5") == 0);
}

TEST_CASE("a series can be read while it is written") {
  test::Folder const folder;
  Series series(folder / "series.h5");
  add_columns(series);
  append_rows(series, 1);
  CHECK(checked_rows(folder / "series.h5") == 1); // the first row goes to disk at once
}

TEST_CASE("a series killed at any one of its system calls keeps the rows of earlier flushes") {
  test::Folder const folder;
  auto const path = folder / "series.h5";
  std::size_t least = 0;
  long at = 1;
  while (killed(path, 200, at)) {
    if (std::filesystem::exists(path)) {
      std::size_t const rows = checked_rows(path);
      CHECK_MESSAGE(rows + 32 >= least, "killed at call ", at, " of which earlier kills left ", least);
      least = std::max(least, rows);
      std::filesystem::remove(path);
    }
    ++at;
  }
  CHECK(least >= 200 - 32);
  CHECK(at > 20);
  CHECK(checked_rows(path) == 200);
}

TEST_CASE("a disk full from any call on is a run error with the reason and flushed rows stay") {
  test::Folder const folder;
  auto const path = folder / "series.h5";
  std::size_t least = 0;
  long from = 1;
  for (std::string message = "start"; !message.empty(); ++from) {
    message = message_of_full_disk(path, 200, from);
    CHECK_MESSAGE((message.empty() || contains(message, "No space left on device")), message);
    if (!std::filesystem::exists(path))
      continue;
    std::size_t const rows = checked_rows(path);
    CHECK(rows + 32 >= least);
    least = std::max(least, rows);
    std::filesystem::remove(path);
  }
  CHECK(least == 200);
  CHECK(from > 8);
}

TEST_CASE("a series below a regular file cannot be made") {
  test::Folder const folder;
  std::ofstream(folder / "file") << "x";
  try {
    Series series(folder / "file" / "series.h5");
    FAIL("no error");
  } catch (core::RunError const& error) {
    CHECK(contains(error.what(), "Not a directory"));
  }
}

TEST_CASE("misuse of a series is our bug") {
  test::Folder const folder;
  Series series(folder / "series.h5");
  add_columns(series);
  std::vector<double> row(1 + wide, 0.0);
  CHECK_THROWS_AS(series.append(0, std::span(row).first(3)), core::Bug);
  row[7] = std::nan("");
  CHECK_THROWS_AS(series.append(0, row), core::Bug);
  row[7] = 0;
  series.append(0, row);
  CHECK_THROWS_AS(series.add("late", "column", "m", ""), core::Bug);
}

TEST_CASE("files that are no series are refused by name") {
  test::Folder const folder;
  CHECK(contains(message_of(folder / "none.h5"), "none.h5: no such file"));
  std::ofstream(folder / "text.h5") << "hello";
  CHECK(contains(message_of(folder / "text.h5"), "text.h5: not an HDF5 file"));
  auto const path = folder / "series.h5";
  {
    Series series(path);
    add_columns(series);
    append_rows(series, 100);
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  CHECK(contains(message_of(path), "truncated or damaged"));
}

TEST_SUITE_END();
