// Lines as strips of quads (hardware lines have neither joins nor dashes), text through FreeType.
#include "page/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <vtkAbstractContextItem.h>
#include <vtkBrush.h>
#include <vtkContextActor.h>
#include <vtkContextDevice2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include "core/error.hpp"

namespace stiction::postproc {

namespace {

void set_font(vtkTextProperty& property, double size, double scale = 1) {
  property.SetFontFamily(VTK_FONT_FILE); // the built-in font lacks Greek
  property.SetFontFile(STICTION_FONT);
  property.SetFontSize(static_cast<int>(std::lround(scale * points(size))));
}

Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y};
}
Point operator*(double s, Point a) {
  return {s * a.x, s * a.y};
}
double length(Point a) {
  return std::hypot(a.x, a.y);
}
Point turned(Point a, double angle) {
  double const c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Without points closer than `least` to the one before; the last point is kept.
std::vector<Point> thinned(std::vector<Point> const& line, double least) {
  std::vector<Point> result;
  for (auto const& point : line)
    if (result.empty() || length(point - result.back()) >= least)
      result.push_back(point);
  if (result.size() > 1)
    result.back() = line.back();
  return result;
}

/// Lengths drawn and skipped in turn, in line widths; empty for a solid line.
std::vector<double> pattern(Dash dash) {
  switch (dash) {
  case Dash::dash:
    return {4, 2.2};
  case Dash::dot:
    return {1.1, 1.5};
  case Dash::dash_dot:
    return {4, 1.6, 1.1, 1.6};
  case Dash::solid:
  case Dash::points:
    break;
  }
  return {};
}

/// Cuts a line into the pieces that a dash pattern (in pixels) leaves visible.
std::vector<std::vector<Point>> dashes(std::vector<Point> const& line, std::vector<double> const& lengths) {
  std::vector<std::vector<Point>> pieces{{line.front()}};
  std::size_t phase = 0;
  double left = lengths[0];
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point from = line[i - 1];
    double rest = length(line[i] - from);
    while (rest > left) {
      from = from + (left / rest) * (line[i] - from);
      if (phase % 2 == 0)
        pieces.back().push_back(from);
      else
        pieces.push_back({from});
      left = lengths[++phase % lengths.size()];
      rest = length(line[i] - from);
    }
    left -= rest;
    if (phase % 2 == 0)
      pieces.back().push_back(line[i]);
  }
  return pieces;
}

class Painter : public vtkAbstractContextItem {
public:
  static Painter* New() {
    auto* painter = new Painter;
    painter->InitializeObjectBase();
    return painter;
  }
  vtkTypeMacro(Painter, vtkAbstractContextItem) bool Paint(vtkContext2D* context) override {
    Canvas canvas(*context, scale);
    paint(canvas);
    return true;
  }
  std::function<void(Canvas&)> paint;
  double scale = 1;
};

} // namespace

double fitting_size(std::string const& text, double size, double width) {
  double const needed = measure(text, size).width;
  if (needed <= width)
    return size;
  double const pixels =
      std::floor(points(size) * width / needed); // letters have whole ones: rounded up, they overflow
  return std::max(4.0, pixels / points(1));
}

Size measure(std::string const& text, double size) {
  vtkNew<vtkTextProperty> property;
  set_font(*property, size);
  int box[4] = {0, 0, 0, 0};
  if (text.empty())
    return {};
  bool const measured =
      vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(text), box, text_dpi);
  if (!measured)
    throw core::RunError("the font " STICTION_FONT " cannot be used; install fonts-dejavu-core");
  return {static_cast<double>(box[1] - box[0] + 1), static_cast<double>(box[3] - box[2] + 1)};
}

void Canvas::brush(Colour colour) {
  context_->GetPen()->SetLineType(vtkPen::NO_PEN);
  context_->GetBrush()->SetColor(colour.red, colour.green, colour.blue, 255);
}

void Canvas::text(std::string const& text, Point at, Lettering const& lettering) {
  if (text.empty())
    return;
  vtkNew<vtkTextProperty> property;
  set_font(*property, lettering.size, scale_);
  property->SetOrientation(lettering.upright ? 90 : 0);
  property->SetJustification(static_cast<int>(lettering.across)); // VTK counts left, centre, right alike
  property->SetVerticalJustification(static_cast<int>(lettering.along));
  auto const& colour = lettering.colour;
  property->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  context_->ApplyTextProp(property);
  if (lettering.along == Along::centre) // by the capitals, not by the box that has room for descenders
    at.y -= 0.1 * points(lettering.size);
  auto const pixel = device(at);
  context_->DrawString(static_cast<float>(std::round(pixel.x)), static_cast<float>(std::round(pixel.y)),
                       vtkStdString(text));
}

void Canvas::fill(Box const& box, Colour colour) {
  fill({{box.left, box.bottom}, {box.right(), box.bottom}, {box.right(), box.top()}, {box.left, box.top()}},
       colour);
}

void Canvas::fill(std::vector<Point> const& convex, Colour colour) {
  std::vector<float> flat;
  for (auto const& point : convex) {
    auto const pixel = device(point);
    flat.push_back(static_cast<float>(pixel.x));
    flat.push_back(static_cast<float>(pixel.y));
  }
  brush(colour);
  context_->GetDevice()->DrawPolygon(flat.data(),
                                     static_cast<int>(convex.size())); // the context would draw its rim too
}

void Canvas::frame(Box const& box, Pen const& pen) {
  double const half = pen.width / 2;
  stroke({{box.left - half, box.bottom}, {box.right() + half, box.bottom}}, pen);
  stroke({{box.left - half, box.top()}, {box.right() + half, box.top()}}, pen);
  stroke({{box.left, box.bottom}, {box.left, box.top()}}, pen);
  stroke({{box.right(), box.bottom}, {box.right(), box.top()}}, pen);
}

void Canvas::disc(Point centre, double radius, Colour colour) {
  constexpr int corners = 24;
  std::vector<Point> rim;
  rim.reserve(corners);
  for (int i = 0; i < corners; ++i)
    rim.push_back(centre + turned({radius, 0}, 2 * std::numbers::pi * i / corners));
  fill(rim, colour);
}

void Canvas::marker(Point at, Pen const& pen, Marker marker) {
  double const size = 1.3 * pen.width;
  if (marker == Marker::disc)
    return disc(at, size, pen.colour);
  double const half = 1.25 * size;
  fill({{at.x - half, at.y + 0.7 * half}, {at.x, at.y - 1.2 * half}, {at.x + half, at.y + 0.7 * half}},
       pen.colour);
}

void Canvas::stroke(std::vector<Point> const& line, Pen const& pen) {
  auto const thin = thinned(line, 0.4);
  auto lengths = pattern(pen.dash);
  if (thin.size() < 2 || pen.dash == Dash::points)
    return;
  if (lengths.empty())
    return ribbon(thin, pen);
  for (auto& part : lengths)
    part *= pen.width;
  for (auto const& piece : dashes(thin, lengths))
    ribbon(piece, pen);
}

void Canvas::ribbon(std::vector<Point> const& line, Pen const& pen) {
  std::vector<float> strip;
  auto rung = [this, &strip](Point at, Point normal) {
    for (Point const& p : {device(at + normal), device(at - normal)}) {
      strip.push_back(static_cast<float>(p.x));
      strip.push_back(static_cast<float>(p.y));
    }
  };
  Point previous;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point const step = line[i] - line[i - 1];
    if (length(step) < 1e-9)
      continue;
    Point const normal = (pen.width / 2 / length(step)) * Point{-step.y, step.x};
    if (!strip.empty()) { // turn around the corner in small steps: a round join
      double const cross = previous.x * normal.y - previous.y * normal.x;
      double const turn = std::atan2(cross, previous.x * normal.x + previous.y * normal.y);
      int const parts = static_cast<int>(std::abs(turn) / 0.3);
      for (int k = 1; k <= parts; ++k)
        rung(line[i - 1], turned(previous, turn * k / (parts + 1)));
    }
    rung(line[i - 1], normal);
    rung(line[i], normal);
    previous = normal;
  }
  if (strip.empty())
    return;
  brush(pen.colour);
  context_->DrawQuadStrip(strip.data(), static_cast<int>(strip.size() / 2));
}

void Canvas::image(Picture const& picture, Box const& box) {
  auto const at = device({box.left, box.bottom});
  context_->DrawImage(vtkRectf(static_cast<float>(at.x), static_cast<float>(at.y),
                               static_cast<float>(scale_ * box.width),
                               static_cast<float>(scale_ * box.height)),
                      picture);
}

void paint_over(vtkRenderer& renderer, std::function<void(Canvas&)> paint, double scale) {
  auto painter = vtkSmartPointer<Painter>::New();
  painter->scale = scale;
  painter->paint = std::move(paint);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(painter);
  renderer.AddActor(actor);
}

} // namespace stiction::postproc
