// Height maps from files: read to the last digit, on the points of the grid, or refused with what is wrong.
#include "halfspace/measured.hpp"

#include <cmath>
#include <cstring>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <hdf5.h>
#include <numbers>

#include "folder.hpp"

namespace {

using namespace stiction;
using halfspace::Grid;
using halfspace::HeightFile;
using halfspace::Measured;
using std::numbers::pi;

std::vector<double> const six{1.0 / 3, -2e-7, 3, 4.25, 1e10 / 7, -6}; // two rows of three

std::string written(test::Folder const& folder, char const* name, std::string const& bytes) {
  auto const path = folder.path() / name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path.string();
}

std::string text(char const* between, std::vector<double> const& values) {
  std::string all;
  for (std::size_t i = 0; i < values.size(); ++i)
    all += fmt::format("{}{}", values[i], i % 3 == 2 ? "\n" : between);
  return all;
}

template<class T>
std::string npy(char const* type, char const* order, char const* shape, std::vector<T> const& values) {
  std::string header =
      fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}), }}", type, order, shape);
  header.resize(117, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\x00\x76\x00", 10);
  bytes += header;
  auto const first = bytes.size();
  bytes.resize(first + values.size() * sizeof(T));
  std::memcpy(bytes.data() + first, values.data(), values.size() * sizeof(T));
  return bytes;
}

void check_six(HeightFile const& file) {
  CHECK(file.nx == 3);
  CHECK(file.ny == 2);
  CHECK(file.heights == six);
}

/// What is told of these bytes, and at which key.
std::string told(std::string const& path, char const* key = "file", std::string const& dataset = "") {
  try {
    static_cast<void>(halfspace::read_heights(path, dataset));
  } catch (core::InputError const& error) {
    REQUIRE(error.complaints().size() == 1);
    CHECK(error.complaints()[0].path == key);
    return error.complaints()[0].text;
  }
  return "nothing";
}

bool holds(std::string const& all, char const* part) {
  return all.find(part) != std::string::npos;
}

TEST_CASE("texts of heights are read to the last digit, whatever stands between them") {
  test::Folder const folder;
  for (char const* between : {",", ", ", ";", "\t", " ", "   "})
    check_six(halfspace::read_heights(written(folder, "a.csv", text(between, six))));
  auto const file = halfspace::read_heights(written(
      folder, "a.txt",
      "# Channel: Main\n# Width: 3.5 \xc2\xb5m\n# Height: 20 nm\n# Value units: mm\r\n\n" + text("\t", six)));
  check_six(file);
  CHECK(file.unit == "mm");
  CHECK(*file.length_x == doctest::Approx(3.5e-6).epsilon(1e-15));
  CHECK(*file.length_y == doctest::Approx(20e-9).epsilon(1e-15));
  auto const asc =
      halfspace::read_heights(written(folder, "a.asc", "x-length = 2 um\nz-unit = nm\n" + text(" ", six)));
  CHECK(asc.unit == "nm");
  CHECK(*asc.length_x == doctest::Approx(2e-6).epsilon(1e-15));
  CHECK(!asc.length_y);
}

TEST_CASE("what stands around heights in a text is not taken for them") {
  test::Folder const folder;
  auto const written_as = [&](std::string const& words) { return written(folder, "a.csv", words); };
  check_six(halfspace::read_heights(written_as("\xef\xbb\xbf" + text(",", six))));
  check_six(halfspace::read_heights(written_as("\xef\xbb\xbf# unit\n" + text(",", six))));
  std::string places;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i)
      places += fmt::format("{} {} {}\n", 0.5 * i, 0.25 * j, 0.1 * i * j);
  CHECK(holds(told(written_as(places)), "4 x 3 places"));
  CHECK(holds(told(written_as("0,1,2\n0.3,0.1,0.2\n0.5,0.7,0.6\n")), "the first row counts"));
  CHECK(holds(told(written_as("1,0.5,0.3\n2,0.1,0.2\n3,0.7,0.6\n")), "the first column counts"));
  for (char const* heights : {"0,1,2\n1,2,3\n2,3,4\n", "0,1,2\n0,1,2\n0,1,2\n"}) // slopes
    CHECK(halfspace::read_heights(written_as(heights)).heights.size() == 9);
}

TEST_CASE("arrays of NumPy are read in either order and of either length") {
  test::Folder const folder;
  check_six(halfspace::read_heights(written(folder, "a.npy", npy("<f8", "False", "2, 3", six))));
  std::vector<double> const turned{six[0], six[3], six[1], six[4], six[2], six[5]};
  check_six(halfspace::read_heights(written(folder, "a.npy", npy("<f8", "True", "2, 3", turned))));
  std::vector<float> const floats{1, 2, 0.5F};
  auto const line = halfspace::read_heights(written(folder, "a.npy", npy("<f4", "False", "3,", floats)));
  CHECK(line.ny == 1);
  CHECK(line.heights == std::vector<double>{1, 2, 0.5});
}

std::string hdf5(test::Folder const& folder, std::vector<char const*> const& names, char const* unit) {
  auto const path = (folder.path() / "a.h5").string();
  auto const file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  hsize_t const shape[] = {2, 3};
  for (char const* name : names) {
    auto const space = H5Screate_simple(2, shape, nullptr), one = H5Screate(H5S_SCALAR),
               type = H5Tcopy(H5T_C_S1);
    auto const set = H5Dcreate2(file, name, H5T_IEEE_F64BE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    CHECK(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, six.data()) >= 0);
    H5Tset_size(type, std::strlen(unit) + 1);
    auto const attribute = H5Acreate2(set, "units", type, one, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(attribute, type, unit);
    H5Aclose(attribute);
    H5Tclose(type);
    H5Sclose(one);
    H5Dclose(set);
    H5Sclose(space);
  }
  H5Fclose(file);
  return path;
}

TEST_CASE("data sets of HDF5 are read with their unit") {
  test::Folder const folder;
  auto const one = halfspace::read_heights(hdf5(folder, {"z"}, "um"));
  check_six(one);
  CHECK(one.unit == "um");
  auto const two = hdf5(folder, {"first", "second"}, "nm");
  check_six(halfspace::read_heights(two, "second"));
  CHECK(holds(told(two, "dataset"), "name one of first, second"));
  CHECK(holds(told(two, "dataset", "third"), "no data set \"third\""));
}

TEST_CASE("what is wrong with a file of heights is told with its place") {
  test::Folder const folder;
  auto const of = [&](std::string const& bytes) { return told(written(folder, "a.csv", bytes)); };
  CHECK(holds(of("1,2\n3,nan\n"), "row 2, column 2 (line 2): 'nan' is a hole"));
  CHECK(holds(of("# Width: 1 m\n1,2,3\n3,,4\n"), "row 2, column 2 (line 3): '' is a hole"));
  CHECK(holds(of("1 2\n3 Bad\n"), "'Bad' is a hole"));
  CHECK(holds(of("1,2\n3,1e999\n"), "is a hole"));
  CHECK(holds(of("1,2\n3,x4\n"), "row 2, column 2 (line 2): 'x4' is no number"));
  CHECK(holds(of("1;2\n3,5;4\n"), "'3,5' is no number"));
  CHECK(holds(of("1 2 3\n4 5\n"), "row 2 (line 2) has 2 heights, those before it 3"));
  CHECK(holds(of("# nothing\n"), "holds no heights"));
  CHECK(holds(of("# Width: 5 V\n1 2\n"), "'5 V' is no length > 0"));
  CHECK(holds(told((folder.path() / "none.csv").string()), "none.csv: cannot be read (No such file"));
  CHECK(holds(told(written(folder, "a.csv", "1 2\n"), "dataset", "z"), "is no HDF5 file"));
  auto const array = [&](char const* type, char const* shape, std::vector<double> const& values) {
    return told(written(folder, "a.npy", npy(type, "False", shape, values)));
  };
  CHECK(holds(array("<i8", "2, 3", six), "type '<i8'; save it as"));
  CHECK(holds(array("<f8", "1, 2, 3", six), "has 3 dimensions"));
  CHECK(holds(array("<f8", "3, 3", six), "announces 9 heights and holds 6"));
  CHECK(holds(array("<f8", "20000, 20000", six), "at most"));
  CHECK(holds(array("<f8", "-2, -3", six), "no heights"));
  CHECK(holds(array("<f8", "2, 3", {1, 2, 3, 4, NAN, NAN}), "row 2, column 2: nan is a hole (1 more)"));
  CHECK(holds(told(written(folder, "a.npy", std::string("\x93NUMPY\x01", 7))), "is truncated"));
  CHECK(holds(told(written(folder, "a.h5", "\x89HDF\r\n")), "damaged"));
}

/// A wave along x and along y, of n cells each.
HeightFile wave(Index n) {
  HeightFile file{n, n, {}, "", {}, {}};
  for (Index i = 0; i < n * n; ++i)
    file.heights.push_back(std::cos(2 * pi * (i % n + 0.5) / n) + std::sin(2 * pi * (i / n + 0.5) / n));
  return file;
}

/// Largest error at the points of a grid that no multiple of n fits.
double error_between(Index n, Measured::Between how) {
  Grid const grid{57, 45, 1, 1, false, true};
  auto const all = halfspace::resampled(wave(n), grid, how);
  double worst = 0;
  for (Index i = 0; i < grid.size(); ++i)
    worst = std::max(worst, std::abs(all[i] - std::cos(2 * pi * (grid.x(i) + 0.5)) -
                                     std::sin(2 * pi * (grid.y(i) + 0.5))));
  return worst;
}

TEST_CASE("heights between those measured err with the square and the cube of the cells") {
  double const linear = std::log2(error_between(32, Measured::Between::bilinear) /
                                  error_between(64, Measured::Between::bilinear));
  double const cubic = std::log2(error_between(32, Measured::Between::bicubic) /
                                 error_between(64, Measured::Between::bicubic));
  CHECK(linear == doctest::Approx(2).epsilon(0.1));
  CHECK(cubic > 2.8);
  CHECK(error_between(64, Measured::Between::bicubic) < 1e-4);
}

TEST_CASE("resampled to its own points a map is itself, and rims keep their value where nothing repeats") {
  auto const file = wave(6);
  for (bool const periodic : {true, false})
    for (auto const how : {Measured::Between::bilinear, Measured::Between::bicubic}) {
      auto const all = halfspace::resampled(file, Grid{6, 6, 1, 1, false, periodic}, how);
      for (Index i = 0; i < 36; ++i)
        CHECK(all[i] == file.heights[ix(i)]);
    }
  HeightFile const ramp{4, 1, {0, 1, 2, 3}, "", {}, {}};
  auto const rim = halfspace::resampled(ramp, Grid{8, 1, 1, 1, true, false}, Measured::Between::bilinear);
  CHECK(rim[0] == 0);
  CHECK(rim[1] == doctest::Approx(0.25));
  CHECK(rim[7] == 3);
  auto const round = halfspace::resampled(ramp, Grid{8, 1, 1, 1, true, true}, Measured::Between::bilinear);
  CHECK(round[0] == doctest::Approx(0.75)); // a quarter of the way to the 3 beyond the seam
}

TEST_CASE("the step over the seam is compared with those between neighbours") {
  // along y the seam is where a sine is steepest: 1 of the 32 / 2 squares of that step
  CHECK(halfspace::seam(wave(32)) == doctest::Approx(std::sqrt(31.0 / 15)).epsilon(1e-12));
  HeightFile const ramp{4, 1, {0, 1, 2, 3}, "", {}, {}};
  CHECK(halfspace::seam(ramp) == doctest::Approx(3));
  CHECK(halfspace::seam({3, 1, {2, 2, 2}, "", {}, {}}) == 0);
}

struct Case {
  Measured map;
  Grid grid{3, 2, 3, 2, false, false};
  [[nodiscard]] std::string told(char const* key) const {
    try {
      static_cast<void>(halfspace::heights(map, grid));
    } catch (core::InputError const& error) {
      CHECK(error.complaints().at(0).path == key);
      return error.complaints().at(0).text;
    }
    return "nothing";
  }
};

TEST_CASE("peaks of a measured map touch first, in its unit") {
  test::Folder const folder;
  Case one;
  one.map.file = written(folder, "a.csv", "1,2,3\n4,5,0\n");
  one.map.unit = "um";
  one.map.size = {3, 2};
  auto const all = halfspace::heights(one.map, one.grid);
  CHECK(all[4] == 0);
  CHECK(all[0] == doctest::Approx(4e-6).epsilon(1e-12));
  CHECK(all[5] == doctest::Approx(5e-6).epsilon(1e-12));
  one.map.start = halfspace::Start::mean;
  CHECK(std::abs(halfspace::heights(one.map, one.grid).mean()) < 1e-20);
}

TEST_CASE("a measured map that does not fit the half space is refused") {
  test::Folder const folder;
  Case sound;
  sound.map.file = written(folder, "a.csv", "1,2,3\n4,5,0\n");
  sound.map.unit = "um";
  sound.map.size = {3, 2};
  CHECK(sound.told("") == "nothing");
  auto other = sound;
  other.map.unit = "";
  CHECK(holds(other.told("unit"), "does not say in what"));
  other.map.unit = "V";
  CHECK(holds(other.told("unit"), "no length"));
  other = sound;
  other.map.size = {};
  CHECK(holds(other.told("size"), "does not say how wide"));
  other.map.size = {3, 3};
  CHECK(holds(other.told("size"), "3 m along y; the surface is 2 m wide"));
  other.map.size = {3};
  CHECK(holds(other.told("size"), "give {x, y}"));
  other = sound;
  other.grid.nx = 4;
  CHECK(holds(other.told("interpolation"), "3 x 2 heights, the surface 4 x 2"));
  other = sound;
  other.grid.periodic = true;
  other.map.seam = 0.5;
  CHECK(holds(other.told("seam"), "it is not periodic"));
  other = sound;
  other.map.file = written(folder, "b.csv", "# Width: 3 m\n# Height: 2 m\n# Value units: V\n1,2,3\n4,5,0\n");
  CHECK(holds(other.told("file"), "in 'V', which is no length"));
  other.map.file = written(folder, "c.csv", "# Width: 3 m\n# Value units: nm\n1,2,3\n4,5,0\n");
  CHECK(holds(other.told("unit"), "says 'nm'; leave it out"));
  other.map.unit = "";
  other.map.size = {4, 2};
  CHECK(holds(other.told("size"), "says 3 m; leave it out"));
  other = sound;
  other.grid = {3, 1, 3, 1, true, false};
  other.map.size = {3};
  CHECK(holds(other.told("file"), "2 rows; a line of points wants one"));
}

} // namespace
