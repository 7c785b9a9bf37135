// A mesh as a file of another program tells it, on its way into gmsh's current model.
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "mesh/cells/cell.hpp"

namespace stiction::mesher {

using Tags = std::vector<std::size_t>;

/// Nodes in our order.
struct FileCell {
  mesh::CellKind kind;
  Tags nodes;
};

struct FileMesh {
  std::map<std::size_t, std::array<double, 3>> nodes; ///< by number, in the file's unit
  std::map<std::size_t, FileCell> cells;              ///< by number: those to compute on, of one dimension
  std::map<std::string, Tags> node_sets;              ///< numbers of nodes
  std::map<std::string, std::vector<Tags>> side_sets; ///< nodes of facets, in our order
  std::map<std::string, Tags> cell_sets;              ///< numbers of cells
};

/// So begins the name of a physical group that gives a set its cells and no nodes: a set of nodes or sides
/// has the name already.
inline constexpr std::string_view cells_only = "cells of ";

/// Reads an input file of Abaqus or CalculiX: *NODE, *ELEMENT, *NSET, *ELSET, *SURFACE; what says how to
/// compute is passed over. Throws InputError with the line of what cannot be read.
[[nodiscard]] FileMesh parse_inp(std::string const& content);

/// Reads an unstructured grid of VTK, .vtu or legacy .vtk: arrays of whole numbers at cells (or points)
/// become sets NAME_VALUE. Throws InputError where it cannot be read or has cells of a kind we lack.
[[nodiscard]] FileMesh read_vtk(std::string const& path);

/// Makes discrete entities of it, sets as physical groups.
void put_into_gmsh(FileMesh const& mesh);

} // namespace stiction::mesher
