// Behind which facet of the secondary's body a node lies, then how deep in the whole of it.
#include "scene/run/dug_in.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/tunnelling/inside.hpp"

namespace stiction::scene {

namespace {

using contact::Vec;

/// The body that a node is of.
std::size_t body_of(dynamics::Model const& model, Index node) {
  auto const after = std::upper_bound(model.first_node.begin(), model.first_node.end(), node);
  return static_cast<std::size_t>(after - model.first_node.begin()) - 1;
}

Indices nodes_of(contact::Curve const& curve) {
  Indices nodes;
  for (auto const& segment : curve.segments())
    nodes.insert(nodes.end(), segment.ends.begin(), segment.ends.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

Indices primary_nodes(dynamics::Pair const& pair) {
  if (auto const* curve = std::get_if<contact::Curve>(&pair.primary))
    return nodes_of(*curve);
  if (auto const* surface = std::get_if<contact::Surface>(&pair.primary))
    return surface->nodes();
  return {};
}

/// Corners of a facet's straight piece, where they are now.
template<int D> using Corners = Eigen::Matrix<double, D, D>;

/// The size of the piece if the point lies behind it by `least` to one of that, else 0, m.
template<int D> double size_if_behind(Corners<D> const& corners, Vec<D> const& point, double least) {
  Eigen::Matrix<double, D, D - 1> const sides = corners.rightCols(D - 1).colwise() - corners.col(0);
  Vec<D> const normal = contact::across<D>(sides);
  double const size = D == 2 ? normal.norm() : std::sqrt(normal.norm());
  double const depth = normal.normalized().dot(corners.col(0) - point);
  if (!(depth > least * size) || depth > size)
    return 0;
  Eigen::Matrix<double, D - 1, 1> const part =
      (sides.transpose() * sides).inverse() * (sides.transpose() * (point - corners.col(0)));
  return part.minCoeff() >= 0 && part.sum() <= 1 ? size : 0;
}

/// The boundary of a body where it is now.
template<int D> class Hull {
public:
  Hull(mesh::Mesh const& mesh, std::span<double const> x) : panels_(contact::panels_of<D>(mesh)), x_(x) {
    std::vector<contact::Box<D>> boxes;
    boxes.reserve(panels_.size());
    for (auto const& panel : panels_) {
      auto const at = corners(panel);
      boxes.push_back({at.rowwise().minCoeff(), at.rowwise().maxCoeff()});
      largest_ = std::max(largest_, (boxes.back().high - boxes.back().low).norm());
    }
    grid_.build(boxes);
  }

  [[nodiscard]] DugIn look(Index node, Vec<D> const& point, double least) const {
    double size = 0;
    grid_.near(point, largest_, [&](int panel) {
      size =
          std::max(size, size_if_behind<D>(corners(panels_[static_cast<std::size_t>(panel)]), point, least));
    });
    if (size == 0)
      return {};
    double const depth = contact::depth_inside<D>(panels_, x_, point);
    return depth > least * size ? DugIn{node, depth, depth / size} : DugIn{};
  }

private:
  [[nodiscard]] Corners<D> corners(contact::Panel<D> const& panel) const {
    Corners<D> at;
    for (int k = 0; k < D; ++k)
      at.col(k) = Eigen::Map<Vec<D> const>(x_.data() + D * panel[static_cast<std::size_t>(k)]);
    return at;
  }

  std::vector<contact::Panel<D>> panels_;
  std::span<double const> x_; ///< of the body's nodes, [D nodes], m
  contact::Grid<D> grid_;
  double largest_ = 0; ///< extent of a panel, m
};

template<int D>
DugIn deepest_of(dynamics::Model const& model, dynamics::Pair const& pair, Vector const& u, double least) {
  std::size_t const body = body_of(model, pair.secondary.front());
  auto const nodes = primary_nodes(pair);
  if (nodes.empty() || body_of(model, nodes.front()) == body)
    return {};
  Vector const x = Eigen::Map<Vector const>(model.reference.data(), model.dofs()) + u;
  auto const& mesh = model.bodies[body]->mesh;
  Hull<D> const hull(
      mesh, {x.data() + D * model.first_node[body], static_cast<std::size_t>(D * mesh.node_count())});
  DugIn deepest;
  for (Index const node : nodes)
    if (auto const found = hull.look(node, x.segment<D>(D * node), least); found.part > deepest.part)
      deepest = found;
  return deepest;
}

} // namespace

DugIn deepest_dug_in(dynamics::Model const& model, dynamics::Pair const& pair, Vector const& u,
                     double least) {
  if (pair.mortar || pair.self || pair.secondary.empty())
    return {};
  return model.dim() == 2 ? deepest_of<2>(model, pair, u, least) : deepest_of<3>(model, pair, u, least);
}

} // namespace stiction::scene
