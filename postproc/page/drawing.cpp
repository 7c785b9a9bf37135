// Pixels part by part, so that no window is larger than one of them; SVG as one page, by VTK's exporter.
#include "page/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <vtkNew.h>
#include <vtkSVGExporter.h>

#include "core/error.hpp"
#include "page/window.hpp"

namespace stiction::postproc {

namespace {

int pixels(double length, double scale) {
  return static_cast<int>(std::lround(scale * length));
}

std::string content(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// VTK gives the size in pixels, which viewers take as 1/96 of an inch each.
std::string with_print_size(std::string text, Size size) {
  auto const start = text.find("<svg"), stop = text.find('>', start);
  if (start == std::string::npos || stop == std::string::npos)
    throw core::RunError("VTK's SVG has no head");
  std::string const head = fmt::format(
      R"(<svg version="1.1" xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )"
      R"(width="{:.2f}mm" height="{:.2f}mm" viewBox="0 0 {:g} {:g}")",
      size.width / millimetres(1), size.height / millimetres(1), size.width, size.height);
  return text.replace(start, stop - start, head);
}

/// VTK names the background by its place in memory, which differs from run to run.
std::string with_steady_name(std::string text) {
  auto const start = text.find("bgGrad_");
  auto const name = text.substr(start, text.find_first_of("\")", start) - start);
  for (auto at = start; at != std::string::npos; at = text.find(name, at))
    text.replace(at, name.size(), "paper");
  return text;
}

} // namespace

void paint(Drawing const& drawing, Canvas const& canvas) {
  auto own = canvas;
  if (drawing.paint)
    drawing.paint(own);
  for (auto const& part : drawing.parts)
    paint(part.drawing, canvas.from(part.at));
}

Drawing tile(std::vector<Drawing> drawings, int columns, double gap) {
  auto const wide = static_cast<std::size_t>(columns);
  Drawing result;
  double const width = drawings.front().size.width;
  result.size.width = (width + gap) * static_cast<double>(std::min(wide, drawings.size())) - gap;
  double depth = 0; // of the row's lower edge below the top
  std::vector<double> depths;
  for (std::size_t first = 0; first < drawings.size(); first += wide) {
    double height = 0;
    for (std::size_t i = first; i < std::min(first + wide, drawings.size()); ++i)
      height = std::max(height, drawings[i].size.height);
    depths.push_back(first == 0 ? 0 : depth + gap);
    depth = depths.back() + height;
  }
  result.size.height = depth;
  std::size_t row = 0, column = 0;
  for (auto& drawing : drawings) {
    Point const at{static_cast<double>(column) * (width + gap), depth - depths[row] - drawing.size.height};
    result.parts.push_back({at, std::move(drawing)});
    if (++column == wide) {
      column = 0;
      ++row;
    }
  }
  return result;
}

Picture shoot(Drawing const& drawing, int dpi) {
  double const scale = static_cast<double>(dpi) / dots_per_inch;
  int const width = pixels(drawing.size.width, scale), height = pixels(drawing.size.height, scale);
  if (drawing.parts.empty()) {
    auto const window = make_window(width, height);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    window->AddRenderer(renderer);
    paint_over(*renderer, drawing.paint, scale);
    return shoot(*window);
  }
  auto result = blank(width, height);
  for (auto const& [at, part] : drawing.parts) {
    auto const picture = shoot(part, dpi);
    paste(picture, result, std::min(pixels(at.x, scale), width - width_of(picture)),
          std::min(pixels(at.y, scale), height - height_of(picture)));
  }
  return result;
}

void write_svg(Drawing const& drawing, std::filesystem::path const& file) {
  auto const window =
      make_window(static_cast<int>(drawing.size.width), static_cast<int>(drawing.size.height));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->SetBackground2(1, 1, 1);
  renderer->SetBackgroundAlpha(1);
  renderer->GradientBackgroundOn(); // a definition: where there is none, VTK 9.1 leaves out those of pictures
  window->AddRenderer(renderer);
  paint_over(
      *renderer, [&drawing](Canvas& canvas) { paint(drawing, canvas); }, 1);
  window->Render(); // the exporter takes up what a rendering left
  auto const draft = std::filesystem::path(file).concat(".draft");
  vtkNew<vtkSVGExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->SetTitle(file.stem().c_str());
  exporter->SetDescription("");
  exporter->SetFileName(draft.c_str());
  exporter->Write();
  auto const text = content(draft);
  std::error_code ignored;
  std::filesystem::remove(draft, ignored);
  if (text.find("</svg>") == std::string::npos || text.find("bgGrad_") == std::string::npos)
    throw core::RunError(
        fmt::format("cannot write {}: is the folder writable and the disk not full?", file.string()));
  write_whole(with_print_size(with_steady_name(text), drawing.size), file);
}

} // namespace stiction::postproc
