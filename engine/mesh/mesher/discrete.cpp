// Cells become one discrete entity, every set one of its own.
#include <gmsh.h>

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

void add_cells(FileMesh const& mesh, int dim) {
  int const entity = gmsh::model::addDiscreteEntity(dim);
  Tags tags;
  std::vector<double> places;
  for (auto const& [tag, place] : mesh.nodes) {
    tags.push_back(tag);
    places.insert(places.end(), place.begin(), place.end());
  }
  gmsh::model::mesh::addNodes(dim, entity, tags, places);
  std::map<int, Tags> by_type;
  for (auto const& [number, cell] : mesh.cells) {
    auto const& info = mesh::info(cell.kind);
    Tags nodes(cell.nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      nodes[static_cast<std::size_t>(info.gmsh_order[k])] = cell.nodes[k];
    auto& all = by_type[info.gmsh_type];
    all.insert(all.end(), nodes.begin(), nodes.end());
  }
  for (auto const& [type, nodes] : by_type)
    gmsh::model::mesh::addElementsByType(entity, type, {}, nodes);
  gmsh::model::setPhysicalName(dim, gmsh::model::addPhysicalGroup(dim, {entity}), "all");
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
