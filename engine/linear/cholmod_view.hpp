// A Pattern as CHOLMOD sees it, without a copy.
#pragma once
#include <cholmod.h>

#include "linear/pattern.hpp"

namespace stiction::linear {

/// Lower triangle, pattern only; `pattern` must outlive the view.
[[nodiscard]] inline cholmod_sparse view_of(Pattern& pattern) {
  cholmod_sparse view{};
  view.nrow = view.ncol = static_cast<std::size_t>(pattern.size());
  view.nzmax = pattern.rows.size();
  view.p = pattern.columns.data();
  view.i = pattern.rows.data();
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_PATTERN;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

} // namespace stiction::linear
