// Frames on disk: numbering, the list by time, what is refused. The format itself is read back in vtk/.
#include "record/fields.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "folder.hpp"
#include "record/sample_frame.hpp"

using namespace stiction;

namespace {
std::string read(std::filesystem::path const& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}
} // namespace

TEST_SUITE_BEGIN("record");

TEST_CASE("bodies of a frame follow each other") {
  auto const frame = test::sample_frame();
  auto const first = static_cast<Index>(test::strip().nodes.rows());
  CHECK(frame.points.rows() == first + 6);
  CHECK(frame.cell_count() == test::strip_columns + 1);
  CHECK(frame.blocks[1].nodes[0] == first);
  CHECK(frame.points(first + 3, 0) == 0.5);
  CHECK(frame.points(first + 3, 2) == 0);
  CHECK(frame.cell_body.front() == 0);
  CHECK(frame.cell_body.back() == 1);
}

TEST_CASE("frames are numbered and listed by time") {
  test::Folder const folder;
  record::FieldSeries series(folder.path());
  auto frame = test::sample_frame();
  series.write(frame);
  frame.time = 0.5;
  series.write(frame);
  CHECK(series.frames() == 2);
  std::string const list = read(folder / "fields.pvd");
  CHECK(list.find("timestep=\"0.125\" file=\"fields/000000.vtu\"") != std::string::npos);
  CHECK(list.find("timestep=\"0.5\" file=\"fields/000001.vtu\"") != std::string::npos);
  CHECK(std::filesystem::exists(folder / "fields" / "000001.vtu"));
  CHECK_FALSE(std::filesystem::exists(folder / "fields" / "000001.vtu.part"));
}

TEST_CASE("a new field series removes the frames of the last and nothing else") {
  test::Folder const folder;
  record::FieldSeries(folder.path()).write(test::sample_frame());
  std::ofstream(folder / "fields" / "notes.vtu") << "mine";
  record::FieldSeries const again(folder.path());
  CHECK_FALSE(std::filesystem::exists(folder / "fields" / "000000.vtu"));
  CHECK_FALSE(std::filesystem::exists(folder / "fields.pvd"));
  CHECK(std::filesystem::exists(folder / "fields" / "notes.vtu"));
}

TEST_CASE("field arrays of a wrong length are our bug") {
  test::Folder const folder;
  auto frame = test::sample_frame();
  frame.point_arrays[0].values.pop_back();
  CHECK_THROWS_AS(record::write_vtu(folder / "x.vtu", frame), core::Bug);
  CHECK_FALSE(std::filesystem::exists(folder / "x.vtu"));
}

TEST_SUITE_END();
