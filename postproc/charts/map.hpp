// A table of outcomes as a map: rows and columns of coloured cells, each with its letter.
#pragma once
#include "page/picture.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

[[nodiscard]] Picture draw_map(FigureSpec const& figure, MapSpec const& map);

} // namespace stiction::postproc
