// VTK itself reads the .vtu files: points, cells, arrays, units and time are what was written.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "folder.hpp"
#include "record/sample_frame.hpp"

using namespace stiction;

namespace {

void check_array(vtkDataArray* array, int type, std::string const& unit, int components, vtkIdType count) {
  REQUIRE(array != nullptr);
  CHECK(array->GetDataType() == type);
  CHECK(array->GetNumberOfComponents() == components);
  REQUIRE(array->GetNumberOfTuples() == count);
  REQUIRE(array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()));
  CHECK(unit == array->GetInformation()->Get(vtkDataArray::UNITS_LABEL()));
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < count; ++i)
    for (int c = 0; c < components; ++c)
      wrong += array->GetComponent(i, c) != test::sample_value(static_cast<std::size_t>(i * components + c));
  CHECK(wrong == 0);
}

void check_geometry(vtkUnstructuredGrid* grid, record::FieldFrame const& frame) {
  REQUIRE(grid->GetNumberOfPoints() == frame.points.rows());
  REQUIRE(grid->GetNumberOfCells() == static_cast<vtkIdType>(frame.cell_count()));
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    for (int c = 0; c < 3; ++c)
      wrong += grid->GetPoint(i)[c] != frame.points(i, c);
  CHECK(wrong == 0);
  CHECK(grid->GetCellType(0) == VTK_QUAD);
  CHECK(grid->GetCellType(test::strip_columns) == VTK_QUADRATIC_TRIANGLE);
  vtkIdType size = 0;
  vtkIdType const* nodes = nullptr;
  grid->GetCellPoints(test::strip_columns - 1, size, nodes);
  REQUIRE(size == 4);
  CHECK(nodes[1] == 2 * test::strip_columns);
  grid->GetCellPoints(test::strip_columns, size, nodes);
  REQUIRE(size == 6);
  CHECK(nodes[5] == frame.points.rows() - 1);
}

} // namespace

TEST_CASE("VTK reads a frame") {
  test::Folder const folder;
  auto const frame = test::sample_frame();
  record::FieldSeries(folder.path()).write(frame);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "fields" / "000000.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid* const grid = reader->GetOutput();
  check_geometry(grid, frame);
  auto* const points = grid->GetPointData();
  check_array(points->GetArray("displacement"), VTK_FLOAT, "m", 3, frame.points.rows());
  check_array(points->GetArray("beta"), VTK_DOUBLE, "1", 1, frame.points.rows());
  auto* const cells = grid->GetCellData();
  check_array(cells->GetArray("stress"), VTK_FLOAT, "N/m^2 & <\"Pa\">", 6, grid->GetNumberOfCells());
  REQUIRE(cells->GetArray("body") != nullptr);
  CHECK(cells->GetArray("body")->GetComponent(0, 0) == 0);
  CHECK(cells->GetArray("body")->GetComponent(test::strip_columns, 0) == 1);
  REQUIRE(grid->GetFieldData()->GetArray("TimeValue") != nullptr);
  CHECK(grid->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 0.125);
}

TEST_CASE("VTK reads a frame without cells or arrays") {
  test::Folder const folder;
  record::write_vtu(folder / "empty.vtu", {});
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "empty.vtu").c_str());
  reader->Update();
  CHECK(reader->GetErrorCode() == 0);
  CHECK(reader->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE("VTK reads a regular grid as it was written") {
  record::GridFrame frame{0.25, 4, 3, -1.5, 0.5, 0.125, 2, {}};
  frame.point_arrays.push_back({"gap", "m", 1, {}, false});
  frame.point_arrays.push_back({"displacement", "m", 3, {}, true});
  for (auto& array : frame.point_arrays)
    for (std::size_t i = 0; i < 12 * static_cast<std::size_t>(array.components); ++i)
      array.values.push_back(test::sample_value(i));
  test::Folder const folder;
  record::write_vti(folder / "grid.vti", frame);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName((folder / "grid.vti").c_str());
  reader->Update();
  auto* image = reader->GetOutput();
  REQUIRE(image->GetNumberOfPoints() == 12);
  double at[3];
  image->GetPoint(5, at);
  CHECK(at[0] == -1.375);
  CHECK(at[1] == 2.5);
  CHECK(at[2] == 0);
  check_array(image->GetPointData()->GetArray("gap"), VTK_FLOAT, "m", 1, 12);
  check_array(image->GetPointData()->GetArray("displacement"), VTK_DOUBLE, "m", 3, 12);
  CHECK(image->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0) == 0.25);
}
