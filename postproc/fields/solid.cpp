// Cutting and faces by VTK; the image by hand, since points in the plane must be shared.
#include "fields/solid.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExtractCells.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkTableBasedClipDataSet.h>
#include <vtkUnstructuredGridGeometryFilter.h>

#include "core/error.hpp"

namespace stiction::postproc {

namespace {

constexpr char axis_letter(int axis) {
  return "xyz"[axis];
}

double size_of(vtkUnstructuredGrid& grid) {
  double bounds[6];
  grid.GetBounds(bounds);
  return std::max({bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]});
}

Grid extracted(Grid const& grid, vtkIdList* cells) {
  vtkNew<vtkExtractCells> extract;
  extract->SetInputData(grid);
  extract->SetCellList(cells);
  extract->Update();
  return extract->GetOutput();
}

/// How far a cell reaches beyond side `side` of a box, and how far to within it, in m.
std::pair<double, double> reach(vtkUnstructuredGrid& grid, vtkIdType cell, std::size_t side, double at) {
  double box[6];
  grid.GetCellBounds(cell, box);
  std::size_t const low = side - side % 2;
  double const below = at - box[low], above = box[low + 1] - at;
  return side % 2 == 0 ? std::pair(below, above) : std::pair(above, below);
}

/// What lies within one side. Cells that only touch it go or stay whole; the cut itself is moved inwards by a
/// hair, since cutting through nodes leaves flat pieces.
Grid cut(Grid const& grid, std::size_t side, double at) {
  double const hair = 1e-6 * size_of(*grid);
  vtkNew<vtkIdList> kept;
  bool crossed = false;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
    auto const [beyond, within] = reach(*grid, cell, side, at);
    if (within > hair)
      kept->InsertNextId(cell);
    crossed = crossed || (within > hair && beyond > hair);
  }
  auto const part = extracted(grid, kept);
  if (!crossed)
    return part;
  double const inward = side % 2 == 0 ? 1 : -1;
  double origin[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
  origin[side / 2] = at + inward * hair;
  normal[side / 2] = inward;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
  vtkNew<vtkTableBasedClipDataSet> clip;
  clip->SetInputData(part);
  clip->SetClipFunction(plane);
  clip->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  clip->Update();
  return clip->GetOutput();
}

/// Nodes of a plane cell the other way round: the first corner stays. Second-order cells have as many nodes
/// on their sides as corners.
std::vector<vtkIdType> turned(std::vector<vtkIdType> nodes, int corners) {
  auto const n = static_cast<std::ptrdiff_t>(corners);
  std::reverse(nodes.begin() + 1, nodes.begin() + n);
  if (static_cast<std::ptrdiff_t>(nodes.size()) >= 2 * n)
    std::reverse(nodes.begin() + n, nodes.begin() + 2 * n);
  return nodes;
}

using Segment = std::array<Vector, 2>;

std::vector<Segment> segments_of(vtkPolyData& lines) {
  std::vector<Segment> result;
  vtkNew<vtkIdList> ids;
  for (lines.GetLines()->InitTraversal(); lines.GetLines()->GetNextCell(ids) != 0;)
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i) {
      Segment segment;
      lines.GetPoint(ids->GetId(i - 1), segment[0].data());
      lines.GetPoint(ids->GetId(i), segment[1].data());
      result.push_back(segment);
    }
  return result;
}

vtkSmartPointer<vtkPolyData> as_lines(std::vector<Segment> const& segments) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (auto const& [a, b] : segments) {
    vtkIdType const ends[2] = {points->InsertNextPoint(a.data()), points->InsertNextPoint(b.data())};
    lines->InsertNextCell(2, ends);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

/// The part of a segment within the box: what each side leaves of its parameter (Liang and Barsky 1984).
std::optional<Segment> within(Segment const& segment, CropBox const& box) {
  auto const& [a, b] = segment;
  double from = 0, to = 1;
  for (std::size_t side = 0; side < 6; ++side) {
    if (!box[side])
      continue;
    double const inward = side % 2 == 0 ? 1 : -1;
    double const depth = inward * (a[side / 2] - *box[side]), step = inward * (b[side / 2] - a[side / 2]);
    if (step > 0)
      from = std::max(from, -depth / step);
    else if (step < 0)
      to = std::min(to, -depth / step);
    else if (depth < 0)
      return {};
  }
  if (from >= to)
    return {};
  Segment part;
  for (std::size_t i = 0; i < 3; ++i)
    part[0][i] = std::lerp(a[i], b[i], from);
  for (std::size_t i = 0; i < 3; ++i)
    part[1][i] = std::lerp(a[i], b[i], to);
  return part;
}

/// A grid and its image in the making.
class Doubling {
public:
  Doubling(Grid const& grid, int axis, double sign) : grid_(grid), axis_(axis), sign_(sign) {}
  Grid result() {
    check_one_side();
    double_points();
    double_cells();
    return made_;
  }

private:
  void check_one_side() const {
    double bounds[6];
    grid_->GetBounds(bounds);
    double const low = bounds[2 * axis_], high = bounds[2 * axis_ + 1], slack = 0.01 * (high - low);
    if (low < -slack && high > slack)
      throw core::RunError(
          fmt::format("mirror: the mesh lies on both sides of {0} = 0, from {1:g} m to {2:g} m; "
                      "only one side can be repeated",
                      axis_letter(axis_), low, high));
  }
  void double_points() {
    auto* given = vtkDoubleArray::SafeDownCast(grid_->GetPointData()->GetArray("shown"));
    double const tolerance = 1e-6 * size_of(*grid_);
    vtkIdType const count = grid_->GetNumberOfPoints();
    points_->SetDataTypeToDouble();
    points_->DeepCopy(grid_->GetPoints());
    for (vtkIdType i = 0; i < count; ++i) {
      double p[3];
      grid_->GetPoint(i, p);
      bool const shared = std::abs(p[axis_]) <= tolerance;
      p[axis_] = -p[axis_];
      twins_.push_back(shared ? i : points_->InsertNextPoint(p));
    }
    if (given == nullptr)
      return;
    values_->DeepCopy(given);
    for (vtkIdType i = 0; i < count; ++i)
      if (twins_[static_cast<std::size_t>(i)] != i)
        values_->InsertNextValue(sign_ * given->GetValue(i));
    made_->GetPointData()->AddArray(values_);
  }
  void insert(int type, std::vector<vtkIdType> const& nodes, double const* value) {
    made_->InsertNextCell(type, static_cast<vtkIdType>(nodes.size()), nodes.data());
    if (value != nullptr)
      cell_values_->InsertNextValue(*value);
  }
  void double_cells() {
    auto* given = vtkDoubleArray::SafeDownCast(grid_->GetCellData()->GetArray("shown"));
    cell_values_->SetName("shown");
    made_->SetPoints(points_);
    made_->Allocate(2 * grid_->GetNumberOfCells());
    for (vtkIdType cell = 0; cell < grid_->GetNumberOfCells(); ++cell) {
      vtkNew<vtkIdList> ids;
      grid_->GetCellPoints(cell, ids);
      std::vector<vtkIdType> const nodes(ids->begin(), ids->end());
      auto image = nodes;
      for (auto& node : image)
        node = twins_[static_cast<std::size_t>(node)];
      if (image == nodes)
        continue;
      double const value = given == nullptr ? 0 : given->GetValue(cell), twin = sign_ * value;
      int const type = grid_->GetCellType(cell), corners = grid_->GetCell(cell)->GetNumberOfEdges();
      insert(type, nodes, given == nullptr ? nullptr : &value);
      insert(type, turned(image, corners), given == nullptr ? nullptr : &twin);
    }
    if (given != nullptr)
      made_->GetCellData()->AddArray(cell_values_);
  }

  Grid grid_;
  int axis_;
  double sign_;
  std::vector<vtkIdType> twins_; ///< image of each point, or itself
  vtkNew<vtkPoints> points_;
  vtkNew<vtkDoubleArray> values_, cell_values_;
  Grid made_ = Grid::New();
};

} // namespace

Grid cropped(Grid const& grid, CropBox const& box) {
  Grid result = grid;
  for (std::size_t side = 0; side < 6; ++side)
    if (box[side] && result->GetNumberOfCells() > 0)
      result = cut(result, side, *box[side]);
  return result;
}

Grid off_planes(Grid const& faces, std::vector<int> const& axes) {
  double const tolerance = 1e-6 * size_of(*faces);
  vtkNew<vtkIdList> kept;
  for (vtkIdType cell = 0; cell < faces->GetNumberOfCells(); ++cell) {
    double box[6];
    faces->GetCellBounds(cell, box);
    if (std::none_of(axes.begin(), axes.end(),
                     [&](int axis) { return std::max(-box[2 * axis], box[2 * axis + 1]) <= tolerance; }))
      kept->InsertNextId(cell);
  }
  return extracted(faces, kept);
}

vtkSmartPointer<vtkPolyData> cropped_lines(vtkPolyData& lines, CropBox const& box,
                                           std::vector<int> const& mirror) {
  std::vector<Segment> kept;
  for (auto const& segment : segments_of(lines))
    if (auto const part = within(segment, box))
      kept.push_back(*part);
  for (int const axis : mirror)
    for (std::size_t i = kept.size(); i-- > 0;) {
      auto image = kept[i];
      for (auto& end : image)
        end[static_cast<std::size_t>(axis)] *= -1;
      kept.push_back(image);
    }
  return as_lines(kept);
}

Grid outer_faces(Grid const& grid) {
  vtkNew<vtkUnstructuredGridGeometryFilter> filter;
  filter->SetInputData(grid);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
}

Grid mirrored(Grid const& grid, int axis, double sign) {
  return Doubling(grid, axis, sign).result();
}

double mirror_sign(int axis, int numbers, std::optional<int> component) {
  static constexpr int pairs[3][2] = {{0, 1}, {1, 2}, {0, 2}};
  if (!component)
    return 1;
  if (numbers == 3)
    return *component == axis ? -1 : 1;
  if (numbers != 6 || *component < 3)
    return 1;
  auto const& pair = pairs[*component - 3];
  return pair[0] == axis || pair[1] == axis ? -1 : 1;
}

} // namespace stiction::postproc
