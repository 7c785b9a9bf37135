// Closed outlines of straight sides for the tests of surfaces that may touch themselves.
#pragma once
#include "contact/helpers.hpp"

namespace stiction::test {

/// A closed outline of straight sides in equal facets of about `size`, the inside to the left.
inline Arc outline(std::vector<Vec2> const& corners, double size) {
  std::vector<Vec2> nodes;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    Vec2 const from = corners[c], to = corners[(c + 1) % corners.size()];
    int const parts = std::max(1, static_cast<int>(std::lround((to - from).norm() / size)));
    for (int i = 0; i < parts; ++i)
      nodes.emplace_back(from + (to - from) * i / parts);
  }
  Arc arc(static_cast<int>(nodes.size()), 0, 1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    arc.nodes.row(static_cast<Eigen::Index>(i)) = nodes[i].transpose();
  arc.chain.closed = true;
  return arc;
}

} // namespace stiction::test
