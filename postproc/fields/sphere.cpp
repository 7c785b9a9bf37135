// The ball is light grey and thin, so that the colours behind it can still be read.
#include "fields/sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkClipPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>

#include "fields/path.hpp"

namespace stiction::postproc {

namespace {

vtkSmartPointer<vtkPolyData> circle(Frame const& frame, Vector const& centre, double radius) {
  constexpr int corners = 360;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(corners + 1);
  for (int i = 0; i <= corners; ++i) {
    double const angle = 2 * std::numbers::pi * i / corners;
    auto p = frame.in_space({radius * std::cos(angle), radius * std::sin(angle)}, 0);
    for (std::size_t k = 0; k < 3; ++k)
      p[k] += centre[k];
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

/// Whether a side of the crop box cuts or hides part of the ball. Sides along an axis across whose plane the
/// mesh is repeated leave it whole: they cut the mesh before.
bool cuts(FieldSpec const& field, Vector const& centre, std::size_t side) {
  auto const axis = side / 2;
  if (!field.crop[side] || std::count(field.mirror.begin(), field.mirror.end(), static_cast<int>(axis)) > 0)
    return false;
  double const inward = side % 2 == 0 ? 1 : -1;
  return inward * (centre[axis] - *field.crop[side]) < field.sphere->radius;
}

bool is_whole(FieldSpec const& field, Vector const& centre) {
  for (std::size_t side = 0; side < 6; ++side)
    if (cuts(field, centre, side))
      return false;
  return true;
}

/// The ball within the crop box.
vtkSmartPointer<vtkPolyData> ball(FieldSpec const& field, Vector const& centre) {
  vtkNew<vtkSphereSource> source;
  source->SetCenter(centre.data());
  source->SetRadius(field.sphere->radius);
  source->SetThetaResolution(120);
  source->SetPhiResolution(120);
  source->Update();
  vtkSmartPointer<vtkPolyData> result = source->GetOutput();
  for (std::size_t side = 0; side < 6; ++side) {
    if (!cuts(field, centre, side))
      continue;
    double origin[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
    origin[side / 2] = *field.crop[side];
    normal[side / 2] = side % 2 == 0 ? 1 : -1;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin);
    plane->SetNormal(normal);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(result);
    clip->SetClipFunction(plane);
    clip->Update();
    result = clip->GetOutput();
  }
  return result;
}

vtkSmartPointer<vtkActor> actor_of(vtkPolyData* shape, Colour colour) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  return actor;
}

/// Where the ball was cut.
vtkSmartPointer<vtkPolyData> rim_of(vtkPolyData* shape) {
  vtkNew<vtkFeatureEdges> rim;
  rim->SetInputData(shape);
  rim->FeatureEdgesOff();
  rim->NonManifoldEdgesOff();
  rim->ManifoldEdgesOff();
  rim->Update();
  return rim->GetOutput();
}

} // namespace

Vector centre_at(SphereSpec const& sphere, std::optional<double> time) {
  auto const pose = pose_at(sphere.path, time);
  auto centre = sphere.centre;
  for (std::size_t i = 0; i < 3; ++i)
    centre[i] += pose.move[i];
  return centre;
}

void add_sphere(vtkRenderer& renderer, FieldSpec const& field, Vector const& centre, double lift,
                double scale) {
  auto const frame = frame_of(field.view);
  bool const whole = is_whole(field, centre);
  auto const shape = field.view ? ball(field, centre) : vtkSmartPointer<vtkPolyData>();
  auto const line = actor_of(whole ? circle(frame, centre, field.sphere->radius) : rim_of(shape), mark_grey);
  auto const shift = frame.in_space({0, 0}, lift);
  line->SetPosition(shift[0], shift[1], shift[2]);
  line->GetProperty()->LightingOff();
  line->GetProperty()->SetLineWidth(static_cast<float>(scale * points(0.8)));
  renderer.AddActor(line);
  if (!field.view)
    return;
  auto const body = actor_of(shape, Colour{150, 150, 150});
  auto* property = body->GetProperty();
  property->SetOpacity(0.3);
  property->SetAmbient(0.6);
  property->SetDiffuse(0.4);
  property->SetBackfaceCulling(whole ? 1 : 0); // one layer of grey; an opened ball shows its inside
  renderer.AddActor(body);
}

} // namespace stiction::postproc
