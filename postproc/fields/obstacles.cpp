// Discs and half-planes become polygons; what is hollow or open is a line.
#include "fields/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTriangleFilter.h>

#include "charts/pieces.hpp"
#include "fields/path.hpp"

namespace stiction::postproc {

namespace {

constexpr double near = 0.1; ///< of the view's size: how much of an obstacle is shown beyond the mesh

Point placed(Point p, Point pivot, Pose const& pose) {
  double const c = std::cos(pose.angle), s = std::sin(pose.angle), x = p.x - pivot.x, y = p.y - pivot.y;
  return {pivot.x + c * x - s * y + pose.move[0], pivot.y + s * x + c * y + pose.move[1]};
}

std::vector<Point> circle(Point centre, double radius) {
  constexpr int corners = 360;
  std::vector<Point> points;
  for (int i = 0; i < corners; ++i) {
    double const angle = 2 * std::numbers::pi * i / corners;
    points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
  return points;
}

/// The part of a half-plane that a view can show: a square on its inner side, three views wide.
std::vector<Point> half_plane(Point at, Point outward, Extent const& view) {
  double const length = std::hypot(outward.x, outward.y), size = 3 * std::max(view.width(), view.height());
  Point const n{outward.x / length, outward.y / length}, along{-n.y, n.x};
  Point const middle{(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2};
  double const t = (middle.x - at.x) * along.x + (middle.y - at.y) * along.y;
  auto const corner = [&](double a, double b) {
    return Point{at.x + (t + a) * along.x - b * n.x, at.y + (t + a) * along.y - b * n.y};
  };
  return {corner(-size, 0), corner(size, 0), corner(size, size), corner(-size, size)};
}

Outline outline_of(ObstacleSpec const& obstacle, Pose const& pose, Extent const& view) {
  Outline result;
  if (obstacle.radius > 0) {
    result.points = circle(placed(obstacle.at, obstacle.pivot, pose), obstacle.radius);
  } else if (obstacle.normal) {
    auto const& n = *obstacle.normal;
    auto const at = placed(obstacle.at, obstacle.pivot, pose);
    auto const tip = placed({obstacle.at.x + n.x, obstacle.at.y + n.y}, obstacle.pivot, pose);
    result.points = half_plane(at, {tip.x - at.x, tip.y - at.y}, view);
  } else {
    for (auto const& point : obstacle.outline)
      result.points.push_back(placed(point, obstacle.pivot, pose));
    result.closed = obstacle.closed;
  }
  result.filled = result.closed && !obstacle.hollow;
  return result;
}

/// Whether a point lies within a polygon, by the sides that a ray from it crosses.
bool lies_within(Point p, std::vector<Point> const& polygon) {
  bool within = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    auto const &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x)
      within = !within;
  }
  return within;
}

std::vector<Point> line_of(Outline const& outline) {
  auto line = outline.points;
  if (outline.closed)
    line.push_back(line.front());
  return line;
}

vtkSmartPointer<vtkPolyData> as_cell(std::vector<Point> const& points, bool area) {
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cell;
  cell->InsertNextCell(static_cast<int>(points.size()));
  for (auto const& point : points)
    cell->InsertCellPoint(places->InsertNextPoint(point.x, point.y, 0));
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(places);
  if (area)
    result->SetPolys(cell);
  else
    result->SetLines(cell);
  return result;
}

void add(vtkRenderer& renderer, vtkPolyData* shape, Colour colour, double depth, double width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0, 0, -depth);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  renderer.AddActor(actor);
}

} // namespace

std::vector<Outline> outlines_at(FieldSpec const& field, std::optional<double> time, Extent const& view) {
  std::vector<Outline> result;
  for (auto const& obstacle : field.obstacles)
    result.push_back(outline_of(obstacle, pose_at(obstacle.path, time), view));
  for (int const axis : field.mirror)
    for (std::size_t i = result.size(); i-- > 0;) {
      auto image = result[i];
      for (auto& point : image.points)
        (axis == 0 ? point.x : point.y) *= -1;
      result.push_back(std::move(image));
    }
  return result;
}

void include_near(Extent& view, std::vector<Outline> const& outlines) {
  double const rim = near * std::max(view.width(), view.height());
  Box const box{view.x[0] - rim, view.y[0] - rim, view.width() + 2 * rim, view.height() + 2 * rim};
  std::vector<Point> const corners{
      {box.left, box.bottom}, {box.right(), box.bottom}, {box.right(), box.top()}, {box.left, box.top()}};
  for (auto const& outline : outlines) {
    for (auto const& piece : pieces_within(box, line_of(outline)))
      for (auto const& point : piece)
        view.include({}, {point.x, point.y, 0});
    for (auto const& corner : corners)
      if (outline.filled && lies_within(corner, outline.points))
        view.include({}, {corner.x, corner.y, 0});
  }
}

void add_obstacles(vtkRenderer& renderer, std::vector<Outline> const& outlines, double lift, double scale) {
  for (auto const& outline : outlines) {
    add(renderer, as_cell(line_of(outline), false), mark_grey, lift, scale * points(0.8));
    if (!outline.filled)
      continue;
    vtkNew<vtkTriangleFilter> triangles; // an outline need not be convex
    triangles->SetInputData(as_cell(outline.points, true));
    triangles->Update();
    add(renderer, triangles->GetOutput(), obstacle_grey, 2 * lift, 1);
  }
}

} // namespace stiction::postproc
