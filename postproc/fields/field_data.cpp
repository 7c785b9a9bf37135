// Steps from fields.pvd, grids from .vtu, values in the unit of the figure.
#include "fields/field_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include <vtkCellData.h>
#include <vtkCellDataToPointData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkExtractEdges.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointLocator.h>
#include <vtkUnstructuredGrid.h>
#include <vtkWarpVector.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUtilities.h>

#include "core/error.hpp"
#include "fields/solid.hpp"
#include "fields/sphere.hpp"

namespace stiction::postproc {

namespace {

namespace fs = std::filesystem;

/// A file with the time it shows, in s.
struct Step {
  fs::path file;
  std::optional<double> time;
};

void check_exists(fs::path const& file) {
  if (!fs::exists(file))
    throw core::RunError(fmt::format("{}: no such file; run its study first", file.string()));
}

/// The steps that a .pvd lists, in its order.
std::vector<Step> steps_in(fs::path const& index) {
  auto const root =
      vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(index.string().c_str()));
  auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (collection == nullptr)
    throw core::RunError(fmt::format("{}: is not a ParaView collection", index.string()));
  std::vector<Step> steps;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
    auto* step = collection->GetNestedElement(i);
    double at = 0;
    if (step->GetAttribute("file") != nullptr && step->GetScalarAttribute("timestep", at) != 0)
      steps.push_back({index.parent_path() / step->GetAttribute("file"), at});
  }
  if (steps.empty())
    throw core::RunError(fmt::format("{}: lists no step", index.string()));
  return steps;
}

/// The file of the step nearest to `time`, or of the last one.
Step step_file(fs::path const& index, std::optional<double> time) {
  auto const steps = steps_in(index);
  auto const distance = [time](Step const& step) {
    return time ? std::abs(*step.time - *time) : -*step.time;
  };
  return *std::min_element(steps.begin(), steps.end(),
                           [&](Step const& a, Step const& b) { return distance(a) < distance(b); });
}

/// A regular grid as the quadrangles between its points, which are drawn like those of a mesh.
Grid quadrangles_of(vtkImageData& image) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(image.GetNumberOfPoints());
  for (vtkIdType i = 0; i < image.GetNumberOfPoints(); ++i)
    points->SetPoint(i, image.GetPoint(i));
  auto grid = Grid::New();
  grid->SetPoints(points);
  auto const* const count = image.GetDimensions();
  for (vtkIdType j = 0; j + 1 < count[1]; ++j)
    for (vtkIdType i = 0; i + 1 < count[0]; ++i) {
      vtkIdType const first = j * count[0] + i;
      std::array<vtkIdType, 4> const corners{first, first + 1, first + 1 + count[0], first + count[0]};
      grid->InsertNextCell(VTK_QUAD, 4, corners.data());
    }
  grid->GetPointData()->ShallowCopy(image.GetPointData());
  grid->GetFieldData()->ShallowCopy(image.GetFieldData());
  return grid;
}

Grid read_regular_grid(fs::path const& file) {
  vtkNew<vtkXMLImageDataReader> reader;
  bool const readable = reader->CanReadFile(file.c_str()) != 0;
  if (readable) {
    reader->SetFileName(file.c_str());
    reader->Update();
  }
  if (!readable || reader->GetErrorCode() != 0)
    throw core::RunError(fmt::format("{}: is not a readable .vti file", file.string()));
  auto grid = quadrangles_of(*reader->GetOutput());
  if (grid->GetNumberOfCells() == 0)
    throw core::RunError(
        fmt::format("{}: its points lie on a line, which has no surface to draw; draw lines of a "
                    "probe.contact_line",
                    file.string()));
  return grid;
}

Grid read_grid(fs::path const& file) {
  check_exists(file);
  if (file.extension() == ".vti")
    return read_regular_grid(file);
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

struct Shown {
  bool on_cells = false;
  int numbers = 1; ///< of the array, for each point or cell
};

/// Adds the array "shown".
Shown add_shown(vtkUnstructuredGrid& grid, FieldSpec const& spec, fs::path const& file) {
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
  return {on_cells, array->GetNumberOfComponents()};
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

/// The time that a .vtu itself tells.
std::optional<double> own_time(vtkUnstructuredGrid& grid) {
  auto* array = grid.GetFieldData()->GetArray("TimeValue");
  if (array == nullptr || array->GetNumberOfTuples() == 0)
    return {};
  return array->GetComponent(0, 0);
}

/// What of the mesh is drawn: plane cells, the outer faces of a solid, with their images.
Grid faces_of(Grid grid, FieldSpec const& spec, int numbers) {
  if (spec.view)
    grid = outer_faces(grid);
  for (int const axis : spec.mirror)
    grid = mirrored(grid, axis, mirror_sign(axis, numbers, spec.component));
  return grid;
}

void check_solid(vtkUnstructuredGrid& grid, FieldSpec const& spec, fs::path const& file) {
  int dimension = 0;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell)
    dimension = std::max(dimension, grid.GetCell(cell)->GetCellDimension());
  if (spec.view && dimension < 3)
    throw core::InputError(fmt::format("{}: its mesh is plane; \"view\" wants a solid", file.string()));
  if (!spec.view && dimension == 3)
    throw core::InputError(fmt::format("{}: its mesh is a solid; give a \"view\"", file.string()));
}

Vector point_of(vtkUnstructuredGrid& grid, vtkIdType i) {
  Vector point;
  grid.GetPoint(i, point.data());
  return point;
}

/// The window asked for, or the whole with a margin of 1 %; deep enough for all.
void set_view(FieldData& data, FieldSpec const& spec, vtkUnstructuredGrid& grid) {
  for (vtkIdType i = 0; i < grid.GetNumberOfPoints(); ++i)
    data.view.include(data.frame, point_of(grid, i));
  if (data.sphere)
    data.view.include(data.frame, *data.sphere, spec.sphere->radius);
  data.obstacles = outlines_at(spec, data.time, data.view);
  if (spec.window.empty())
    include_near(data.view, data.obstacles);
  auto const& window = spec.window;
  double const margin = 0.01 * std::max(data.view.width(), data.view.height());
  for (std::size_t i = 0; i < 2; ++i) {
    double const beyond = i == 0 ? -margin : margin;
    data.view.x[i] = window.empty() ? data.view.x[i] + beyond : window[i];
    data.view.y[i] = window.empty() ? data.view.y[i] + beyond : window[2 + i];
  }
}

bool cell_in_view(FieldData const& data, vtkUnstructuredGrid& grid, vtkIdType cell) {
  auto* points = grid.GetCell(cell)->GetPointIds();
  Extent own;
  for (auto const point : *points)
    own.include(data.frame, point_of(grid, point));
  auto const& view = data.view;
  return own.x[1] >= view.x[0] && own.x[0] <= view.x[1] && own.y[1] >= view.y[0] && own.y[0] <= view.y[1];
}

void set_extremes(FieldData& data, vtkUnstructuredGrid& grid, fs::path const& file) {
  auto* shown =
      data.on_cells ? grid.GetCellData()->GetArray("shown") : grid.GetPointData()->GetArray("shown");
  data.low = std::numeric_limits<double>::infinity();
  data.high = -data.low;
  for (vtkIdType i = 0; i < shown->GetNumberOfTuples(); ++i) {
    if (data.on_cells ? !cell_in_view(data, grid, i)
                      : !data.view.contains(data.frame.project(point_of(grid, i))))
      continue;
    data.low = std::min(data.low, shown->GetComponent(i, 0));
    data.high = std::max(data.high, shown->GetComponent(i, 0));
  }
  if (data.low > data.high)
    throw core::RunError(fmt::format("{}: nothing of the mesh lies within the window", file.string()));
}

vtkSmartPointer<vtkPolyData> surface_of(Grid const& faces) {
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(faces);
  surface->SetNonlinearSubdivisionLevel(2);
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> edges_of(Grid const& faces) {
  vtkNew<vtkExtractEdges> edges;
  edges->SetInputData(faces);
  edges->Update();
  return edges->GetOutput();
}

/// Gives the points of lines the values of the surface there, those of cells as means at their corners.
void add_values(vtkPolyData& lines, vtkPolyData* surface, bool on_cells) {
  vtkNew<vtkCellDataToPointData> at_points;
  at_points->SetInputData(surface);
  at_points->Update();
  auto* values = (on_cells ? at_points->GetPolyDataOutput() : surface)->GetPointData()->GetArray("shown");
  vtkNew<vtkPointLocator> nearest;
  nearest->SetDataSet(surface);
  nearest->BuildLocator();
  vtkNew<vtkDoubleArray> shown;
  shown->SetName("shown");
  for (vtkIdType i = 0; i < lines.GetNumberOfPoints(); ++i)
    shown->InsertNextValue(values->GetComponent(nearest->FindClosestPoint(lines.GetPoint(i)), 0));
  lines.GetPointData()->Initialize();
  lines.GetPointData()->AddArray(shown);
}

bool is_cropped(FieldSpec const& spec) {
  return std::any_of(spec.crop.begin(), spec.crop.end(), [](auto const& side) { return side.has_value(); });
}

} // namespace

std::vector<double> times_of(fs::path const& index) {
  check_exists(index);
  std::vector<double> times;
  for (auto const& step : steps_in(index))
    times.push_back(*step.time);
  std::sort(times.begin(), times.end());
  return times;
}

FieldData load_field(FieldSpec const& spec) {
  check_exists(spec.file);
  auto const step = spec.file.extension() == ".pvd" ? step_file(spec.file, spec.time) : Step{spec.file, {}};
  auto grid = read_grid(step.file);
  FieldData data;
  data.time = step.time ? step.time : own_time(*grid);
  check_solid(*grid, spec, step.file);
  auto const shown = add_shown(*grid, spec, step.file);
  data.on_cells = shown.on_cells;
  if (spec.deformed)
    grid = moved(grid, step.file);
  data.frame = frame_of(spec.view);
  if (spec.sphere)
    data.sphere = centre_at(*spec.sphere, data.time);
  auto const kept = cropped(grid, spec.crop);
  if (kept->GetNumberOfCells() == 0)
    throw core::RunError(fmt::format("{}: nothing of the mesh lies within \"crop\"", step.file.string()));
  auto const faces = faces_of(kept, spec, shown.numbers);
  set_view(data, spec, *faces);
  set_extremes(data, *faces, step.file);
  data.surface = surface_of(faces);
  data.edges =
      is_cropped(spec) // cut cells would show the pieces they fell into
          ? cropped_lines(*edges_of(off_planes(outer_faces(grid), spec.mirror)), spec.crop, spec.mirror)
          : edges_of(faces);
  if (spec.mesh)
    add_values(*data.edges, data.surface, data.on_cells);
  return data;
}

} // namespace stiction::postproc
