// From one figure of a spec to its drawing.
#pragma once
#include "page/drawing.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// Throws core::InputError for what the spec asks wrongly, core::RunError for what the files cannot give.
[[nodiscard]] Drawing draw(FigureSpec const& figure);

} // namespace stiction::postproc
