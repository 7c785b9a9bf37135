// Drawing in pixels: text, lines with dashes and round joins, boxes, discs.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <vtkContext2D.h>
#include <vtkRenderer.h>

#include "page/picture.hpp"
#include "page/style.hpp"

namespace stiction::postproc {

/// Pixels from the lower left corner of the picture.
struct Point {
  double x = 0, y = 0;
};

struct Size {
  double width = 0, height = 0;
};

struct Box {
  double left = 0, bottom = 0, width = 0, height = 0;
  [[nodiscard]] double right() const { return left + width; }
  [[nodiscard]] double top() const { return bottom + height; }
  [[nodiscard]] bool contains(Point p) const {
    return p.x >= left && p.x <= right() && p.y >= bottom && p.y <= top();
  }
};

enum class Dash { solid, dash, dot, dash_dot, points };

/// How a line is drawn; `width` in pixels.
struct Pen {
  Colour colour = ink;
  double width = points(frame_width);
  Dash dash = Dash::solid;
};

enum class Marker { disc, down };

enum class Across { left, centre, right };
enum class Along { bottom, centre, top };

/// How a text is drawn: height in points, which of its points is placed, turned by 90 degrees or not.
struct Lettering {
  double size = tick_size;
  Across across = Across::left;
  Along along = Along::bottom;
  bool upright = false;
  Colour colour = ink;
};

/// Extent in pixels of a text `size` points high; needs no window.
[[nodiscard]] Size measure(std::string const& text, double size);

/// `size` or, when the text would be wider than `width` pixels, a smaller one that fits.
[[nodiscard]] double fitting_size(std::string const& text, double size, double width);

/// Coordinates and lengths are pixels at 300 dots per inch, from `origin` on; `scale` of the device's pixels
/// are one of them.
class Canvas {
public:
  explicit Canvas(vtkContext2D& context, double scale = 1, Point origin = {})
      : context_(&context), scale_(scale), origin_(origin) {}

  /// The same paper with its origin moved.
  [[nodiscard]] Canvas from(Point origin) const {
    return Canvas(*context_, scale_, {origin_.x + origin.x, origin_.y + origin.y});
  }

  void text(std::string const& text, Point at, Lettering const& lettering);
  void fill(Box const& box, Colour colour);
  void fill(std::vector<Point> const& convex, Colour colour);
  void frame(Box const& box, Pen const& pen);
  /// A polyline with round joins; `Dash::points` draws none.
  void stroke(std::vector<Point> const& line, Pen const& pen);
  /// A disc, or a triangle that points down, in the colour of the pen and by its width.
  void marker(Point at, Pen const& pen, Marker marker);
  void image(Picture const& picture, Box const& box);

private:
  [[nodiscard]] Point device(Point p) const {
    return {scale_ * (origin_.x + p.x), scale_ * (origin_.y + p.y)};
  }
  void disc(Point centre, double radius, Colour colour);
  void ribbon(std::vector<Point> const& line, Pen const& pen);
  void brush(Colour colour);

  vtkContext2D* context_;
  double scale_;
  Point origin_;
};

/// Lets `paint` draw over `renderer` whenever it renders, at `scale` device pixels for one of 300 dots per
/// inch.
void paint_over(vtkRenderer& renderer, std::function<void(Canvas&)> paint, double scale);

} // namespace stiction::postproc
