// Curves as numbers: datasets of HDF5 histories in the units of their axes.
#pragma once
#include <string>
#include <vector>

#include "spec/spec.hpp"

namespace stiction::postproc {

/// A curve ready to draw, in the units of the axes.
struct Curve {
  std::string label;
  Pen pen;
  std::vector<Point> points;
};

/// Reads curve number `index` of a figure. Points that a logarithmic axis cannot show (<= 0) are left out.
/// Throws core::InputError when the dimension of a dataset is not that of its axis, core::RunError when
/// file or dataset is missing, empty, or holds a number that is not finite.
[[nodiscard]] Curve load_curve(CurveSpec const& spec, std::size_t index, LinesSpec const& figure);

} // namespace stiction::postproc
