// A uniform spatial hash of boxes: what lies near a point, without looking at the rest.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/surface/foot.hpp"
#include "core/error.hpp"

namespace stiction::contact {

/// An axis-parallel box, m.
template<int D> struct Box {
  Vec<D> low, high;
  [[nodiscard]] bool within(Vec<D> const& point, double radius) const {
    return (point.cwiseMax(low).cwiseMin(high) - point).squaredNorm() <= radius * radius;
  }
};

/// Boxes by the cells of a grid that they touch; cells are hashed, so empty space costs nothing.
template<int D> class Grid {
public:
  /// Takes O(boxes) and, from the second time on, memory only where there is more than before.
  void build(std::vector<Box<D>> const& boxes) {
    boxes_ = boxes;
    all_ = boxes.empty() ? Box<D>{} : boxes.front();
    for (auto const& box : boxes_)
      all_ = {all_.low.cwiseMin(box.low), all_.high.cwiseMax(box.high)};
    choose_cell();
    std::size_t table = 16;
    while (table < entry_count_)
      table *= 2;
    starts_.assign(table + 1, 0);
    for (auto const& box : boxes_)
      each_cell(cell(box.low), cell(box.high), [&](Cell const& at) { ++starts_[bucket(at) + 1]; });
    for (std::size_t b = 0; b < table; ++b)
      starts_[b + 1] += starts_[b];
    next_.assign(starts_.begin(), starts_.end() - 1);
    entries_.resize(entry_count_);
    for (int i = 0; i < static_cast<int>(boxes_.size()); ++i)
      each_cell(cell(boxes_[ix(i)].low), cell(boxes_[ix(i)].high), [&](Cell const& at) {
        entries_[next_[bucket(at)]++] = {at, i};
      });
  }

  /// Calls visit(box number) once for every box within `radius` of `point`.
  template<class Visit> void near(Vec<D> const& point, double radius, Visit const& visit) const {
    if (boxes_.empty() || !all_.within(point, radius))
      return;
    Vec<D> const reach = Vec<D>::Constant(radius);
    if (cells_between(point - reach, point + reach) > static_cast<double>(entry_count_)) {
      for (int i = 0; i < static_cast<int>(boxes_.size()); ++i)
        if (boxes_[ix(i)].within(point, radius))
          visit(i);
      return;
    }
    Cell const low = cell(point - reach), high = cell(point + reach);
    each_cell(low, high, [&](Cell const& at) { visit_cell(at, low, point, radius, visit); });
  }
  /// Side of a cell, m.
  [[nodiscard]] double cell_size() const { return cell_size_; }

private:
  using Cell = std::array<std::int64_t, D>;
  [[nodiscard]] static bool same(Cell const& a, Cell const& b) { // == calls memcmp
    bool all = true;
    for (std::size_t d = 0; d < D; ++d)
      all = all && a[d] == b[d];
    return all;
  }
  struct Entry {
    Cell cell;
    int item;
  };

  [[nodiscard]] Cell cell(Vec<D> const& x) const {
    Cell at;
    for (int d = 0; d < D; ++d)
      at[ix(d)] = static_cast<std::int64_t>(std::floor(x[d] / cell_size_));
    return at;
  }
  [[nodiscard]] double cells_between(Vec<D> const& low, Vec<D> const& high) const {
    double count = 1;
    for (int d = 0; d < D; ++d)
      count *= std::floor(high[d] / cell_size_) - std::floor(low[d] / cell_size_) + 1;
    return count;
  }
  [[nodiscard]] std::size_t bucket(Cell const& at) const {
    std::uint64_t hash = 0;
    for (auto const c : at)
      hash = (hash ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(hash >> 20U) & (starts_.size() - 2);
  }
  /// A cell is as large as a box on average; larger if a few great boxes would fill too many.
  void choose_cell() {
    double sum = 0;
    for (auto const& box : boxes_)
      sum += (box.high - box.low).maxCoeff();
    cell_size_ = sum > 0 ? sum / static_cast<double>(boxes_.size()) : 1;
    double const most = 16 * static_cast<double>(boxes_.size());
    double count = count_entries();
    while (count > most) {
      cell_size_ *= 2;
      count = count_entries();
    }
    core::expect(std::isfinite(count), "the boxes of a grid are finite");
    entry_count_ = static_cast<std::size_t>(count);
  }
  [[nodiscard]] double count_entries() const {
    double count = 0;
    for (auto const& box : boxes_)
      count += cells_between(box.low, box.high);
    return std::isfinite(count) ? count : std::nan("");
  }
  template<class Do> static void each_cell(Cell const& low, Cell const& high, Do const& act) {
    Cell at = low;
    while (at[D - 1] <= high[D - 1]) {
      act(at);
      int d = 0;
      while (++at[ix(d)] > high[ix(d)] && d < D - 1) {
        at[ix(d)] = low[ix(d)];
        ++d;
      }
    }
  }
  /// A box that touches several cells of the query is visited in the first of them only.
  template<class Visit>
  void visit_cell(Cell const& at, Cell const& low, Vec<D> const& point, double radius,
                  Visit const& visit) const {
    std::size_t const b = bucket(at);
    for (std::size_t e = starts_[b]; e < starts_[b + 1]; ++e) {
      auto const& entry = entries_[e];
      if (!same(entry.cell, at) || !boxes_[ix(entry.item)].within(point, radius))
        continue;
      Cell first = cell(boxes_[ix(entry.item)].low);
      for (std::size_t d = 0; d < D; ++d)
        first[d] = std::max(first[d], low[d]);
      if (same(first, at))
        visit(entry.item);
    }
  }

  std::vector<Box<D>> boxes_;
  Box<D> all_; ///< around them
  std::vector<Entry> entries_;
  std::vector<std::size_t> starts_, next_;
  std::size_t entry_count_ = 0;
  double cell_size_ = 1;
};

} // namespace stiction::contact
