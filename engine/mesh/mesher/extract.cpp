// Takes nodes, cells and named sets out of gmsh's current model.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gmsh.h>
#include <map>
#include <numeric>
#include <optional>

#include "core/error.hpp"
#include "mesh/mesher/tasks.hpp"
#include "mesh/quads.hpp"

namespace stiction::mesher {

namespace {

using mesh::Mesh;
using Tags = std::vector<std::size_t>;

/// Elements of one type on some entities, element after element.
struct Elements {
  int type;
  Tags nodes;
};

/// All elements of dimension `dim` on the given entities.
std::vector<Elements> elements_on(int dim, std::vector<int> const& entities) {
  std::map<int, Tags> by_type;
  for (int const entity : entities) {
    std::vector<int> types;
    std::vector<Tags> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, dim, entity);
    for (std::size_t i = 0; i < types.size(); ++i)
      by_type[types[i]].insert(by_type[types[i]].end(), nodes[i].begin(), nodes[i].end());
  }
  std::vector<Elements> result;
  result.reserve(by_type.size());
  for (auto& [type, nodes] : by_type)
    result.push_back({type, std::move(nodes)});
  return result;
}

std::vector<int> entities_of(int dim) {
  gmsh::vectorpair pairs;
  gmsh::model::getEntities(pairs, dim);
  std::vector<int> tags;
  for (auto const& [d, tag] : pairs)
    tags.push_back(tag);
  return tags;
}

struct Group {
  int dim;
  std::string name;
  std::vector<int> entities;
};

/// The physical groups of a dimension; those without a name are called point_1, curve_1, surface_1.
std::vector<Group> groups_of(int dim) {
  static constexpr char const* words[] = {"point", "curve", "surface"};
  gmsh::vectorpair pairs;
  gmsh::model::getPhysicalGroups(pairs, dim);
  std::vector<Group> groups;
  for (auto const& [d, tag] : pairs) {
    Group group{dim, "", {}};
    gmsh::model::getPhysicalName(dim, tag, group.name);
    if (group.name.empty())
      group.name = fmt::format("{}_{}", words[dim], tag);
    gmsh::model::getEntitiesForPhysicalGroup(dim, tag, group.entities);
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Surfaces in physical groups, or all surfaces when there are no such groups.
std::vector<int> surfaces_to_take() {
  std::vector<int> surfaces;
  for (auto const& group : groups_of(2))
    surfaces.insert(surfaces.end(), group.entities.begin(), group.entities.end());
  if (surfaces.empty())
    return entities_of(2);
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

std::optional<mesh::CellKind> kind_of_type(int gmsh_type) {
  for (auto const& cell : mesh::cell_table())
    if (cell.gmsh_type == gmsh_type)
      return cell.kind;
  return std::nullopt;
}

void refuse_solids() {
  for (auto const& elements : elements_on(3, entities_of(3)))
    if (!elements.nodes.empty())
      throw core::InputError("the mesh has solid cells (3D); only plane meshes are read so far");
}

/// Numbers the nodes that cells use, in the order of gmsh's tags.
class Numbering {
public:
  explicit Numbering(std::vector<Elements> const& cells) {
    for (auto const& elements : cells)
      tags_.insert(tags_.end(), elements.nodes.begin(), elements.nodes.end());
    std::sort(tags_.begin(), tags_.end());
    tags_.erase(std::unique(tags_.begin(), tags_.end()), tags_.end());
  }
  [[nodiscard]] std::optional<Index> find(std::size_t tag) const {
    auto const found = std::lower_bound(tags_.begin(), tags_.end(), tag);
    if (found == tags_.end() || *found != tag)
      return std::nullopt;
    return static_cast<Index>(found - tags_.begin());
  }
  /// Coordinates [nodes, 2], m. Throws InputError when the nodes do not lie in a plane z = constant.
  [[nodiscard]] Matrix coordinates(double scale) const {
    std::vector<double> xyz, parameters;
    Tags given;
    gmsh::model::mesh::getNodes(given, xyz, parameters);
    Matrix nodes = Matrix::Constant(static_cast<Eigen::Index>(tags_.size()), 3, std::nan(""));
    for (std::size_t i = 0; i < given.size(); ++i)
      if (auto const node = find(given[i]))
        nodes.row(*node) << xyz[3 * i] * scale, xyz[3 * i + 1] * scale, xyz[3 * i + 2] * scale;
    double const extent = (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).maxCoeff();
    if (nodes.col(2).maxCoeff() - nodes.col(2).minCoeff() > 1e-9 * extent)
      throw core::InputError(
          "the mesh is not plane: its z coordinates differ; only meshes in x, y are read so far");
    return nodes.leftCols(2);
  }

private:
  Tags tags_;
};

/// Twice the signed area of a cell by its corners.
double signed_area(Mesh const& mesh, Index const* nodes, int corners) {
  double sum = 0;
  for (int i = 0; i < corners; ++i) {
    auto const a = mesh.nodes.row(nodes[i]), b = mesh.nodes.row(nodes[(i + 1) % corners]);
    sum += a[0] * b[1] - a[1] * b[0];
  }
  return sum;
}

void for_each_cell(Mesh& mesh, auto act) {
  for (auto& block : mesh.blocks) {
    auto const& cell = mesh::info(block.kind);
    for (std::size_t i = 0; i < block.nodes.size(); i += static_cast<std::size_t>(cell.nodes))
      act(cell, &block.nodes[i]);
  }
}

/// A mesh seen from behind (all cells clockwise) is turned round; single inverted cells are left to be
/// refused.
void turn_to_front(Mesh& mesh) {
  bool all_behind = true;
  for_each_cell(mesh, [&](mesh::CellInfo const& cell, Index const* nodes) {
    all_behind = all_behind && signed_area(mesh, nodes, cell.corners) < 0;
  });
  if (!all_behind)
    return;
  for_each_cell(mesh, [](mesh::CellInfo const& cell, Index* nodes) {
    std::reverse(nodes + 1, nodes + cell.corners);
    std::reverse(nodes + cell.corners, nodes + cell.nodes);
  });
}

Indices unique_nodes(std::vector<Elements> const& elements, Numbering const& numbering) {
  Indices nodes;
  for (auto const& part : elements)
    for (std::size_t const tag : part.nodes)
      if (auto const node = numbering.find(tag))
        nodes.push_back(*node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

/// Facets by their two corners in ascending order.
using Boundary = std::map<std::pair<Index, Index>, mesh::Facet>;

Boundary boundary_by_corners(Mesh const& mesh) {
  Boundary result;
  for (auto const& facet : mesh::boundary(mesh))
    result.emplace(std::minmax(facet.nodes[0], facet.nodes[1]), facet);
  return result;
}

/// The facets that lie on lines; lines inside the body have none.
std::vector<mesh::Facet> facets_on(std::vector<Elements> const& lines, Numbering const& numbering,
                                   Boundary const& boundary) {
  std::vector<mesh::Facet> facets;
  for (auto const& part : lines) {
    std::size_t const step = part.type == 8 ? 3 : 2; // gmsh's 3-node line, else 2 nodes
    for (std::size_t i = 0; i + step <= part.nodes.size(); i += step) {
      auto const a = numbering.find(part.nodes[i]), b = numbering.find(part.nodes[i + 1]);
      auto const found = a && b ? boundary.find(std::minmax(*a, *b)) : boundary.end();
      if (found != boundary.end())
        facets.push_back(found->second);
    }
  }
  return facets;
}

void add_sets(Mesh& mesh, Numbering const& numbering) {
  auto const boundary = boundary_by_corners(mesh);
  for (int dim = 0; dim <= 2; ++dim)
    for (auto const& group : groups_of(dim)) {
      auto const elements = elements_on(dim, group.entities);
      auto& set = mesh.sets[group.name];
      Indices const nodes = unique_nodes(elements, numbering);
      Indices both;
      std::set_union(set.nodes.begin(), set.nodes.end(), nodes.begin(), nodes.end(),
                     std::back_inserter(both));
      set.nodes = both;
      if (dim == 1)
        set.facets = facets_on(elements, numbering, boundary);
    }
  mesh.sets.try_emplace("all", mesh::all_nodes(mesh));
}

} // namespace

Mesh extract(double scale) {
  refuse_solids();
  auto const cells = elements_on(2, surfaces_to_take());
  if (cells.empty())
    throw core::InputError("the mesh has no cells (no surface elements)");
  Numbering const numbering(cells);
  Mesh mesh;
  mesh.nodes = numbering.coordinates(scale);
  for (auto const& elements : cells) {
    auto const kind = kind_of_type(elements.type);
    if (!kind)
      throw core::InputError(
          fmt::format("the mesh has cells of gmsh's type {}; known are tri3, tri6, quad4 and quad8 "
                      "(second order quadrilaterals need Mesh.SecondOrderIncomplete = 1)",
                      elements.type));
    mesh::Block block{*kind, {}};
    for (std::size_t const tag : elements.nodes)
      block.nodes.push_back(*numbering.find(tag));
    mesh.blocks.push_back(std::move(block));
  }
  turn_to_front(mesh);
  add_sets(mesh, numbering);
  return mesh;
}

} // namespace stiction::mesher
