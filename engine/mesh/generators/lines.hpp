// Grid lines: positions along a length whose distances follow a rule.
#pragma once
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "core/types.hpp"

namespace stiction::mesh {

using Lines = std::vector<double>; ///< ascending positions, both ends included, m

/// Coordinates of n + 1 grid lines whose cell sizes form a geometric series; both ends are met exactly.
[[nodiscard]] Lines grid_lines(double start, double length, Index n, double ratio);

/// Fine cells of one size, growing by a factor from cell to cell to a coarse size.
struct Grading {
  double fine_size;   ///< m
  double coarse_size; ///< m
  double growth;      ///< size of a cell over that of the one before
};

/// Lines from 0 to `length`: cells of the fine size, or slightly smaller, up to `fine`, growing from there
/// on. No cell is larger than the coarse size.
[[nodiscard]] Lines graded_lines(double length, double fine, Grading const& grading);

/// What a generator with a fine zone was given: its name, the zone and the extents it lies in, m.
struct FineZone {
  std::string name;
  core::Numbers const& fine;
  core::Numbers extents;
};
/// Complains about sizes and zones that make no mesh, or one of more than 2000 cells along the fine zone or,
/// at the coarse size, along an extent.
void check_grading(core::Complaints& complaints, FineZone const& zone, Grading const& grading);

/// Throws InputError when a generator would make more than `most` cells.
void check_cell_count(std::string const& name, double count, double most);

} // namespace stiction::mesh
