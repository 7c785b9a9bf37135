// Counting cells and finding the boundary of a mesh.
#include "mesh/topology/mesh.hpp"

#include <array>
#include <numeric>
#include <set>

namespace stiction::mesh {

namespace {

constexpr std::size_t most_corners = 4; // of a facet in 3D
using Key = std::array<Index, most_corners>;

/// Sorted corners, the same for both cells that share the facet.
Key key_of(Index const* cell, std::vector<int> const& local, int dim) {
  Key key;
  key.fill(-1);
  std::size_t const corners = dim == 2 ? 2 : local.size() % 3 == 0 ? 3 : 4;
  for (std::size_t k = 0; k < corners; ++k)
    key[k] = cell[local[k]];
  std::sort(key.begin(), key.end());
  return key;
}

/// Calls visit(nodes of a cell, its facet's local nodes, dimension of the cell) in the order of the cells.
template<class Visit> void each_side(Mesh const& mesh, Visit const& visit) {
  for (auto const& block : mesh.blocks) {
    CellInfo const& cell = info(block.kind);
    for (std::size_t first = 0; first < block.nodes.size(); first += static_cast<std::size_t>(cell.nodes))
      for (auto const& local : cell.facets)
        visit(&block.nodes[first], local, cell.dim);
  }
}

/// Which of the sides no other one equals. Those with the same largest node stand side by side.
std::vector<bool> single(std::vector<Key> const& sides, Index nodes) {
  std::size_t const slots = static_cast<std::size_t>(nodes) + 1;
  auto const slot = [&](Key const& key) { // a mesh that has not been checked may name any node
    return static_cast<std::size_t>(key.back()) % slots;
  };
  std::vector<std::size_t> first(slots + 1, 0), place(sides.size());
  for (auto const& key : sides)
    ++first[slot(key) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  auto next = first;
  for (std::size_t i = 0; i < sides.size(); ++i)
    place[next[slot(sides[i])]++] = i;
  std::vector<bool> alone(sides.size(), true);
  for (std::size_t v = 0; v < slots; ++v)
    for (std::size_t i = first[v]; i < first[v + 1]; ++i)
      for (std::size_t k = i + 1; k < first[v + 1]; ++k)
        if (sides[place[i]] == sides[place[k]])
          alone[place[i]] = alone[place[k]] = false;
  return alone;
}

} // namespace

Index Mesh::cell_count() const {
  Index count = 0;
  for (auto const& block : blocks)
    count += static_cast<Index>(block.nodes.size()) / info(block.kind).nodes;
  return count;
}

Set join(std::vector<Set const*> const& sets) {
  auto const once = [](Indices& all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  };
  Set joined;
  std::set<Indices> seen;
  bool bare = false;
  for (auto const* set : sets) {
    joined.nodes.insert(joined.nodes.end(), set->nodes.begin(), set->nodes.end());
    joined.cells.insert(joined.cells.end(), set->cells.begin(), set->cells.end());
    bare = bare || set->facets.empty();
    for (auto const& facet : set->facets)
      if (seen.insert(facet.nodes).second)
        joined.facets.push_back(facet);
  }
  once(joined.nodes);
  once(joined.cells);
  if (bare)
    joined.facets.clear();
  return joined;
}

std::vector<Facet> boundary(Mesh const& mesh) {
  std::vector<Key> sides;
  each_side(mesh, [&](Index const* cell, auto const& local, int dim) {
    sides.push_back(key_of(cell, local, dim));
  });
  auto const alone = single(sides, mesh.node_count());
  std::vector<Facet> facets;
  std::size_t at = 0;
  each_side(mesh, [&](Index const* cell, auto const& local, int) {
    if (!alone[at++])
      return;
    auto& nodes = facets.emplace_back().nodes;
    for (int const node : local)
      nodes.push_back(cell[node]);
  });
  return facets;
}

} // namespace stiction::mesh
