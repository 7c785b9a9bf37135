// Meshes of simple shapes from a handful of numbers.
#pragma once
#include "core/schema.hpp"
#include "mesh/topology/mesh.hpp"

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

/// A rectangle with fine cells at the top left: of one size for x <= fine[0] from the left and down to
/// fine[1] below the top, growing beyond. Sets as of a block.
struct GradedBlockOptions {
  core::Numbers origin{0, 0}; ///< lower left corner {x, y}, m
  core::Numbers size;         ///< {width, height}, m
  core::Numbers fine;         ///< fine zone {width from the left, depth from the top}, m
  double fine_size = 0;       ///< of cells, m
  double coarse_size = 0;     ///< of cells far away at most, m
  double growth = 1.25;       ///< size of a cell over that of the one before
  CellKind kind = CellKind::quad4;
  static core::Schema const& schema();
};

/// The part x >= centre of a half disc hanging from its flat side: the section of a half ball, its pole on
/// the axis. Sets: "flat", "arc", "axis" (boundaries), "all" (nodes).
struct QuarterDiscOptions {
  core::Numbers centre{0, 0}; ///< middle of the full disc {x, y}, m
  double radius = 0;          ///< m
  core::Numbers fine;         ///< fine zone {length along the arc from the pole, depth}, m
  double fine_size = 0;       ///< of cells, m
  double coarse_size = 0;     ///< of cells far away at most, m
  double growth = 1.25;
  bool standing = false; ///< flat side down, pole on top
  CellKind kind = CellKind::quad4;
  static core::Schema const& schema();
};

/// A box of nx x ny x nz cells. Sets: "left", "right" (x), "front", "back" (y), "bottom", "top" (z)
/// (boundaries), "all" (nodes).
struct BoxOptions {
  core::Numbers origin{0, 0, 0};  ///< corner of least coordinates {x, y, z}, m
  core::Numbers size;             ///< {x, y, z}, m
  core::Numbers cells;            ///< {nx, ny, nz}, whole numbers
  core::Numbers grading{1, 1, 1}; ///< size of the last cell over that of the first
  CellKind kind = CellKind::hex8;
  static core::Schema const& schema();
};

/// The quarter x, y >= centre of a cylinder about an axis along z, fine near the middle of its top. Sets:
/// "top", "bottom", "side", "symmetry_x" (plane x = centre), "symmetry_y" (boundaries), "all" (nodes).
struct QuarterCylinderOptions {
  core::Numbers centre{0, 0, 0}; ///< middle of the top {x, y, z}, m
  double radius = 0, height = 0; ///< m
  core::Numbers fine;            ///< fine zone {radius, depth from the top}, m
  double fine_size = 0;          ///< of cells, m
  double coarse_size = 0;        ///< of cells far away at most along radius and depth, m
  double growth = 1.25;
  CellKind kind = CellKind::hex8;
  static core::Schema const& schema();
};

/// How much of a body of revolution: x, y >= centre; y >= centre; all.
enum class Part : std::uint8_t { quarter, half, full };

/// A half ball hanging from its flat side, fine near its pole. Sets: "flat", "cap", and where it is cut
/// "symmetry_x" (plane x = centre), "symmetry_y" (boundaries), "all" (nodes).
struct HalfBallOptions {
  core::Numbers centre{0, 0, 0}; ///< of the ball {x, y, z}, m
  double radius = 0;             ///< m
  core::Numbers fine;            ///< fine zone {length along the cap from the pole, depth}, m
  double fine_size = 0;          ///< of cells, m
  double coarse_size = 0;        ///< of cells far away at most, m
  double growth = 1.25;
  Part part = Part::quarter;
  bool standing = false; ///< flat side down, pole on top
  CellKind kind = CellKind::hex8;
  static core::Schema const& schema();
};

/// Throws InputError when a list has the wrong length or a number is out of range.
[[nodiscard]] Mesh block(BlockOptions const& options);

/// A node lies at the crown (centre x, centre y + radius); arc nodes, mid-side nodes too, lie on the circle.
/// Throws InputError when a number is out of range or the mesh would have more than 4 million cells.
[[nodiscard]] Mesh half_disc(HalfDiscOptions const& options);

/// These throw InputError when a number is out of range or the mesh would have more than 4 million cells (2D)
/// or 2 million (3D). Nodes of arc, side and cap, mid-side nodes too, lie on the circle or ball; cells of the
/// round ones are narrower than asked inside, where their lines draw together.
[[nodiscard]] Mesh graded_block(GradedBlockOptions const& options);
[[nodiscard]] Mesh quarter_disc(QuarterDiscOptions const& options);
[[nodiscard]] Mesh box(BoxOptions const& options);
[[nodiscard]] Mesh quarter_cylinder(QuarterCylinderOptions const& options);
[[nodiscard]] Mesh half_ball(HalfBallOptions const& options);

} // namespace stiction::mesh
