// Writing samples with the HDF5 C API and VTK's own writer.
#include "samples.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <hdf5.h>
#include <limits>
#include <numbers>

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

namespace samples {

namespace {

void write_dataset(hid_t file, std::string const& name, std::vector<double> const& values, hsize_t columns,
                   std::string const& unit) {
  hsize_t const rows = values.size() / columns, extent[2] = {rows, columns},
                most[2] = {H5S_UNLIMITED, columns};
  hsize_t const chunk[2] = {64, columns};
  int const rank = columns == 1 ? 1 : 2;
  hid_t const space = H5Screate_simple(rank, extent, most);
  hid_t const layout = H5Pcreate(H5P_DATASET_CREATE), links = H5Pcreate(H5P_LINK_CREATE);
  H5Pset_chunk(layout, rank, chunk);
  H5Pset_deflate(layout, 4);
  H5Pset_create_intermediate_group(links, 1);
  hid_t const set = H5Dcreate2(file, name.c_str(), H5T_NATIVE_DOUBLE, space, links, layout, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  hid_t const scalar = H5Screate(H5S_SCALAR), text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, unit.size());
  hid_t const attribute = H5Acreate2(set, "unit", text, scalar, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(attribute, text, unit.data());
  H5Aclose(attribute);
  H5Tclose(text);
  H5Sclose(scalar);
  H5Dclose(set);
  H5Pclose(links);
  H5Pclose(layout);
  H5Sclose(space);
}

/// A block of nx by ny cells whose nodes are mapped by `map(a, b)`, a and b in [0, 1].
template<class Map> void add_block(vtkUnstructuredGrid& grid, vtkPoints& points, int nx, int ny, Map map) {
  vtkIdType const first = points.GetNumberOfPoints();
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      auto const [x, y] = map(static_cast<double>(i) / nx, static_cast<double>(j) / ny);
      points.InsertNextPoint(x, y, 0);
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      vtkIdType const corner = first + j * (nx + 1) + i;
      vtkIdType const nodes[4] = {corner, corner + 1, corner + nx + 2, corner + nx + 1};
      grid.InsertNextCell(VTK_QUAD, 4, nodes);
    }
}

void add_point_data(vtkUnstructuredGrid& grid, double descent) {
  vtkNew<vtkDoubleArray> displacement, von_mises, beta;
  displacement->SetName("displacement");
  displacement->SetNumberOfComponents(3);
  von_mises->SetName("von_mises");
  von_mises->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "Pa");
  beta->SetName("beta");
  for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i) {
    double const *p = grid.GetPoint(i), x = p[0] * 1e3, y = p[1] * 1e3 - 5; // mm from the crown
    bool const above = y > -1e-9;
    double const dent = -descent * std::exp(-x * x / 8) * (above ? 1 : std::exp(y));
    displacement->InsertNextTuple3(0, above ? -descent : dent, 0);
    von_mises->InsertNextValue(4e6 * descent / 1e-3 * std::exp(-(x * x + (y + 0.8) * (y + 0.8)) / 5));
    beta->InsertNextValue(std::abs(x) < 2 && std::abs(y) < 0.1 ? 0.4 : 0);
  }
  grid.GetPointData()->AddArray(displacement);
  grid.GetPointData()->AddArray(von_mises);
  grid.GetPointData()->AddArray(beta);
}

void add_cell_data(vtkUnstructuredGrid& grid) {
  vtkNew<vtkDoubleArray> density;
  density->SetName("density");
  for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i)
    density->InsertNextValue(1000.0 + static_cast<double>(i % 7) * 10);
  grid.GetCellData()->AddArray(density);
}

void write(vtkUnstructuredGrid& grid, std::filesystem::path const& file) {
  std::filesystem::create_directories(file.parent_path());
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(&grid);
  writer->Write();
}

} // namespace

void write_series(std::filesystem::path const& file, double mu) {
  std::vector<double> time, beta, traction, pressure, broken;
  for (int i = 0; i < 200; ++i) {
    double const t = i * 2e-5; // s
    double const sliding = std::max(0.0, t - 1e-3) * 1e3;
    double const bonded = t < 1e-3 ? 0.2 * t / 1e-3 : 0.2;
    time.push_back(t);
    beta.push_back((bonded + 0.4 * mu * (1 - std::exp(-2 * sliding))) * std::exp(-0.3 * sliding));
    traction.push_back(-1e6 * t / 1e-3);
    traction.push_back(8e4 * (0.3 + mu) * sliding * std::exp(-sliding));
    pressure.push_back(t / 1e-3);
    broken.push_back(i == 5 ? std::numeric_limits<double>::quiet_NaN() : 1.0);
  }
  std::filesystem::create_directories(file.parent_path());
  hid_t const handle = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  write_dataset(handle, "/time", time, 1, "s");
  write_dataset(handle, "/crown/beta", beta, 1, "1");
  write_dataset(handle, "/crown/traction", traction, 2, "Pa");
  write_dataset(handle, "/crown/pressure", pressure, 1, "MPa");
  write_dataset(handle, "/crown/broken", broken, 1, "1");
  H5Fclose(handle);
}

void write_grid(std::filesystem::path const& file, double descent) {
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  constexpr double radius = 5e-3;
  add_block(*grid, *points, 36, 10, [](double a, double b) {
    double const angle = std::numbers::pi * (1 - a), r = radius * (0.3 + 0.7 * b);
    return std::pair(r * std::cos(angle), r * std::sin(angle));
  });
  add_block(*grid, *points, 36, 4,
            [](double a, double b) { return std::pair(18e-3 * (a - 0.5), radius + 2e-3 * b); });
  grid->SetPoints(points);
  add_point_data(*grid, descent);
  add_cell_data(*grid);
  write(*grid, file);
}

void write_curved(std::filesystem::path const& file) {
  constexpr double nodes[8][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, -0.5}, {1, 0.5}, {0.5, 1}, {0, 0.5}};
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> beta;
  beta->SetName("beta");
  for (auto const& node : nodes) {
    points->InsertNextPoint(node[0], node[1], 0);
    beta->InsertNextValue(1);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  vtkIdType const cell[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  grid->InsertNextCell(VTK_QUADRATIC_QUAD, 8, cell);
  grid->SetPoints(points);
  grid->GetPointData()->AddArray(beta);
  write(*grid, file);
}

void write_steps(std::filesystem::path const& folder) {
  write_grid(folder / "fields/000000.vtu", 1e-6);
  write_grid(folder / "fields/000010.vtu", 1e-3);
  write_text(folder / "fields.pvd",
             R"(<?xml version="1.0"?>
<VTKFile type="Collection" version="1.0" byte_order="LittleEndian">
<Collection>
<DataSet timestep="0" group="" part="0" file="fields/000000.vtu"/>
<DataSet timestep="0.001" group="" part="0" file="fields/000010.vtu"/>
</Collection>
</VTKFile>
)");
}

void write_text(std::filesystem::path const& file, std::string const& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

} // namespace samples
