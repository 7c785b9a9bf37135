// Groups of columns, made when they are asked for.
#include "linear/surface_columns.hpp"

#include <algorithm>
#include <utility>

namespace stiction::linear {

namespace {
constexpr double hoard = 2; // of what the present question needs: more is dropped
}

void SurfaceColumns::clear() {
  for (auto& group : groups_)
    group.resize(0, 0);
  numbers_ = 0;
}

Indices SurfaceColumns::known() const {
  Indices first;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (groups_[g].size() > 0)
      first.push_back(static_cast<Index>(g) * width_);
  return first;
}

/// A contact that wanders leaves columns behind that nobody asks for any more.
void SurfaceColumns::drop(std::vector<bool> const& wanted) {
  double needed = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    needed += wanted[g] ? static_cast<double>(groups_[g].size()) : 0.0;
  if (numbers_ <= hoard * needed)
    return;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (!wanted[g])
      groups_[g].resize(0, 0);
  numbers_ = needed;
}

Index SurfaceColumns::gather(Indices const& used, Solve const& solve, Dense& C) {
  std::vector<bool> wanted(groups_.size(), false);
  for (Index const u : used)
    wanted[ix(u / width_)] = true;
  Index columns = 0;
  for (Index g = 0; g < static_cast<Index>(groups_.size()); ++g) {
    if (!wanted[ix(g)] || groups_[ix(g)].size() > 0)
      continue;
    Index const first = g * width_, count = std::min(width_, surface_ - first);
    groups_[ix(g)].resize(symmetric_ ? surface_ - first : surface_, count);
    solve(first, groups_[ix(g)]);
    columns += count;
    numbers_ += static_cast<double>(groups_[ix(g)].size());
  }
  if (columns > 0)
    drop(wanted);
  auto const n = static_cast<Index>(used.size());
  C.resize(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      C(i, j) = entry(used[ix(i)], used[ix(j)]);
  return columns;
}

double SurfaceColumns::entry(Index row, Index column) const {
  if (symmetric_ && row < column) // one number for both
    std::swap(row, column);
  Index const first = column / width_ * width_;
  return groups_[ix(column / width_)](symmetric_ ? row - first : row, column - first);
}

} // namespace stiction::linear
