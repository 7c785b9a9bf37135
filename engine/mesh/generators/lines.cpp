// Geometric series of cell sizes, and the checks of the numbers behind them.
#include "mesh/generators/lines.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

Lines grid_lines(double start, double length, Index n, double ratio) {
  double const q = n > 1 ? std::pow(ratio, 1.0 / (n - 1)) : 1.0;
  double total = 0;
  Lines sums{0};
  for (Index i = 0; i < n; ++i)
    sums.push_back(total += std::pow(q, i));
  for (double& s : sums)
    s = start + length * (s / total);
  sums.back() = start + length;
  return sums;
}

Lines graded_lines(double length, double fine, Grading const& grading) {
  bool const all_fine = fine > length - grading.fine_size / 2;
  double const zone = all_fine ? length : fine;
  auto const count = static_cast<Index>(std::ceil(zone / grading.fine_size - 1e-9));
  Lines lines{0};
  for (Index i = 1; i <= count; ++i)
    lines.push_back(zone * i / count);
  if (all_fine) {
    lines.back() = length;
    return lines;
  }
  double size = count > 0 ? zone / count : grading.fine_size, total = 0;
  Lines sums;
  while (total < (length - zone) * (1 - 1e-9)) {
    size = std::min(size * grading.growth, grading.coarse_size);
    sums.push_back(total += size);
  }
  for (double const sum : sums)
    lines.push_back(zone + (length - zone) * (sum / total));
  lines.back() = length;
  return lines;
}

void check_grading(core::Complaints& complaints, FineZone const& zone, Grading const& grading) {
  constexpr double most_along = 2000, most_ratio = 1e6;
  double const least = *std::min_element(zone.extents.begin(), zone.extents.end());
  double const most = *std::max_element(zone.extents.begin(), zone.extents.end());
  if (!core::positive.contains(least))
    return; // complained about elsewhere
  double const widest = zone.fine.empty() ? most : *std::max_element(zone.fine.begin(), zone.fine.end());
  double const finest = std::max(std::clamp(widest, 0.0, most) / most_along, most / most_ratio);
  double const coarsest = std::max(grading.fine_size, most / most_along);
  check_numbers(complaints, {zone.name + ".fine_size", {grading.fine_size}, "m", {finest, least}, 1});
  check_numbers(complaints, {zone.name + ".coarse_size",
                             {grading.coarse_size},
                             "m",
                             {coarsest, std::numeric_limits<double>::infinity()},
                             1});
  check_numbers(complaints, {zone.name + ".growth", {grading.growth}, "1", {1.05, 2}, 1});
  check_numbers(complaints, {zone.name + ".fine", zone.fine, "m", core::non_negative});
}

void check_cell_count(std::string const& name, double count, double most) {
  if (count > most)
    throw core::InputError(core::Complaints{
        {"", name,
         fmt::format("makes {:.0f} cells; at most {:.0f} are allowed, use larger cells", count, most)}});
}

} // namespace stiction::mesh
