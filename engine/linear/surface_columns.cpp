// Groups of columns, made when they are asked for.
#include "linear/surface_columns.hpp"

#include <algorithm>
#include <utility>

#include "core/threads.hpp"

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

Spent SurfaceColumns::gather(Indices const& used, Solve const& solve, Dense& C) {
  std::vector<bool> wanted(groups_.size(), false);
  for (Index const u : used)
    wanted[ix(u / width_)] = true;
  Indices missing;
  for (Index g = 0; g < static_cast<Index>(groups_.size()); ++g)
    if (wanted[ix(g)] && groups_[ix(g)].size() == 0)
      missing.push_back(g);
  std::vector<double> operations(missing.size());
  core::each(static_cast<Index>(missing.size()), [&](Index k) {
    Index const first = missing[ix(k)] * width_;
    auto& group = groups_[ix(missing[ix(k)])];
    group.resize(symmetric_ ? surface_ - first : surface_, std::min(width_, surface_ - first));
    operations[ix(k)] = solve(first, group);
  });
  Spent spent;
  for (std::size_t k = 0; k < missing.size(); ++k) {
    auto const& group = groups_[ix(missing[k])];
    spent.columns += group.cols();
    spent.operations += operations[k];
    numbers_ += static_cast<double>(group.size());
  }
  if (spent.columns > 0)
    drop(wanted);
  auto const n = static_cast<Index>(used.size());
  C.resize(n, n);
  core::each_piece(n, 64, [&](Index from, Index to) {
    for (Index j = from; j < to; ++j)
      for (Index i = 0; i < n; ++i)
        C(i, j) = entry(used[ix(i)], used[ix(j)]);
  });
  return spent;
}

double SurfaceColumns::entry(Index row, Index column) const {
  if (symmetric_ && row < column) // one number for both
    std::swap(row, column);
  Index const first = column / width_ * width_;
  return groups_[ix(column / width_)](symmetric_ ? row - first : row, column - first);
}

} // namespace stiction::linear
