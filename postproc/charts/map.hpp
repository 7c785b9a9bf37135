// A table of outcomes as a map: rows and columns of coloured cells, each with its letter.
#pragma once
#include "page/drawing.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

[[nodiscard]] Drawing draw_map(FigureSpec const& figure, MapSpec const& map);

} // namespace stiction::postproc
