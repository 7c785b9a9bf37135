// Counting cells and finding the boundary of a mesh.
#include "mesh/topology/mesh.hpp"

#include <array>
#include <numeric>

namespace stiction::mesh {

namespace {

constexpr std::size_t most_corners = 4; // of a facet in 3D
using Key = std::array<Index, most_corners>;

struct Side {
  Key key; ///< sorted corners, the same for both cells that share the facet
  Facet facet;
};

Side make_side(Index const* cell, std::vector<int> const& local, int dim) {
  Side side{{}, {}};
  for (int const node : local)
    side.facet.nodes.push_back(cell[node]);
  std::size_t const corners = dim == 2 ? 2 : local.size() % 3 == 0 ? 3 : 4;
  side.key.fill(-1);
  std::copy_n(side.facet.nodes.begin(), corners, side.key.begin());
  std::sort(side.key.begin(), side.key.end());
  return side;
}

std::vector<Side> sides_of_all_cells(Mesh const& mesh) {
  std::vector<Side> sides;
  for (auto const& block : mesh.blocks) {
    CellInfo const& cell = info(block.kind);
    for (std::size_t first = 0; first < block.nodes.size(); first += static_cast<std::size_t>(cell.nodes))
      for (auto const& local : cell.facets)
        sides.push_back(make_side(&block.nodes[first], local, cell.dim));
  }
  return sides;
}

} // namespace

Index Mesh::cell_count() const {
  Index count = 0;
  for (auto const& block : blocks)
    count += static_cast<Index>(block.nodes.size()) / info(block.kind).nodes;
  return count;
}

std::vector<Facet> boundary(Mesh const& mesh) {
  auto const sides = sides_of_all_cells(mesh);
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sides[a].key != sides[b].key ? sides[a].key < sides[b].key : a < b;
  });
  std::vector<std::size_t> single;
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && sides[order[end]].key == sides[order[i]].key)
      ++end;
    if (end == i + 1)
      single.push_back(order[i]);
    i = end;
  }
  std::sort(single.begin(), single.end()); // back to the order of the cells
  std::vector<Facet> facets;
  facets.reserve(single.size());
  for (std::size_t const i : single)
    facets.push_back(sides[i].facet);
  return facets;
}

} // namespace stiction::mesh
