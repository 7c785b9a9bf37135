// A bare net of hexahedra, and its conversion into a mesh of any 3D kind.
#pragma once
#include <array>
#include <vector>

#include "mesh/generators/lines.hpp"
#include "mesh/generators/quads.hpp"
#include "mesh/generators/second_order.hpp"

namespace stiction::mesh {

/// Corner nodes (m) and cells in the order of hex8.
struct Hexes {
  std::vector<Position<3>> nodes;
  std::vector<std::array<Index, 8>> cells;

  Index add(Position<3> const& position) {
    nodes.push_back(position);
    return static_cast<Index>(nodes.size()) - 1;
  }
};

/// Every quadrilateral between two neighbouring heights becomes a hexahedron; heights ascend.
[[nodiscard]] Hexes extrude(Quads const& quads, Lines const& heights);

/// The net seen in a mirror at zero of a coordinate.
[[nodiscard]] Hexes reflected(Hexes hexes, int axis);
/// The net and its mirror image at zero of a coordinate, grown together at nodes exactly there.
[[nodiscard]] Hexes doubled(Hexes const& hexes, int axis);

[[nodiscard]] Position<3> straight_middle_3d(Position<3> const& a, Position<3> const& b);

/// Cells of `kind` without sets. Tetrahedra are six a hexahedron: cones from its node of lowest number over
/// the three faces without it, each face cut through its own lowest node, so that neighbours agree (after
/// Dompierre 1999).
[[nodiscard]] Mesh to_mesh(Hexes const& hexes, CellKind kind, Middle<3> const& middle = straight_middle_3d);

} // namespace stiction::mesh
