// The legend: how large it is, where it hides no curve, and drawing it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "spec/series.hpp"

namespace stiction::postproc {

/// Labelled curves in a grid, filled row by row.
class Legend {
public:
  /// One column, for the inside of a plot.
  explicit Legend(std::vector<Curve> const& curves);
  /// As many columns as `width` pixels allow, for below a plot; in smaller letters where one label is longer.
  Legend(std::vector<Curve> const& curves, double width);

  [[nodiscard]] Size size() const; ///< zero when no curve has a label
  void draw(Canvas& canvas, Point lower_left, bool boxed) const;

  /// Where it goes in the corner named "top right", "bottom left", ... of `plot`.
  [[nodiscard]] Box in_corner(std::string const& corner, Box const& plot) const;
  /// The first corner in which it covers none of `lines` (in pixels), if there is one.
  [[nodiscard]] std::optional<Box> free_corner(Box const& plot,
                                               std::vector<std::vector<Point>> const& lines) const;

private:
  std::vector<Curve const*> entries_;
  std::size_t columns_ = 1;
  Size cell_;
};

} // namespace stiction::postproc
