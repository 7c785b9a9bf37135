// Meshes of simple shapes from a handful of numbers.
#pragma once
#include "core/schema.hpp"
#include "mesh/mesh.hpp"

namespace stiction::mesh {

/// A rectangle of nx x ny cells. Sets: "left", "right", "bottom", "top" (boundaries), "all" (nodes).
struct BlockOptions {
  core::Numbers origin{0, 0};  ///< lower left corner {x, y}, m
  core::Numbers size;          ///< {width, height}, m
  core::Numbers cells;         ///< {nx, ny}, whole numbers
  core::Numbers grading{1, 1}; ///< {x, y}: size of the last cell over that of the first
  CellKind kind = CellKind::quad4;
  static core::Schema const& schema();
};

/// The upper half of a disc, flat side down. Sets: "flat" (y = centre y), "arc" (boundaries), "all" (nodes).
struct HalfDiscOptions {
  core::Numbers centre{0, 0}; ///< middle of the flat side {x, y}, m
  double radius = 0;          ///< m
  double size = 0;            ///< cell size along the arc, m; the arc's cells are this or slightly smaller
  double grading = 1;         ///< interior cells are at most this many times larger than the arc's
  CellKind kind = CellKind::quad4;
  static core::Schema const& schema();
};

/// Throws InputError when a list has the wrong length or a number is out of range.
[[nodiscard]] Mesh block(BlockOptions const& options);

/// A node lies at the crown (centre x, centre y + radius); arc nodes, mid-side nodes too, lie on the circle.
/// Throws InputError when a number is out of range or the mesh would have more than 4 million cells.
[[nodiscard]] Mesh half_disc(HalfDiscOptions const& options);

} // namespace stiction::mesh
