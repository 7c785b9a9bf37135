// The mesh in a viewport of its own; colour bar, scale bar and words drawn over it.
#include "fields/field.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFeatureEdges.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include "charts/axis.hpp"
#include "core/error.hpp"
#include "fields/field_data.hpp"
#include "fields/sphere.hpp"
#include "fields/triad.hpp"
#include "page/window.hpp"

namespace stiction::postproc {

namespace {

constexpr double crease_angle = 40; ///< degrees between faces that meet in a visible edge
constexpr double light_lines = 0.5; ///< fraction of the colours below which the lines on them are light

/// What goes where, in pixels.
struct FieldLayout {
  FigureSpec const& figure;
  FieldSpec const& spec;
  Scale scale; ///< of the colours
  Ticks ticks;
  Size picture;
  Box mesh, bar;
  Frame frame;
  std::string when;                            ///< the time shown, empty: none
  double scale_bar = 0;                        ///< its length; 0: none
  bool more_below = false, more_above = false; ///< values beyond the colours
};

/// "t = 8 ms": four digits in the unit that needs the fewest zeros.
std::string time_words(double time) {
  constexpr std::pair<double, char const*> units[] = {{1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}};
  for (auto const& [unit, word] : units)
    if (std::abs(time) >= 0.9999999 * unit)
      return fmt::format("t = {:.4g} {}", time / unit, word);
  return fmt::format("t = {:.4g} s", time);
}

Scale colour_scale(FieldSpec const& spec, FieldData const& data) {
  if (spec.range)
    return {spec.range->first, spec.range->second, false};
  auto const [low, high] = colour_range(data.low, data.high);
  return {low, high, false};
}

/// The mesh as large as the width allows, at most as high as given (or 1.2 times as high as wide).
void lay_out_mesh(FieldLayout& layout, FieldData const& data) {
  double const pad = points(edge), room = layout.figure.width - 2 * pad;
  double const width = data.view.width(), height = data.view.height();
  double const heading_room = heading_height(heading(layout.figure) + layout.when);
  double const given = layout.figure.height - layout.mesh.bottom - heading_room - pad;
  double const most = layout.figure.height > 0 ? given : 1.2 * room;
  if (most < points(30))
    throw core::InputError(fmt::format("a height of {:.0f} mm leaves no room for the mesh; give more",
                                       layout.figure.height / millimetres(1)));
  double const scale = std::min(room / width, most / height);
  layout.mesh.width = std::max(1.0, std::round(scale * width));
  layout.mesh.height = std::max(1.0, std::round(scale * height));
  layout.mesh.left = std::round((layout.figure.width - layout.mesh.width) / 2);
  double const free = layout.figure.height > 0 ? std::max(0.0, given - layout.mesh.height) : 0;
  layout.mesh.bottom = std::round(layout.mesh.bottom + free / 2);
  layout.picture = {static_cast<double>(layout.figure.width),
                    std::round(layout.mesh.top() + free / 2 + heading_room + pad)};
}

FieldLayout lay_out(FigureSpec const& figure, FieldSpec const& spec, FieldData const& data) {
  FieldLayout layout{figure, spec, colour_scale(spec, data), {}, {}, {}, {}, data.frame, {}, 0, false, false};
  if (spec.show_time && data.time)
    layout.when = time_words(*data.time);
  layout.more_below = data.low < layout.scale.low;
  layout.more_above = data.high > layout.scale.high;
  double const width = figure.width;
  layout.bar = {std::round(0.15 * width), 0, std::round(0.7 * width), std::round(millimetres(2.4))};
  layout.ticks = fitting_ticks(layout.scale, layout.bar.width, Direction::across);
  double const labels = points(tick_length + tick_gap) + label_extent(layout.ticks).height + points(2);
  layout.bar.bottom = std::round(points(edge) + line_height(label_size) + labels);
  double const scale_bar_room = spec.scale_bar ? line_height(tick_size) + points(5) : 0;
  double const triad_room = spec.view ? triad_box(data.frame).height + points(3) : 0;
  layout.mesh.bottom = std::round(layout.bar.top() + points(5) + std::max(scale_bar_room, triad_room));
  lay_out_mesh(layout, data);
  if (spec.scale_bar) {
    double const length = spec.scale_bar->length * spec.scale_bar->unit.si.value;
    layout.scale_bar = length / data.view.width() * layout.mesh.width;
    if (layout.scale_bar > layout.mesh.width)
      throw core::InputError(fmt::format("scale_bar: {:g} {} is longer than the view ({:.3g} m)",
                                         spec.scale_bar->length, spec.scale_bar->unit.word,
                                         data.view.width()));
  }
  return layout;
}

void draw_colour_bar(Canvas& canvas, FieldLayout const& layout) {
  constexpr int colours = 256;
  Box const& bar = layout.bar;
  for (int i = 0; i < colours; ++i) {
    double const left = std::round(bar.left + i * bar.width / colours); // to the end: no seams between them
    canvas.fill(Box{left, bar.bottom, bar.right() - left, bar.height}, viridis(i / (colours - 1.0)));
  }
  double const tip = bar.height * 0.8, middle = bar.bottom + bar.height / 2;
  Pen const pen;
  canvas.frame(bar, pen);
  auto arrow = [&](double base, double end, Colour colour) {
    canvas.fill({{base, bar.bottom}, {end, middle}, {base, bar.top()}}, colour);
    canvas.stroke({{base, bar.bottom}, {end, middle}, {base, bar.top()}}, pen);
  };
  if (layout.more_below)
    arrow(bar.left, bar.left - tip, viridis(0));
  if (layout.more_above)
    arrow(bar.right(), bar.right() + tip, viridis(1));
  draw_ticks(canvas, layout.ticks, layout.scale, bar, Direction::across);
  std::string const title = axis_title(layout.spec.label, layout.spec.unit.word, layout.ticks.power);
  Lettering lettering;
  lettering.across = Across::centre;
  lettering.size = fitting_size(title, label_size, layout.picture.width - 2 * points(edge));
  canvas.text(title, {bar.left + bar.width / 2, points(edge)}, lettering);
}

void draw_scale_bar(Canvas& canvas, FieldLayout const& layout) {
  if (!layout.spec.scale_bar)
    return;
  auto const& bar = *layout.spec.scale_bar;
  double const right = layout.mesh.right(), left = right - layout.scale_bar;
  double const y = layout.mesh.bottom - points(3);
  canvas.stroke({{left, y}, {right, y}}, {ink, points(1.5), Dash::solid});
  std::string const label = fmt::format("{:g} {}", bar.length, printed_unit(bar.unit.word));
  Lettering lettering;
  lettering.across = Across::right;
  lettering.along = Along::top;
  double const width = measure(label, tick_size).width;
  canvas.text(label, {std::min(right, (left + right + width) / 2), y - points(2)}, lettering);
}

vtkSmartPointer<vtkLookupTable> make_colours(Scale const& scale) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  table->SetRange(scale.low, scale.high);
  for (int i = 0; i < 256; ++i) {
    auto const colour = viridis(i / 255.0);
    table->SetTableValue(i, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  }
  return table;
}

/// Corners stay sharp, curved sides made of flat faces look smooth.
vtkSmartPointer<vtkPolyData> with_normals(vtkPolyData* surface) {
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(surface);
  normals->SetFeatureAngle(crease_angle);
  normals->Update();
  return normals->GetOutput();
}

/// A light over the left shoulder; ambient and diffuse parts add up to 1, so that no colour is brighter than
/// on the bar, and none is darker than 0.75 of it.
void light(vtkRenderer& renderer, vtkProperty& property) {
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToCameraLight();
  lamp->SetPosition(-0.3, 0.6, 1);
  renderer.AddLight(lamp);
  property.SetAmbient(0.75);
  property.SetDiffuse(0.25);
}

void add_surface(vtkRenderer& renderer, FieldData const& data, FieldLayout const& layout) {
  vtkNew<vtkPolyDataMapper> mapper;
  bool const solid = layout.spec.view.has_value();
  mapper->SetInputData(solid ? with_normals(data.surface) : data.surface);
  auto const colours = make_colours(layout.scale);
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetInterpolateScalarsBeforeMapping(!data.on_cells);
  if (data.on_cells)
    mapper->SetScalarModeToUseCellFieldData();
  else
    mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray("shown");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  if (solid)
    light(renderer, *actor->GetProperty());
  else
    actor->GetProperty()->LightingOff();
  renderer.AddActor(actor);
}

/// Light where the colours are dark, dark where they are light.
vtkSmartPointer<vtkLookupTable> make_contrast(Scale const& scale) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  constexpr int steps = 100;
  table->SetNumberOfTableValues(steps);
  table->SetRange(scale.low, scale.high);
  for (int i = 0; i < steps; ++i) {
    auto const colour = i < light_lines * steps ? mesh_light : ink;
    table->SetTableValue(i, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  }
  return table;
}

/// Lines just in front of the mesh, of one colour or, given a table, by their values.
void add_lines(vtkRenderer& renderer, vtkPolyData* lines, double width, Vector const& lift,
               vtkLookupTable* colours = nullptr) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines);
  mapper->SetScalarVisibility(colours != nullptr);
  if (colours != nullptr) {
    mapper->SetLookupTable(colours);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray("shown");
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(lift[0], lift[1], lift[2]);
  auto* property = actor->GetProperty();
  property->LightingOff();
  property->SetColor(ink.red / 255.0, ink.green / 255.0, ink.blue / 255.0);
  property->SetLineWidth(static_cast<float>(width));
  renderer.AddActor(actor);
}

/// The rim of a plane mesh, the creases of a solid.
void add_outline(vtkRenderer& renderer, FieldData const& data, FieldLayout const& layout, Vector const& lift,
                 double scale) {
  vtkNew<vtkFeatureEdges> outline;
  outline->SetInputData(data.surface);
  outline->SetFeatureEdges(layout.spec.view.has_value());
  outline->SetFeatureAngle(crease_angle);
  outline->NonManifoldEdgesOff();
  outline->ManifoldEdgesOff();
  outline->Update();
  add_lines(renderer, outline->GetOutput(), scale * points(frame_width), lift);
}

/// Looks at the picture plane so that the view fills the viewport.
void aim(vtkRenderer& renderer, FieldData const& data) {
  auto const& view = data.view;
  Point const middle{(view.x[0] + view.x[1]) / 2, (view.y[0] + view.y[1]) / 2};
  double const size = std::max(view.width(), view.height());
  auto* camera = renderer.GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(data.frame.in_space(middle, view.depth[1]).data());
  camera->SetPosition(data.frame.in_space(middle, view.depth[1] + size).data());
  camera->SetViewUp(data.frame.up.data());
  camera->SetParallelScale(view.height() / 2);
  camera->SetClippingRange(0.5 * size, 1.5 * size + view.depth[1] - view.depth[0]);
}

/// The mesh alone, at `scale` pixels for one of 300 dots per inch.
Picture shoot_mesh(FieldLayout const& layout, FieldData const& data, double scale) {
  auto const pixels = [scale](double length) { return static_cast<int>(std::lround(scale * length)); };
  auto const window = make_window(pixels(layout.mesh.width), pixels(layout.mesh.height));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  double const lift = 1e-3 * data.view.width();
  add_surface(*renderer, data, layout);
  if (layout.spec.mesh)
    add_lines(*renderer, data.edges, scale * points(mesh_width), data.frame.in_space({0, 0}, lift),
              make_contrast(layout.scale));
  add_outline(*renderer, data, layout, data.frame.in_space({0, 0}, 2 * lift), scale);
  add_obstacles(*renderer, data.obstacles, lift, scale);
  if (data.sphere)
    add_sphere(*renderer, layout.spec, *data.sphere, 3 * lift, scale);
  aim(*renderer, data);
  return shoot(*window);
}

/// In the lower left corner of the mesh's box, under it.
void draw_axes(Canvas& canvas, FieldLayout const& layout) {
  if (!layout.spec.view)
    return;
  auto const box = triad_box(layout.frame);
  draw_triad(canvas, layout.frame,
             {points(edge) - box.left, layout.mesh.bottom - points(2) - box.height - box.bottom});
}

void draw_words(Canvas& canvas, FieldLayout const& layout) {
  draw_colour_bar(canvas, layout);
  draw_scale_bar(canvas, layout);
  draw_axes(canvas, layout);
  if (!layout.spec.window.empty()) // a frame says that more lies outside
    canvas.frame(layout.mesh, {});
  draw_heading(canvas, heading(layout.figure), layout.picture, layout.when);
}

} // namespace

std::pair<double, double> colour_range(double low, double high) {
  if (high - low > 1e-9 * std::max(std::abs(low), std::abs(high)))
    return {low, high};
  return {std::min(0.0, low), high > 0 ? high : low < 0 ? 0.0 : 1.0};
}

Drawing draw_field(FigureSpec const& figure, FieldSpec const& field) {
  auto const data = load_field(field);
  auto const layout = std::make_shared<FieldLayout const>(lay_out(figure, field, data));
  auto const mesh = shoot_mesh(*layout, data, static_cast<double>(figure.dpi) / dots_per_inch);
  return {layout->picture,
          [layout, mesh](Canvas& canvas) {
            canvas.image(mesh, layout->mesh);
            draw_words(canvas, *layout);
          },
          {}};
}

} // namespace stiction::postproc
