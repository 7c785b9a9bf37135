// The crossing of a moving point and a moving panel: roots of a polynomial in time.
#include "contact/tunnelling/tunnelling.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace stiction::contact {

namespace {

constexpr int pieces = 16;     // of the step, in each of which a crossing is looked for
constexpr int bisections = 40; // to the time of a crossing
constexpr double on_surface =
    0.1; // of a panel's size: as deep as a point may be behind the chord of a curved surface
constexpr double border_width = 1e-9; // of a panel: how far beyond its border it still holds
constexpr double slack = 1e-9;        // of a way: what rounding may take from its half

template<int D> Vec<D> at(std::span<double const> x, Index node) {
  return Eigen::Map<Vec<D> const>(x.data() + D * node);
}

/// Where a node is a part t of the step, m.
template<int D> Vec<D> position(StepPath const& path, Index node, double t) {
  return (1 - t) * at<D>(path.from, node) + t * at<D>(path.to, node);
}

/// A panel and a node part of the way through the step.
template<int D> struct Moment {
  std::array<Vec<D>, D> corner;
  Vec<D> point;
  Moment(Panel<D> const& panel, Index node, StepPath const& path, double t)
      : point(position<D>(path, node, t)) {
    for (int k = 0; k < D; ++k)
      corner[ix(k)] = position<D>(path, panel[ix(k)], t);
  }
  /// How deep the point is behind the panel, times its length or twice its area.
  [[nodiscard]] double depth() const {
    Vec<D> const arm = point - corner[0], side = corner[1] - corner[0];
    if constexpr (D == 2)
      return side.x() * arm.y() - side.y() * arm.x() - on_surface * side.squaredNorm();
    else {
      Vec<D> const normal = side.cross(corner[2] - corner[0]);
      double const area = normal.norm();
      return -normal.dot(arm) - on_surface * area * std::sqrt(area);
    }
  }
  /// How far the point is behind the panel's plane, m.
  [[nodiscard]] double distance() const {
    Vec<D> const arm = point - corner[0], side = corner[1] - corner[0];
    if constexpr (D == 2)
      return (side.x() * arm.y() - side.y() * arm.x()) / side.norm();
    else
      return -side.cross(corner[2] - corner[0]).normalized().dot(arm);
  }
  /// Whether the point, on the panel's plane, is between its corners.
  [[nodiscard]] bool over() const {
    Eigen::Matrix<double, D, D - 1> sides;
    for (int k = 1; k < D; ++k)
      sides.col(k - 1) = corner[ix(k)] - corner[0];
    Eigen::Matrix<double, D - 1, D - 1> const gram = sides.transpose() * sides;
    Eigen::Matrix<double, D - 1, 1> const part = gram.inverse() * (sides.transpose() * (point - corner[0]));
    return part.minCoeff() >= -border_width && part.sum() <= 1 + border_width;
  }
};

template<int D> double depth_at(Panel<D> const& panel, Index node, StepPath const& path, double t) {
  return Moment<D>(panel, node, path, t).depth();
}

/// What a panel sweeps over.
template<int D> Box<D> swept(Panel<D> const& panel, StepPath const& path) {
  Box<D> box{at<D>(path.from, panel[0]), at<D>(path.from, panel[0])};
  for (Index const corner : panel)
    for (auto const& x : {path.from, path.to}) {
      box.low = box.low.cwiseMin(at<D>(x, corner));
      box.high = box.high.cwiseMax(at<D>(x, corner));
    }
  return box;
}

/// Does it come this far behind the panel, m, after the crossing and before it leaves the panel's side?
template<int D>
bool comes_deep(Panel<D> const& panel, Index node, StepPath const& path, double from, double deep) {
  for (int piece = 0; piece <= pieces; ++piece) {
    Moment<D> const moment(panel, node, path, from + (1 - from) * piece / pieces);
    if (!moment.over())
      return false;
    if (moment.distance() > deep)
      return true;
  }
  return false;
}

template<int D> bool crosses(Panel<D> const& panel, Index node, StepPath const& path, double deep) {
  for (int piece = 0; piece < pieces; ++piece) {
    double outer = static_cast<double>(piece) / pieces, inner = static_cast<double>(piece + 1) / pieces;
    if (depth_at<D>(panel, node, path, outer) > 0 || !(depth_at<D>(panel, node, path, inner) > 0))
      continue;
    for (int k = 0; k < bisections; ++k) {
      double const middle = 0.5 * (outer + inner);
      (depth_at<D>(panel, node, path, middle) > 0 ? inner : outer) = middle;
    }
    if (Moment<D>(panel, node, path, inner).over() &&
        (deep <= 0 || comes_deep<D>(panel, node, path, inner, deep)))
      return true;
  }
  return false;
}

} // namespace

std::vector<Panel<2>> panels_of(Curve const& curve) {
  std::vector<Panel<2>> panels;
  for (auto const& segment : curve.segments())
    panels.push_back(segment.ends);
  return panels;
}

std::vector<Panel<3>> panels_of(Surface const& surface) {
  std::vector<Panel<3>> panels;
  for (auto const& facet : surface.facets())
    for (int k = 2; k < facet.count; ++k)
      panels.push_back({facet.nodes[0], facet.nodes[ix(k - 1)], facet.nodes[ix(k)]});
  return panels;
}

template<int D> std::vector<Panel<D>> panels_of(CellSurface const& surface) {
  std::vector<Panel<D>> panels;
  for (auto const& facet : surface.facets())
    for (int k = D - 1; k < facet.corners(); ++k) {
      Panel<D> panel{};
      panel[0] = facet.nodes[0];
      for (int c = 1; c < D; ++c)
        panel[ix(c)] = facet.nodes[ix(k - D + 1 + c)];
      panels.push_back(panel);
    }
  return panels;
}

template<int D>
SweptPanels<D>::SweptPanels(std::vector<Panel<D>> const& panels, StepPath path)
    : panels_(&panels), path_(path) {
  std::vector<Box<D>> boxes;
  boxes.reserve(panels.size());
  for (auto const& panel : panels)
    boxes.push_back(swept<D>(panel, path));
  grid_.build(boxes);
}

/// Where it crosses a panel, the node is on its own way and in the panel's box.
template<int D> bool SweptPanels<D>::passed_by(Index node, double deep, long* visits) const {
  Vec<D> const first = at<D>(path_.from, node), last = at<D>(path_.to, node);
  bool passed = false;
  long count = 0;
  grid_.near((first + last) / 2, (0.5 + slack) * (last - first).norm(), [&](int number) {
    auto const& panel = (*panels_)[ix(number)];
    ++count;
    passed =
        passed || (std::ranges::find(panel, node) == panel.end() && crosses<D>(panel, node, path_, deep));
  });
  if (visits != nullptr)
    *visits += count;
  return passed;
}

template std::vector<Panel<2>> panels_of<2>(CellSurface const&);
template std::vector<Panel<3>> panels_of<3>(CellSurface const&);
template class SweptPanels<2>;
template class SweptPanels<3>;

} // namespace stiction::contact
