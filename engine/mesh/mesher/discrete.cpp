// Cells become discrete entities by the sets they are in, every other set one of its own.
#include <gmsh.h>
#include <set>

#include "mesh/mesher/file_mesh.hpp"

namespace stiction::mesher {

namespace {

int gmsh_type_of(std::size_t facet_nodes, int dim) {
  if (dim == 2)
    return facet_nodes == 2 ? 1 : 8;
  return facet_nodes == 3 ? 2 : facet_nodes == 6 ? 9 : facet_nodes == 4 ? 3 : 16;
}

void add_entity(int dim, std::string const& name, std::map<int, Tags> const& nodes_by_type) {
  int const entity = gmsh::model::addDiscreteEntity(dim);
  for (auto const& [type, nodes] : nodes_by_type)
    gmsh::model::mesh::addElementsByType(entity, type, {}, nodes);
  int const group = gmsh::model::addPhysicalGroup(dim, {entity});
  gmsh::model::setPhysicalName(dim, group, name);
}

void add_nodes(FileMesh const& mesh, int dim, int entity) {
  Tags tags;
  std::vector<double> places;
  for (auto const& [tag, place] : mesh.nodes) {
    tags.push_back(tag);
    places.insert(places.end(), place.begin(), place.end());
  }
  gmsh::model::mesh::addNodes(dim, entity, tags, places);
}

/// Cells that are in the same sets stand in one entity; the sets are groups of these.
void add_cells(FileMesh const& mesh, int dim) {
  std::map<std::size_t, std::set<std::string>> sets_of; // by cell
  for (auto const& [name, cells] : mesh.cell_sets)
    for (std::size_t const cell : cells)
      sets_of[cell].insert(name);
  std::map<std::set<std::string>, std::map<int, Tags>> parts; // nodes by type
  for (auto const& [number, cell] : mesh.cells) {
    auto const& info = mesh::info(cell.kind);
    Tags nodes(cell.nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nodes[static_cast<std::size_t>(info.gmsh_order[k])] = cell.nodes[k];
    auto& all = parts[sets_of[number]][info.gmsh_type];
    all.insert(all.end(), nodes.begin(), nodes.end());
  }
  std::map<std::string, std::vector<int>> groups;
  for (auto const& [names, by_type] : parts) {
    int const entity = gmsh::model::addDiscreteEntity(dim);
    if (groups.empty())
      add_nodes(mesh, dim, entity);
    for (auto const& [type, nodes] : by_type)
      gmsh::model::mesh::addElementsByType(entity, type, {}, nodes);
    groups["all"].push_back(entity);
    for (auto const& name : names)
      if (name != "all")
        groups[name].push_back(entity);
  }
  for (auto const& [name, entities] : groups) {
    bool const taken = mesh.node_sets.contains(name) || mesh.side_sets.contains(name);
    gmsh::model::setPhysicalName(dim, gmsh::model::addPhysicalGroup(dim, entities),
                                 (taken ? std::string(cells_only) : "") + name);
  }
}

} // namespace

void put_into_gmsh(FileMesh const& mesh) {
  gmsh::model::add("file");
  int const dim = mesh::info(mesh.cells.begin()->second.kind).dim;
  add_cells(mesh, dim);
  for (auto const& [name, nodes] : mesh.node_sets)
    add_entity(0, name, {{15, nodes}});
  for (auto const& [name, facets] : mesh.side_sets) {
    std::map<int, Tags> by_type;
    for (auto const& facet : facets) {
      auto& all = by_type[gmsh_type_of(facet.size(), dim)];
      all.insert(all.end(), facet.begin(), facet.end());
    }
    add_entity(dim - 1, name, by_type);
  }
}

} // namespace stiction::mesher
