// A solid sample in four kinds of cells, on a lattice that has the nodes in the middle of edges too.
#include "samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

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

using Corner = std::array<int, 3>; ///< corners of cells have even numbers
constexpr int cells[3] = {8, 8, 5};
constexpr double cell_size = 1e-3;

class Lattice {
public:
  vtkIdType node(Corner const& corner) {
    auto const [found, is_new] = nodes_.try_emplace(corner, points->GetNumberOfPoints());
    if (is_new)
      points->InsertNextPoint(corner[0] * cell_size / 2, corner[1] * cell_size / 2,
                              corner[2] * cell_size / 2);
    return found->second;
  }
  /// A cell by its corners and, when `second` order, the middles of the edges listed.
  void add(int type, std::vector<Corner> const& corners, std::vector<std::pair<int, int>> const& edges) {
    std::vector<vtkIdType> ids;
    for (auto const& corner : corners)
      ids.push_back(node(corner));
    for (auto const& [a, b] : edges) {
      auto const &p = corners[static_cast<std::size_t>(a)], &q = corners[static_cast<std::size_t>(b)];
      ids.push_back(node({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2}));
    }
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    layer->InsertNextValue(corners[0][2] * cell_size / 2);
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkDoubleArray> layer;

private:
  std::map<Corner, vtkIdType> nodes_;
};

void add_hexahedron(Lattice& lattice, Corner const& o, bool second) {
  static std::vector<std::pair<int, int>> const edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                      {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  std::vector<Corner> corners;
  for (int z = 0; z <= 2; z += 2)
    for (auto const& [x, y] : {std::pair(0, 0), std::pair(2, 0), std::pair(2, 2), std::pair(0, 2)})
      corners.push_back({o[0] + x, o[1] + y, o[2] + z});
  if (second)
    lattice.add(VTK_QUADRATIC_HEXAHEDRON, corners, edges);
  else
    lattice.add(VTK_HEXAHEDRON, corners, {});
}

/// Six tetrahedra along the diagonal of the cube, one for each order of the axes.
void add_tetrahedra(Lattice& lattice, Corner const& o, bool second) {
  static std::vector<std::pair<int, int>> const edges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    std::vector<Corner> corners{o};
    for (auto const axis : order) {
      corners.push_back(corners.back());
      corners.back()[axis] += 2;
    }
    if (order[(std::find(order.begin(), order.end(), 0U) - order.begin() + 1U) % 3] == 2) // odd: left-handed
      std::swap(corners[1], corners[2]);
    if (second)
      lattice.add(VTK_QUADRATIC_TETRA, corners, edges);
    else
      lattice.add(VTK_TETRA, corners, {});
  } while (std::next_permutation(order.begin(), order.end()));
}

void add_fields(Lattice& lattice) {
  vtkNew<vtkDoubleArray> displacement, von_mises, beta, time;
  displacement->SetName("displacement");
  displacement->SetNumberOfComponents(3);
  displacement->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "m");
  von_mises->SetName("von_mises");
  von_mises->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "Pa");
  beta->SetName("beta");
  for (vtkIdType i = 0; i < lattice.points->GetNumberOfPoints(); ++i) {
    double p[3];
    lattice.points->GetPoint(i, p);
    double const x = p[0] * 1e3, y = p[1] * 1e3, z = p[2] * 1e3, r2 = x * x + y * y; // mm
    double const dent = std::exp(-r2 / 6) * z / 5;
    displacement->InsertNextTuple3(0.15e-3 * x * dent, 0.15e-3 * y * dent, -1.2e-3 * dent);
    von_mises->InsertNextValue(5e6 * std::exp(-(r2 + (z - 3.5) * (z - 3.5)) / 6));
    beta->InsertNextValue(z > 4.9 ? std::exp(-r2 / 6) : 0);
  }
  for (vtkDataArray* array : {displacement.Get(), von_mises.Get(), beta.Get()})
    lattice.grid->GetPointData()->AddArray(array);
  lattice.layer->SetName("layer");
  lattice.grid->GetCellData()->AddArray(lattice.layer);
  time->SetName("TimeValue");
  time->InsertNextValue(1e-3);
  lattice.grid->GetFieldData()->AddArray(time);
}

} // namespace

void write_solid(std::filesystem::path const& file, std::string const& kind) {
  std::filesystem::create_directories(file.parent_path());
  Lattice lattice;
  bool const second = kind == "tet10" || kind == "hex20", tetrahedra = kind.starts_with("tet");
  for (int k = 0; k < cells[2]; ++k)
    for (int j = 0; j < cells[1]; ++j)
      for (int i = 0; i < cells[0]; ++i)
        (tetrahedra ? add_tetrahedra : add_hexahedron)(lattice, {2 * i, 2 * j, 2 * k}, second);
  lattice.grid->SetPoints(lattice.points);
  add_fields(lattice);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(lattice.grid);
  writer->Write();
}

} // namespace samples
