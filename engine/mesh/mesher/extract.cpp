// Takes nodes, cells and named sets out of gmsh's current model.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gmsh.h>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "mesh/generators/quads.hpp"
#include "mesh/mesher/file_mesh.hpp"
#include "mesh/mesher/tasks.hpp"
#include "mesh/topology/surface.hpp"

namespace stiction::mesher {

namespace {

using mesh::Mesh;

/// Elements of one type on some entities, element after element.
struct Elements {
  int type;
  Tags nodes;
  Tags tags; ///< gmsh's numbers of the elements
};

/// All elements of dimension `dim` on the given entities.
std::vector<Elements> elements_on(int dim, std::vector<int> const& entities) {
  std::map<int, Elements> by_type;
  for (int const entity : entities) {
    std::vector<int> types;
    std::vector<Tags> elements, nodes;
    gmsh::model::mesh::getElements(types, elements, nodes, dim, entity);
    for (std::size_t i = 0; i < types.size(); ++i) {
      auto& all = by_type.try_emplace(types[i], Elements{types[i], {}, {}}).first->second;
      all.nodes.insert(all.nodes.end(), nodes[i].begin(), nodes[i].end());
      all.tags.insert(all.tags.end(), elements[i].begin(), elements[i].end());
    }
  }
  std::vector<Elements> result;
  result.reserve(by_type.size());
  for (auto& [type, elements] : by_type)
    result.push_back(std::move(elements));
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

/// The physical groups of a dimension; those without a name are called point_1, curve_1, surface_1, volume_1.
std::vector<Group> groups_of(int dim) {
  static constexpr char const* words[] = {"point", "curve", "surface", "volume"};
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

/// Entities of a dimension in physical groups, or all of them when there are no such groups.
std::vector<int> entities_to_take(int dim) {
  std::vector<int> entities;
  for (auto const& group : groups_of(dim))
    entities.insert(entities.end(), group.entities.begin(), group.entities.end());
  if (entities.empty())
    return entities_of(dim);
  std::sort(entities.begin(), entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
  return entities;
}

/// 3 when the mesh has solid cells, else 2. Solid and surface cells together leave open which are wanted,
/// unless there is a physical volume.
int dimension() {
  if (elements_on(3, entities_of(3)).empty())
    return 2;
  if (groups_of(3).empty() && !elements_on(2, entities_of(2)).empty())
    throw core::InputError(
        "the mesh has solid cells and surface cells but no physical volume, so that it is "
        "open which to compute on; make the volume a physical group, or save a mesh in 2D");
  return 3;
}

std::optional<mesh::CellKind> kind_of_type(int gmsh_type) {
  for (auto const& cell : mesh::cell_table())
    if (cell.gmsh_type == gmsh_type)
      return cell.kind;
  return std::nullopt;
}

/// A number of the nodes of an element, whatever their order.
std::size_t hash_of(std::size_t const* nodes, std::size_t count) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t mixed = (nodes[k] + 1) * 0x9e3779b97f4a7c15U; // the golden ratio's bits
    mixed ^= mixed >> 29;
    sum += mixed * mixed;
  }
  return sum;
}

/// Format 2.2 writes an element once for each physical group that it is in. All but the first are taken out;
/// which of gmsh's numbers stood for which.
std::map<std::size_t, std::size_t> take_out_repeated(Elements& elements) {
  std::size_t const count = elements.tags.size(), step = count > 0 ? elements.nodes.size() / count : 0;
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t i = 0; i < count; ++i)
    order.emplace_back(hash_of(&elements.nodes[step * i], step), i);
  std::sort(order.begin(), order.end());
  std::map<std::size_t, std::size_t> same;
  std::vector<bool> repeated(count, false);
  for (std::size_t k = 1; k < count; ++k) {
    auto const first = &elements.nodes[step * order[k - 1].second],
               next = &elements.nodes[step * order[k].second];
    if (order[k].first != order[k - 1].first || !std::is_permutation(first, first + step, next))
      continue;
    std::size_t const tag = elements.tags[order[k - 1].second];
    repeated[order[k].second] = true;
    same[elements.tags[order[k].second]] = same.contains(tag) ? same[tag] : tag;
  }
  if (same.empty())
    return same;
  Elements kept{elements.type, {}, {}};
  for (std::size_t i = 0; i < count; ++i)
    if (!repeated[i]) {
      kept.tags.push_back(elements.tags[i]);
      kept.nodes.insert(kept.nodes.end(), &elements.nodes[step * i], &elements.nodes[step * i] + step);
    }
  elements = std::move(kept);
  return same;
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
  /// Coordinates [nodes, dim], m. Throws InputError when the nodes of a 2D mesh do not lie in a plane z =
  /// constant.
  [[nodiscard]] Matrix coordinates(double scale, int dim) const {
    std::vector<double> xyz, parameters;
    Tags given;
    gmsh::model::mesh::getNodes(given, xyz, parameters);
    Matrix nodes = Matrix::Constant(static_cast<Eigen::Index>(tags_.size()), 3, std::nan(""));
    for (std::size_t i = 0; i < given.size(); ++i)
      if (auto const node = find(given[i]))
        nodes.row(*node) << xyz[3 * i] * scale, xyz[3 * i + 1] * scale, xyz[3 * i + 2] * scale;
    if (dim == 3)
      return nodes;
    double const extent = (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).maxCoeff();
    if (nodes.col(2).maxCoeff() - nodes.col(2).minCoeff() > 1e-9 * extent)
      throw core::InputError("the mesh is not plane: its z coordinates differ but it has no solid cells; "
                             "shells are not computed "
                             "on: mesh the volume too, or lay the mesh into a plane z = constant");
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

/// Sorts, and leaves each once.
void make_unique(Indices& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Facets by their corners in ascending order.
using Boundary = std::map<Indices, mesh::Facet>;

Indices key_of(Index const* nodes, std::size_t corners) {
  Indices key(nodes, nodes + corners);
  std::sort(key.begin(), key.end());
  return key;
}

/// Corners of a side: a line in 2D, a cell of the plane in 3D.
std::size_t corners_of(mesh::Facet const& facet, int dim) {
  return dim == 2 ? 2 : static_cast<std::size_t>(mesh::info(mesh::facet_kind(facet)).corners);
}

Boundary boundary_by_corners(Mesh const& mesh) {
  Boundary result;
  for (auto const& facet : mesh::boundary(mesh))
    result.emplace(key_of(facet.nodes.data(), corners_of(facet, mesh.dim)), facet);
  return result;
}

/// Nodes and corners of gmsh's lines (2 or 3 nodes) and plane cells.
std::array<std::size_t, 2> nodes_and_corners(int gmsh_type) {
  auto const kind = kind_of_type(gmsh_type);
  if (!kind)
    return {gmsh_type == 8 ? 3U : 2U, 2};
  auto const& cell = mesh::info(*kind);
  return {static_cast<std::size_t>(cell.nodes), static_cast<std::size_t>(cell.corners)};
}

/// The facets that lie on these lines or plane cells, each once; those inside the body have none.
std::vector<mesh::Facet> facets_on(std::vector<Elements> const& sides, Numbering const& numbering,
                                   Boundary const& boundary) {
  std::vector<mesh::Facet> facets;
  std::set<Indices> seen;
  for (auto const& part : sides) {
    auto const [step, corners] = nodes_and_corners(part.type);
    for (std::size_t i = 0; i + step <= part.nodes.size(); i += step) {
      Indices nodes;
      for (std::size_t k = 0; k < corners; ++k)
        nodes.push_back(numbering.find(part.nodes[i + k]).value_or(-1));
      auto const found = boundary.find(key_of(nodes.data(), corners));
      if (found != boundary.end() && seen.insert(found->first).second)
        facets.push_back(found->second);
    }
  }
  return facets;
}

/// The numbers of cells, block after block, by gmsh's tags.
using CellNumbers = std::map<std::size_t, Index>;

/// same: numbers of repeated cells, by those that are kept.
CellNumbers numbers_of(std::vector<Elements> const& cells, std::map<std::size_t, std::size_t> const& same) {
  CellNumbers numbers;
  for (auto const& elements : cells)
    for (std::size_t const tag : elements.tags)
      numbers.emplace(tag, static_cast<Index>(numbers.size()));
  for (auto const& [tag, kept] : same)
    numbers.emplace(tag, numbers.at(kept));
  return numbers;
}

Indices cells_of(std::vector<Elements> const& elements, CellNumbers const& numbers) {
  Indices cells;
  for (auto const& part : elements)
    for (std::size_t const tag : part.tags)
      cells.push_back(numbers.at(tag));
  make_unique(cells);
  return cells;
}

void add_sets(Mesh& mesh, Numbering const& numbering, CellNumbers const& cells) {
  auto const boundary = boundary_by_corners(mesh);
  for (int dim = 0; dim <= mesh.dim; ++dim)
    for (auto const& group : groups_of(dim)) {
      auto const elements = elements_on(dim, group.entities);
      if (group.name.starts_with(cells_only)) {
        mesh.sets[group.name.substr(cells_only.size())].cells = cells_of(elements, cells);
        continue;
      }
      auto& set = mesh.sets[group.name];
      if (dim == mesh.dim)
        set.cells = cells_of(elements, cells);
      if (dim == mesh.dim - 1)
        set.facets = facets_on(elements, numbering, boundary);
      for (auto const& part : elements)
        for (std::size_t const tag : part.nodes)
          if (auto const node = numbering.find(tag))
            set.nodes.push_back(*node);
      for (auto const& facet : set.facets) // with what lies between corners, which elements may leave out
        set.nodes.insert(set.nodes.end(), facet.nodes.begin(), facet.nodes.end());
      make_unique(set.nodes);
    }
  mesh.sets.try_emplace("all", mesh::all_nodes(mesh));
}

/// Cells of one of our kinds in the order of its nodes.
mesh::Block block_of(Elements const& elements, Numbering const& numbering) {
  auto const kind = kind_of_type(elements.type);
  if (elements.type == 10 || elements.type == 12) // gmsh's second order without Mesh.SecondOrderIncomplete
    throw core::InputError(fmt::format(
        "the mesh has cells of kind {}, with nodes in the middle of {}; {} is computed on: set "
        "Mesh.SecondOrderIncomplete = 1 in gmsh, mesh and save anew",
        elements.type == 10 ? "quad9" : "hex27", elements.type == 10 ? "faces" : "faces and cells",
        elements.type == 10 ? "quad8" : "hex20"));
  if (!kind)
    throw core::InputError(
        fmt::format("the mesh has cells of gmsh's type {}; known are tri3, tri6, quad4, quad8, tet4, tet10, "
                    "hex8 and hex20 (second order quadrilaterals and hexahedra need "
                    "Mesh.SecondOrderIncomplete = 1)",
                    elements.type));
  auto const& order = mesh::info(*kind).gmsh_order;
  mesh::Block block{*kind, {}};
  for (std::size_t first = 0; first < elements.nodes.size(); first += order.size())
    for (int const local : order)
      block.nodes.push_back(*numbering.find(elements.nodes[first + static_cast<std::size_t>(local)]));
  return block;
}

} // namespace

Mesh extract(double scale) {
  int const dim = dimension();
  auto cells = elements_on(dim, entities_to_take(dim));
  std::map<std::size_t, std::size_t> same;
  for (auto& elements : cells)
    same.merge(take_out_repeated(elements));
  if (cells.empty())
    throw core::InputError("the mesh has no cells (no surface or volume elements)");
  Numbering const numbering(cells);
  Mesh mesh;
  mesh.dim = dim;
  mesh.nodes = numbering.coordinates(scale, dim);
  for (auto const& elements : cells)
    mesh.blocks.push_back(block_of(elements, numbering));
  if (dim == 2)
    turn_to_front(mesh);
  add_sets(mesh, numbering, numbers_of(cells, same));
  return mesh;
}

} // namespace stiction::mesher
