// Steps from fields.pvd, grids from .vtu, values in the unit of the figure.
#include "field_data.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkExtractEdges.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWarpVector.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUtilities.h>

#include "core/error.hpp"

namespace stiction::postproc {

namespace {

namespace fs = std::filesystem;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

void check_exists(fs::path const& file) {
  if (!fs::exists(file))
    throw core::RunError(fmt::format("{}: no such file; run its study first", file.string()));
}

/// The file of the step nearest to `time`, or of the last one.
fs::path step_file(fs::path const& index, std::optional<double> time) {
  auto const root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(index.string().c_str()));
  auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr)
    throw core::RunError(fmt::format("{}: is not a ParaView collection", index.string()));
  fs::path found;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    auto* step = collection->GetNestedElement(i);
    double at = 0;
    if (step->GetAttribute("file") == nullptr || step->GetScalarAttribute("timestep", at) == 0)
      continue;
    double const distance = time ? std::abs(at - *time) : -at;
    if (found.empty() || distance < nearest) {
      nearest = distance;
      found = step->GetAttribute("file");
    }
  }
  if (found.empty())
    throw core::RunError(fmt::format("{}: lists no step", index.string()));
  return index.parent_path() / found;
}

Grid read_grid(fs::path const& file) {
  check_exists(file);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  bool const readable = reader->CanReadFile(file.c_str()) != 0;
  if (readable) {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  Grid grid = reader->GetOutput();
  if (!readable || reader->GetErrorCode() != 0 || grid->GetNumberOfCells() == 0)
    throw core::RunError(fmt::format("{}: is not a readable .vtu file with cells", file.string()));
  return grid;
}

std::string array_names(vtkUnstructuredGrid& grid) {
  std::string names;
  for (vtkFieldData* data :
       {static_cast<vtkFieldData*>(grid.GetPointData()), static_cast<vtkFieldData*>(grid.GetCellData())})
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
      names += fmt::format("{}{}", names.empty() ? "" : ", ",
                           data->GetArrayName(i) != nullptr ? data->GetArrayName(i) : "(unnamed)");
  return names.empty() ? "none" : names;
}

double value_at(vtkDataArray& array, vtkIdType row, std::optional<int> component) {
  if (component)
    return array.GetComponent(row, *component);
  if (array.GetNumberOfComponents() == 1)
    return array.GetComponent(row, 0);
  double sum = 0;
  for (int i = 0; i < array.GetNumberOfComponents(); ++i)
    sum += std::pow(array.GetComponent(row, i), 2);
  return std::sqrt(sum);
}

/// What turns the array's values into the unit of the figure. An array that names no unit is taken as SI.
double factor_of(vtkDataArray& array, FieldSpec const& spec, std::string const& where) {
  auto const* word =
      array.HasInformation() ? array.GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
  if (word == nullptr)
    return 1 / spec.unit.si.value;
  auto const unit = core::parse_unit(word);
  if (!unit)
    throw core::RunError(fmt::format("{}: its unit \"{}\" is not known", where, word));
  if (unit->dimension != spec.unit.si.dimension)
    throw core::InputError(fmt::format("{} is in {} [{}], but the figure wants {} [{}]", where, word,
                                       core::to_string(unit->dimension), spec.unit.word,
                                       core::to_string(spec.unit.si.dimension)));
  return unit->value / spec.unit.si.value;
}

/// Adds the array "shown"; says whether it belongs to cells.
bool add_shown(vtkUnstructuredGrid& grid, FieldSpec const& spec, fs::path const& file) {
  auto* array = grid.GetPointData()->GetArray(spec.array.c_str());
  bool const on_cells = array == nullptr;
  if (on_cells)
    array = grid.GetCellData()->GetArray(spec.array.c_str());
  std::string const where = fmt::format("{}: array \"{}\"", file.string(), spec.array);
  if (array == nullptr)
    throw core::RunError(fmt::format("{} is not there; there are: {}", where, array_names(grid)));
  if (spec.component && *spec.component >= array->GetNumberOfComponents())
    throw core::InputError(fmt::format("{}: component {} is asked for, but it has {}", where, *spec.component,
                                       array->GetNumberOfComponents()));
  double const factor = factor_of(*array, spec, where);
  vtkNew<vtkDoubleArray> shown;
  shown->SetName("shown");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    double const value = factor * value_at(*array, i, spec.component);
    if (!std::isfinite(value))
      throw core::RunError(
          fmt::format("{}: value {} is {}; only finite numbers can be drawn", where, i, value));
    shown->InsertNextValue(value);
  }
  if (on_cells)
    grid.GetCellData()->AddArray(shown);
  else
    grid.GetPointData()->AddArray(shown);
  return on_cells;
}

Grid moved(Grid const& grid, fs::path const& file) {
  auto* displacement = grid->GetPointData()->GetArray("displacement");
  if (displacement == nullptr || displacement->GetNumberOfComponents() != 3)
    throw core::RunError(
        fmt::format("{}: has no point array \"displacement\" with 3 components, so it cannot "
                    "be drawn deformed",
                    file.string()));
  vtkNew<vtkWarpVector> warp;
  warp->SetInputData(grid);
  warp->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "displacement");
  warp->Update();
  return vtkUnstructuredGrid::SafeDownCast(warp->GetOutput());
}

/// The window asked for, or the whole grid with a margin of 1 %.
void set_view(FieldData& data, FieldSpec const& spec, vtkUnstructuredGrid& grid) {
  double bounds[6];
  grid.GetBounds(bounds);
  double const margin = 0.01 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  for (int i = 0; i < 4; ++i)
    data.view[i] = bounds[i] + (i % 2 == 0 ? -margin : margin);
  if (!spec.window.empty())
    std::copy(spec.window.begin(), spec.window.end(), data.view);
}

bool in_view(FieldData const& data, double const* point) {
  return point[0] >= data.view[0] && point[0] <= data.view[1] && point[1] >= data.view[2] &&
         point[1] <= data.view[3];
}

bool cell_in_view(FieldData const& data, vtkUnstructuredGrid& grid, vtkIdType cell) {
  double box[6];
  grid.GetCellBounds(cell, box);
  return box[1] >= data.view[0] && box[0] <= data.view[1] && box[3] >= data.view[2] && box[2] <= data.view[3];
}

void set_extremes(FieldData& data, vtkUnstructuredGrid& grid, fs::path const& file) {
  auto* shown =
      data.on_cells ? grid.GetCellData()->GetArray("shown") : grid.GetPointData()->GetArray("shown");
  data.low = std::numeric_limits<double>::infinity();
  data.high = -data.low;
  for (vtkIdType i = 0; i < shown->GetNumberOfTuples(); ++i) {
    if (data.on_cells ? !cell_in_view(data, grid, i) : !in_view(data, grid.GetPoint(i)))
      continue;
    data.low = std::min(data.low, shown->GetComponent(i, 0));
    data.high = std::max(data.high, shown->GetComponent(i, 0));
  }
  if (data.low > data.high)
    throw core::RunError(fmt::format("{}: nothing of the mesh lies within the window", file.string()));
}

} // namespace

FieldData load_field(FieldSpec const& spec) {
  check_exists(spec.file);
  auto const file = spec.file.extension() == ".pvd" ? step_file(spec.file, spec.time) : spec.file;
  auto grid = read_grid(file);
  FieldData data;
  data.on_cells = add_shown(*grid, spec, file);
  if (spec.deformed)
    grid = moved(grid, file);
  set_view(data, spec, *grid);
  set_extremes(data, *grid, file);
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->SetNonlinearSubdivisionLevel(2);
  surface->Update();
  data.surface = surface->GetOutput();
  vtkNew<vtkExtractEdges> edges;
  edges->SetInputData(grid);
  edges->Update();
  data.edges = edges->GetOutput();
  return data;
}

} // namespace stiction::postproc
