// Extruding, mirroring and splitting hexahedra.
#include "mesh/generators/hexes.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace stiction::mesh {

namespace {

using Hex = std::array<Index, 8>;

/// Six tetrahedra of one hexahedron, appended corner after corner.
void split(Hex const& hex, Indices& corners) {
  Index const tip = *std::min_element(hex.begin(), hex.end());
  for (auto const& face : info(CellKind::hex8).facets) {
    std::array<Index, 4> quad{};
    for (std::size_t i = 0; i < 4; ++i)
      quad[i] = hex[static_cast<std::size_t>(face[i])];
    if (std::find(quad.begin(), quad.end(), tip) != quad.end())
      continue;
    std::rotate(quad.begin(), std::min_element(quad.begin(), quad.end()), quad.end());
    // seen from inside the face runs clockwise; its reverse is the base of a tetrahedron with the tip above
    corners.insert(corners.end(), {quad[0], quad[2], quad[1], tip, quad[0], quad[3], quad[2], tip});
  }
}

Indices corner_cells(Hexes const& hexes, bool tetrahedra) {
  Indices corners;
  for (auto const& hex : hexes.cells)
    if (tetrahedra)
      split(hex, corners);
    else
      corners.insert(corners.end(), hex.begin(), hex.end());
  return corners;
}

} // namespace

Hexes extrude(Quads const& quads, Lines const& heights) {
  Hexes hexes;
  for (double const z : heights)
    for (auto const& [x, y] : quads.nodes)
      hexes.add({x, y, z});
  auto const layer = static_cast<Index>(quads.nodes.size());
  for (Index k = 0; k + 1 < static_cast<Index>(heights.size()); ++k)
    for (auto const& quad : quads.cells) {
      Hex hex{};
      for (std::size_t i = 0; i < 4; ++i) {
        hex[i] = quad[i] + k * layer;
        hex[i + 4] = hex[i] + layer;
      }
      hexes.cells.push_back(hex);
    }
  return hexes;
}

Hexes reflected(Hexes hexes, int axis) {
  for (auto& position : hexes.nodes)
    position[axis] = 0.0 - position[axis]; // no negative zeros
  for (auto& cell : hexes.cells)
    std::rotate(cell.begin(), cell.begin() + 4, cell.end());
  return hexes;
}

Hexes doubled(Hexes const& hexes, int axis) {
  Hexes const image = reflected(hexes, axis);
  Hexes both = hexes;
  Indices renumbered;
  for (std::size_t i = 0; i < image.nodes.size(); ++i)
    renumbered.push_back(image.nodes[i][axis] == 0 ? static_cast<Index>(i) : both.add(image.nodes[i]));
  for (auto cell : image.cells) {
    for (Index& node : cell)
      node = renumbered[ix(node)];
    both.cells.push_back(cell);
  }
  return both;
}

Position<3> straight_middle_3d(Position<3> const& a, Position<3> const& b) {
  return (a + b) / 2;
}

Mesh to_mesh(Hexes const& hexes, CellKind kind, Middle<3> const& middle) {
  core::expect(info(kind).dim == 3, "a kind of solid cells");
  return with_mid_nodes<3>(kind, hexes.nodes, corner_cells(hexes, info(kind).corners == 4), middle);
}

} // namespace stiction::mesh
