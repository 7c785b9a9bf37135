// Simple solids meshed with tetrahedra by gmsh, as a declaration that a script can write.
#pragma once
#include "core/schema.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

enum class SolidShape : std::uint8_t { box, cylinder, ball, half_ball };

/// A solid below `at`, the middle of its top: a box, a cylinder along z, a half ball hanging from its flat
/// side; a ball about `at`. Sets (boundaries): of a box "left", "right", "front", "back", "bottom", "top", of
/// a cylinder "side", "bottom", "top", of balls "cap", "flat"; "symmetry_x" and "symmetry_y" where a quarter
/// is cut (instead of left and front); "all" (nodes).
struct GmshSolid {
  SolidShape shape = SolidShape::box;
  core::Numbers extent;      ///< of the whole: box {x, y, z}, cylinder {radius, height}, balls {radius}, m
  core::Numbers at{0, 0, 0}; ///< m
  bool quarter = false;      ///< only x, y >= at
  double size = 0;           ///< of cells, m
  double fine_size = 0;      ///< of cells near a point, m; 0 for one size everywhere
  core::Numbers near{};      ///< that point {x, y, z}, m; `at` when empty, the pole of a half ball
  double within = 0;         ///< distance up to which fine_size holds, m
  double until = 0;          ///< distance at which `size` is reached, m
  CellKind kind = CellKind::tet4;
  static core::Schema const& schema();
};

/// Throws InputError when a list or number is out of range, the cells would be more than 5 million, or with
/// gmsh's words.
[[nodiscard]] Mesh gmsh_solid(GmshSolid const& solid);

} // namespace stiction::mesh
