// Contact points that are weighted means over nodes, where shape functions leave a node without an area.
#pragma once
#include "contact/node_to_segment/kinematics.hpp"
#include "mesh/topology/hats.hpp"

namespace stiction::contact {

/// x_i = sum_j c_ij x_j of what the nodes see, with the weights of mesh::surface_shares (some negative); the
/// force on node j is sum_i c_ij p_i. A uniform traction then has the nodal forces that the cells ask for.
template<int D> class NodeMeans {
public:
  /// means [points]
  explicit NodeMeans(std::vector<std::vector<mesh::NodeShare>> means)
      : means_(std::move(means)), seen_(means_.size()), whole_(means_.size()) {}

  /// What the node of each point sees, [points]; after filling it, `settle`.
  [[nodiscard]] std::vector<PointKinematics<D>>& seen() { return seen_; }
  [[nodiscard]] std::vector<PointKinematics<D>> const& seen() const { return seen_; }
  /// A point among whose nodes one sees nothing, or another side of an edge, is its own node alone.
  void settle();
  /// Gap, slip and rows of the mean; foot and frame: of the point's own node.
  [[nodiscard]] PointKinematics<D> point(Index i) const;
  /// The nodes that the point is the mean of, with their weights.
  [[nodiscard]] std::vector<mesh::NodeShare> nodes_of(Index i) const;
  /// Forces on the nodes, each in its own frame, of forces on the points. [points]
  [[nodiscard]] std::vector<Local<D>> at_nodes(std::vector<Local<D>> const& forces) const;

private:
  std::vector<std::vector<mesh::NodeShare>> means_;
  std::vector<PointKinematics<D>> seen_;
  std::vector<bool> whole_;
};

} // namespace stiction::contact
