// Slabs by layers of nodes: a cell is in the lowest one that it touches.
#include "solid/slabs.hpp"

#include <limits>
#include <numeric>

#include "linear/layers.hpp"

namespace stiction::solid {

namespace {

constexpr Index many = 2048, least = 512; // cells that are divided; of a slab

/// The cells at each node.
struct CellsAtNodes {
  Indices first; ///< [nodes + 1], into cells
  Indices cells;
};

CellsAtNodes cells_at_nodes(Indices const& connectivity, int nodes) {
  CellsAtNodes at;
  at.first.assign(ix(*std::ranges::max_element(connectivity)) + 2, 0);
  for (Index const node : connectivity)
    ++at.first[ix(node) + 1];
  std::partial_sum(at.first.begin(), at.first.end(), at.first.begin());
  at.cells.resize(connectivity.size());
  auto next = at.first;
  for (std::size_t k = 0; k < connectivity.size(); ++k)
    at.cells[ix(next[ix(connectivity[k])]++)] = static_cast<Index>(k) / nodes;
  return at;
}

} // namespace

Indices slabs(Indices const& connectivity, int nodes) {
  auto const cells = static_cast<Index>(connectivity.size()) / nodes;
  if (cells < many)
    return Indices(ix(cells), 0);
  auto const at = cells_at_nodes(connectivity, nodes);
  auto const near = [&](Index node, auto const& visit) {
    for (Index k = at.first[ix(node)]; k < at.first[ix(node) + 1]; ++k)
      std::for_each_n(&connectivity[ix(at.cells[ix(k)] * nodes)], nodes, visit);
  };
  auto const layer = linear::LayersOfGraph(static_cast<Index>(at.first.size()) - 1, near).find();
  Indices of_cell(ix(cells), std::numeric_limits<Index>::max());
  for (std::size_t k = 0; k < connectivity.size(); ++k) {
    Index& lowest = of_cell[k / ix(nodes)];
    lowest = std::min(lowest, layer[ix(connectivity[k])]);
  }
  return linear::slabs(of_cell, {std::max(least, cells / 32), 1});
}

} // namespace stiction::solid
