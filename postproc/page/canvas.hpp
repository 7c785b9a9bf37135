// Drawing in pixels: text, lines with dashes and round joins, boxes, discs.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include <vtkContext2D.h>
#include <vtkRenderer.h>

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

class Canvas {
public:
  explicit Canvas(vtkContext2D& context) : context_(&context) {}

  void text(std::string const& text, Point at, Lettering const& lettering);
  void fill(Box const& box, Colour colour);
  void fill(std::vector<Point> const& convex, Colour colour);
  void frame(Box const& box, Pen const& pen);
  /// A polyline with round joins; `Dash::points` draws discs at its points instead.
  void stroke(std::vector<Point> const& line, Pen const& pen);
  void disc(Point centre, double radius, Colour colour);
  /// Nothing outside `box` is drawn until `unclip`.
  void clip(Box const& box);
  void unclip();

private:
  void ribbon(std::vector<Point> const& line, Pen const& pen);
  void brush(Colour colour);

  vtkContext2D* context_;
};

/// Lets `paint` draw over `renderer` whenever it renders.
void paint_over(vtkRenderer& renderer, std::function<void(Canvas&)> paint);

} // namespace stiction::postproc
