// The immutable mesh: nodes, cells by kind, named sets of nodes and facets.
#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "mesh/cells/cell.hpp"

namespace stiction::mesh {

/// Cells of one kind; `nodes` holds cell after cell, in the order of the VTK file format.
struct Block {
  CellKind kind = CellKind::quad4;
  Indices nodes; ///< [cells * info(kind).nodes]
};

/// A facet as the nodes of one side of a cell, corner nodes first, in the cell's outward orientation:
/// in 2D the body lies to the left when walking from nodes[0] to nodes[1]; in 3D the facet is a cell of the
/// plane (facet_kind in surface.hpp) whose corners run counter-clockwise seen from outside.
struct Facet {
  Indices nodes;
};

/// A named part of the mesh. Sets that are boundaries have facets; their nodes are sorted and unique.
struct Set {
  Indices nodes;
  std::vector<Facet> facets;
  Indices cells{}; ///< numbered block after block, ascending; only of sets that a file makes of cells
};

struct Mesh {
  int dim = 2;
  Matrix nodes; ///< [nodes, dim], m
  std::vector<Block> blocks;
  std::map<std::string, Set, std::less<>> sets;

  [[nodiscard]] Index node_count() const { return static_cast<Index>(nodes.rows()); }
  [[nodiscard]] Index cell_count() const;
};

/// What is in any of the sets, each once; a boundary where all of them are.
[[nodiscard]] Set join(std::vector<Set const*> const& sets);

/// Boundary facets of all cells: those that belong to one cell only.
[[nodiscard]] std::vector<Facet> boundary(Mesh const& mesh);

/// The boundary facets whose every node satisfies `inside`, as a set.
template<class Predicate> [[nodiscard]] Set boundary_where(Mesh const& mesh, Predicate inside) {
  Set set;
  for (auto const& facet : boundary(mesh)) {
    bool all = true;
    for (Index const node : facet.nodes)
      all = all && inside(mesh.nodes.row(node));
    if (!all)
      continue;
    set.facets.push_back(facet);
    set.nodes.insert(set.nodes.end(), facet.nodes.begin(), facet.nodes.end());
  }
  std::sort(set.nodes.begin(), set.nodes.end());
  set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
  return set;
}

} // namespace stiction::mesh
