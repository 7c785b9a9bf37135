// The layout of a line figure: scales, ticks, where everything goes; settled before anything is drawn.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "charts/axis.hpp"
#include "charts/legend.hpp"
#include "spec/series.hpp"

namespace stiction::postproc {

/// A vertical line with the place of its label, in pixels.
struct PlacedMark {
  double x = 0, label_left = 0;
  double row = 0; ///< of its label: 0 next to the plot, 1 above, ...
  std::string label;
};

struct Chart {
  FigureSpec const& figure;
  LinesSpec const& spec;
  std::vector<Curve> curves;
  Legend inside, below; ///< the legend in one column, or as wide as the picture
  Scale x, y;
  Ticks x_ticks, y_ticks;
  Size picture;
  Box plot;
  std::vector<PlacedMark> marks;
  double mark_rows = 0;
  std::optional<Box> legend_box; ///< within the plot; nothing: below, or no legend

  [[nodiscard]] bool legend_below() const { return !legend_box && spec.legend != "none"; }
  [[nodiscard]] std::vector<Point> pixels(std::vector<Point> const& points) const;
};

/// Loads and lays out. Throws what load_curve throws; core::RunError when no point lies within the ranges;
/// core::InputError for a mark outside the x axis or a height too small.
[[nodiscard]] Chart make_chart(FigureSpec const& figure, LinesSpec const& spec);

} // namespace stiction::postproc
