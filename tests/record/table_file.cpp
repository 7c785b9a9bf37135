// Tables in HDF5: columns and rows as given, whole or not at all.
#include "record/table_file.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "folder.hpp"
#include "record/hdf5.hpp"

using namespace stiction;
using record::hdf5::Handle;
using test::Folder;

namespace {

std::vector<record::TableColumn> const columns{
    {"case", "", "its name", {}, {"a", "bé", ""}},
    {"force", "N m^-1", "largest", {1.0 / 3, std::nan(""), -0.0}, {}},
};

Handle open(std::filesystem::path const& path) {
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, record::hdf5::file_access()), H5Fclose};
}

} // namespace

TEST_CASE("a table's rows and columns are what was given, with their units") {
  Folder const folder;
  auto const path = folder.path() / "results.h5";
  record::write_table(path, "cases", 3, columns);
  Handle const file = open(path);
  REQUIRE(file.valid());
  Handle const force(H5Dopen2(file, "columns/force", H5P_DEFAULT), H5Dclose);
  std::array<double, 3> values{};
  REQUIRE(H5Dread(force, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
  CHECK(values[0] == 1.0 / 3);
  CHECK(std::isnan(values[1]));
  CHECK(std::signbit(values[2]));
  CHECK(record::hdf5::read_attribute(force, "unit") == "N m^-1");
  CHECK(record::hdf5::read_attribute(force, "meaning") == "largest");
  Handle const whole(H5Dopen2(file, "cases", H5P_DEFAULT), H5Dclose);
  CHECK(record::hdf5::read_attribute(whole, "unit_force") == "N m^-1");
  Handle const type(H5Dget_type(whole), H5Tclose);
  REQUIRE(H5Tget_nmembers(type) == 2);
  std::vector<char> rows(3 * H5Tget_size(type));
  REQUIRE(H5Dread(whole, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows.data()) >= 0);
  auto const at = H5Tget_member_offset(type, 1), row = H5Tget_size(type);
  std::memcpy(values.data(), &rows[at], sizeof(double));
  CHECK(values[0] == 1.0 / 3);
  std::memcpy(values.data(), &rows[2 * row + at], sizeof(double));
  CHECK(values[0] == 0);
  CHECK(std::signbit(values[0]));
  CHECK(std::string(&rows[row], 3) == "bé");
  CHECK(rows[2 * row] == '\0');
}

TEST_CASE("a table of no rows can be read") {
  Folder const folder;
  record::write_table(folder.path() / "none.h5", "cases", 0, {{"force", "N", "", {}, {}}});
  Handle const file = open(folder.path() / "none.h5");
  Handle const whole(H5Dopen2(file, "cases", H5P_DEFAULT), H5Dclose);
  CHECK(whole.valid());
}

TEST_CASE("a table that cannot be written leaves nothing behind") {
  Folder const folder;
  CHECK_THROWS_AS(record::write_table(folder.path() / "no" / "results.h5", "cases", 3, columns),
                  core::RunError);
  CHECK_THROWS_AS(record::write_table(folder.path() / "r.h5", "cases", 2, columns), core::Bug);
  CHECK(std::filesystem::is_empty(folder.path()));
}
