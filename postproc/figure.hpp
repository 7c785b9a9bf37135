// From one figure of a spec to its picture.
#pragma once
#include "page/picture.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// Throws core::InputError for what the spec asks wrongly, core::RunError for what the files cannot give.
[[nodiscard]] Picture draw(FigureSpec const& figure);

} // namespace stiction::postproc
