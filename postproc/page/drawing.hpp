// A figure laid out: how large it is and how it is painted, on whatever paper.
#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "page/canvas.hpp"
#include "page/picture.hpp"

namespace stiction::postproc {

/// Lengths in pixels at 300 dots per inch. One that has parts is made of these alone.
struct Drawing {
  struct Part;
  Size size;
  std::function<void(Canvas&)> paint;
  std::vector<Part> parts;
};

struct Drawing::Part {
  Point at; ///< its lower left corner
  Drawing drawing;
};

/// Drawings in rows of `columns`, `gap` apart, tops aligned.
[[nodiscard]] Drawing tile(std::vector<Drawing> drawings, int columns, double gap);

/// Throws what make_window throws.
[[nodiscard]] Picture shoot(Drawing const& drawing, int dpi);

/// Paints a drawing and its parts.
void paint(Drawing const& drawing, Canvas const& canvas);

/// The drawing as a page of PDF in its size in print: lines and areas as paths, letters as text in an
/// embedded font, meshes as pictures. Throws core::RunError when it cannot be made or written.
void write_pdf(Drawing const& drawing, std::filesystem::path const& file);

/// The drawing as lines, areas and letters made of paths, in its size in print; meshes as embedded pictures.
/// Throws what make_window throws, core::RunError when the file cannot be written.
void write_svg(Drawing const& drawing, std::filesystem::path const& file);

} // namespace stiction::postproc
