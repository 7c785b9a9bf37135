// Splitting quadrilaterals into triangles and adding mid-side nodes.
#include "mesh/quads.hpp"

#include <map>
#include <numeric>
#include <utility>

namespace stiction::mesh {

namespace {

double squared_distance(Quads const& quads, Index a, Index b) {
  auto const& p = quads.nodes[static_cast<std::size_t>(a)];
  auto const& q = quads.nodes[static_cast<std::size_t>(b)];
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

/// Corners of the cells, cell after cell.
Indices corner_cells(Quads const& quads, bool triangles) {
  Indices corners;
  for (auto const& c : quads.cells) {
    if (!triangles)
      corners.insert(corners.end(), c.begin(), c.end());
    else if (squared_distance(quads, c[0], c[2]) <= squared_distance(quads, c[1], c[3]))
      corners.insert(corners.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
    else
      corners.insert(corners.end(), {c[0], c[1], c[3], c[1], c[2], c[3]});
  }
  return corners;
}

/// Makes one mid-side node per edge, shared by the cells on both sides.
class MidNodes {
public:
  MidNodes(std::vector<Eigen::RowVector2d>& nodes, MidPoint const& middle)
      : nodes_(&nodes), middle_(&middle) {}

  Index between(Index a, Index b) {
    auto const [found, is_new] = known_.try_emplace(std::minmax(a, b), static_cast<Index>(nodes_->size()));
    if (is_new)
      nodes_->push_back(
          (*middle_)((*nodes_)[static_cast<std::size_t>(a)], (*nodes_)[static_cast<std::size_t>(b)]));
    return found->second;
  }

private:
  std::vector<Eigen::RowVector2d>* nodes_;
  MidPoint const* middle_;
  std::map<std::pair<Index, Index>, Index> known_;
};

} // namespace

Eigen::RowVector2d straight_middle(Eigen::RowVector2d const& a, Eigen::RowVector2d const& b) {
  return (a + b) / 2;
}

Mesh to_mesh(Quads const& quads, CellKind kind, MidPoint const& middle) {
  CellInfo const& cell = info(kind);
  std::vector<Eigen::RowVector2d> nodes;
  for (auto const& node : quads.nodes)
    nodes.emplace_back(node[0], node[1]);
  MidNodes mid_nodes(nodes, middle);

  Block block{kind, {}};
  auto const corners = corner_cells(quads, cell.corners == 3);
  for (std::size_t first = 0; first < corners.size(); first += static_cast<std::size_t>(cell.corners)) {
    auto const corner = [&](int local) { return corners[first + static_cast<std::size_t>(local)]; };
    for (int i = 0; i < cell.corners; ++i)
      block.nodes.push_back(corner(i));
    for (int i = cell.corners; i < cell.nodes; ++i) {
      auto const& side = cell.facets[static_cast<std::size_t>(i - cell.corners)];
      block.nodes.push_back(mid_nodes.between(corner(side[0]), corner(side[1])));
    }
  }
  Mesh mesh;
  mesh.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 2);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    mesh.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i];
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

Set all_nodes(Mesh const& mesh) {
  Set set;
  set.nodes.resize(static_cast<std::size_t>(mesh.node_count()));
  std::iota(set.nodes.begin(), set.nodes.end(), Index{0});
  return set;
}

} // namespace stiction::mesh
