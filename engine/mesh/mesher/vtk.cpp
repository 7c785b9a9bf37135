// Grids by VTK's own readers; their arrays of whole numbers tell which cells and points belong together.
#include <fmt/format.h>
#include <set>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringOutputWindow.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "core/error.hpp"
#include "mesh/mesher/file_mesh.hpp"

namespace stiction::mesher {

namespace {

constexpr std::size_t most_sets = 100; ///< of one array: more are numbers of cells, not of sets

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// Of "ERROR: In FILE, line N" and then "CLASS (ADDRESS): words" the words.
std::string words_in(std::string const& error) {
  constexpr std::string_view before = "): ";
  auto const start = error.find(before);
  auto const from = start == std::string::npos ? 0 : start + before.size();
  return error.substr(from, error.find('\n', from) - from);
}

Grid read_grid(std::string const& path) {
  vtkNew<vtkStringOutputWindow> log; // what VTK complains about does not go to the screen
  vtkOutputWindow::SetInstance(log);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  Grid grid;
  if (path.ends_with(".vtu")) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    if (reader->CanReadFile(path.c_str()) == 0)
      throw core::InputError("not an unstructured grid of VTK (.vtu): no VTKFile of type UnstructuredGrid");
    reader->SetFileName(path.c_str());
    reader->Update();
    grid = reader->GetOutput();
  } else {
    vtkNew<vtkUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    if (reader->OpenVTKFile() == 0 || reader->ReadHeader() == 0)
      throw core::InputError("not a legacy VTK file: it does not begin with \"# vtk DataFile\"");
    reader->CloseVTKFile();
    if (reader->IsFileUnstructuredGrid() == 0)
      throw core::InputError(
          "the file has no DATASET UNSTRUCTURED_GRID, so no cells; write an unstructured grid");
    reader->Update();
    grid = reader->GetOutput();
  }
  std::string const said = log->GetOutput();
  if (auto const error = said.find("ERR"); error != std::string::npos)
    throw core::InputError("the file is damaged; VTK says: " + words_in(said.substr(error)));
  if (grid->GetNumberOfCells() == 0)
    throw core::InputError("the file has no cells");
  return grid;
}

/// What is no kind of ours is refused with the way out.
[[noreturn]] void refuse_cells(int type) {
  if (type == VTK_BIQUADRATIC_QUAD || type == VTK_TRIQUADRATIC_HEXAHEDRON)
    throw core::InputError(fmt::format(
        "the mesh has cells of kind {}, with nodes in the middle of {}; {} is computed on: write it "
        "with these (VTK's type {}), without the middle nodes",
        type == VTK_BIQUADRATIC_QUAD ? "quad9" : "hex27",
        type == VTK_BIQUADRATIC_QUAD ? "faces" : "faces and cells",
        type == VTK_BIQUADRATIC_QUAD ? "quad8" : "hex20", type == VTK_BIQUADRATIC_QUAD ? "23" : "25"));
  throw core::InputError(
      fmt::format("the mesh has cells of VTK's type {}; known are those of type 5, 22, 9, 23 "
                  "(triangles and quadrilaterals of 3, 6, 4, 8 nodes), 10, 24, 12 and 25 "
                  "(tetrahedra and hexahedra of 4, 10, 8, 20)",
                  type));
}

std::optional<mesh::CellKind> kind_of(int vtk_type) {
  for (auto const& cell : mesh::cell_table())
    if (cell.vtk_type == vtk_type)
      return cell.kind;
  return std::nullopt;
}

Tags nodes_of(vtkUnstructuredGrid& grid, vtkIdType cell) {
  Tags tags;
  for (vtkIdType const point : *grid.GetCell(cell)->GetPointIds())
    tags.push_back(static_cast<std::size_t>(point) + 1);
  return tags;
}

/// Calls visit(set's name, index) for each entry of the arrays that tell sets.
template<class Visit> void each_member(vtkDataSetAttributes& data, Visit const& visit) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    auto* const array = data.GetArray(i);
    bool const whole = array != nullptr && array->GetNumberOfComponents() == 1 &&
                       array->GetDataType() != VTK_DOUBLE && array->GetDataType() != VTK_FLOAT;
    if (!whole || array->GetName() == nullptr || std::string_view(array->GetName()).starts_with("vtk"))
      continue;
    std::set<double> values;
    for (vtkIdType k = 0; k < array->GetNumberOfTuples() && values.size() <= most_sets; ++k)
      values.insert(array->GetComponent(k, 0));
    for (vtkIdType k = 0; k < array->GetNumberOfTuples() && values.size() <= most_sets; ++k)
      visit(fmt::format("{}_{:.0f}", array->GetName(), array->GetComponent(k, 0)), k);
  }
}

int highest_dimension(vtkUnstructuredGrid& grid) {
  int dim = 0;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
    dim = std::max(dim, grid.GetCell(cell)->GetCellDimension());
  return dim;
}

} // namespace

FileMesh read_vtk(std::string const& path) {
  auto const grid = read_grid(path);
  int const dim = highest_dimension(*grid);
  FileMesh mesh;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    grid->GetPoint(i, mesh.nodes[static_cast<std::size_t>(i) + 1].data());
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i) {
    if (grid->GetCell(i)->GetCellDimension() < dim)
      continue;
    auto const kind = kind_of(grid->GetCellType(i));
    if (!kind)
      refuse_cells(grid->GetCellType(i));
    mesh.cells[static_cast<std::size_t>(i) + 1] = {*kind, nodes_of(*grid, i)};
  }
  each_member(*grid->GetCellData(), [&](std::string const& set, vtkIdType i) {
    int const own = grid->GetCell(i)->GetCellDimension();
    if (own == dim)
      mesh.cell_sets[set].push_back(static_cast<std::size_t>(i) + 1);
    else if (own == dim - 1)
      mesh.side_sets[set].push_back(nodes_of(*grid, i));
  });
  each_member(*grid->GetPointData(), [&](std::string const& set, vtkIdType i) {
    if (!mesh.side_sets.contains(set))
      mesh.node_sets[set].push_back(static_cast<std::size_t>(i) + 1);
  });
  return mesh;
}

} // namespace stiction::mesher
