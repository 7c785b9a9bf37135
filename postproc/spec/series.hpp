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
  std::vector<Point> errors;      ///< half lengths of the bars at the points; empty: none
  std::vector<std::string> names; ///< beside the points; empty: none
  std::vector<bool> at_most;      ///< whether a point stands for what lies there or below; empty: none does
};

/// Reads curve number `index` of a figure. Points that a logarithmic axis cannot show (<= 0) are left out;
/// one that is alone is drawn as a point. Throws core::InputError when the dimension of a dataset is not that
/// of its axis, core::RunError when file or dataset is missing, empty, or holds a number that is not finite.
[[nodiscard]] Curve load_curve(CurveSpec const& spec, std::size_t index, LinesSpec const& figure);

} // namespace stiction::postproc
