// From corner nodes to a mesh of one kind, with one mid-side node an edge where the kind wants them.
#pragma once
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

template<int dim> using Position = Eigen::Matrix<double, 1, dim>; ///< m
/// Mid-side node between two corners; given their positions, returns that of the node.
template<int dim> using Middle = std::function<Position<dim>(Position<dim> const&, Position<dim> const&)>;

/// Cells of `kind` without sets; `corners` holds the corners of cell after cell.
template<int dim>
[[nodiscard]] Mesh with_mid_nodes(CellKind kind, std::vector<Position<dim>> nodes, Indices const& corners,
                                  Middle<dim> const& middle) {
  CellInfo const& cell = info(kind);
  std::map<std::pair<Index, Index>, Index> known;
  auto const between = [&](Index a, Index b) {
    auto const [found, is_new] = known.try_emplace(std::minmax(a, b), static_cast<Index>(nodes.size()));
    if (is_new)
      nodes.push_back(Position<dim>(middle(nodes[ix(a)], nodes[ix(b)])));
    return found->second;
  };
  Block block{kind, {}};
  for (auto first = corners.begin(); first != corners.end(); first += cell.corners) {
    block.nodes.insert(block.nodes.end(), first, first + cell.corners);
    for (std::size_t i = 0; cell.nodes > cell.corners && i < cell.edges.size(); ++i)
      block.nodes.push_back(between(first[cell.edges[i][0]], first[cell.edges[i][1]]));
  }
  Mesh mesh;
  mesh.dim = dim;
  mesh.nodes.resize(static_cast<Eigen::Index>(nodes.size()), dim);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    mesh.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i];
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

} // namespace stiction::mesh
