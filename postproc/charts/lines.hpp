// Line figures: curves over one pair of axes.
#pragma once
#include "page/drawing.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// Loads the curves and draws them; throws what load_curve and make_window throw, and core::RunError when no
/// point lies within the ranges asked for.
[[nodiscard]] Drawing draw_lines(FigureSpec const& figure, LinesSpec const& lines);

/// The room around the plot that ticks, titles and legend take. Throws the same.
[[nodiscard]] Margins margins_of(FigureSpec const& figure, LinesSpec const& lines);

} // namespace stiction::postproc
