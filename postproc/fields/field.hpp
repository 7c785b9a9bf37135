// Field figures: a mesh coloured by a quantity, with its colour bar.
#pragma once
#include "page/drawing.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// The colours' range for values in this one: wide enough to be drawn where they hardly differ.
[[nodiscard]] std::pair<double, double> colour_range(double low, double high);

/// Loads one step and draws it; throws what load_field and make_window throw, and core::InputError for a
/// scale bar longer than the view.
[[nodiscard]] Drawing draw_field(FigureSpec const& figure, FieldSpec const& field);

} // namespace stiction::postproc
