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
  Hull(std::vector<contact::Panel<D>> const& panels, std::span<double const> x) : panels_(panels), x_(x) {
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

  std::vector<contact::Panel<D>> const& panels_;
  std::span<double const> x_; ///< of the body's nodes, [D nodes], m
  contact::Grid<D> grid_;
  double largest_ = 0; ///< extent of a panel, m
};

} // namespace

DigSearch::DigSearch(dynamics::Model const& model, std::size_t pair) : model_(&model) {
  auto const& sides = model.pairs[pair];
  if (sides.mortar || sides.self || sides.secondary.empty())
    return;
  body_ = body_of(model, sides.secondary.front());
  nodes_ = primary_nodes(sides);
  if (nodes_.empty() || body_of(model, nodes_.front()) == body_) {
    nodes_.clear();
    return;
  }
  auto const& mesh = model.bodies[body_]->mesh;
  if (model.dim() == 2)
    plane_ = contact::panels_of<2>(mesh);
  else
    space_ = contact::panels_of<3>(mesh);
}

template<int D>
DugIn DigSearch::deepest_in(std::vector<contact::Panel<D>> const& hull, Vector const& u, double least) const {
  Vector const x = Eigen::Map<Vector const>(model_->reference.data(), model_->dofs()) + u;
  Index const first = D * model_->first_node[body_], last = D * model_->first_node[body_ + 1];
  Hull<D> const closed(hull, {x.data() + first, static_cast<std::size_t>(last - first)});
  DugIn deepest;
  for (Index const node : nodes_)
    if (auto const found = closed.look(node, x.segment<D>(D * node), least); found.part > deepest.part)
      deepest = found;
  return deepest;
}

DugIn DigSearch::deepest(Vector const& u, double least) const {
  if (nodes_.empty())
    return {};
  return model_->dim() == 2 ? deepest_in<2>(plane_, u, least) : deepest_in<3>(space_, u, least);
}

} // namespace stiction::scene
