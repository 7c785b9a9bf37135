// Arcs of nodes and vectors of positions for the tests of contact geometry.
#pragma once
#include <numbers>
#include <random>

#include "contact/node_to_segment/kinematics.hpp"

namespace stiction::test {

using contact::Chain;
using contact::Curve;
using contact::Foot;
using contact::Vec2;

/// Coordinates as one vector, [2 nodes].
inline std::vector<double> flat(Matrix const& nodes) {
  return {nodes.data(), nodes.data() + nodes.size()};
}

/// An arc of nodes on a circle about the origin, the disc to the left when walking; one free node behind
/// them.
struct Arc {
  Matrix nodes;
  Chain chain;
  double radius;
  Arc(int count, double from, double to, double R = 1) : nodes(count + 1, 2), radius(R) {
    for (int i = 0; i < count; ++i) {
      double const angle = from + (to - from) * i / (count - 1);
      nodes.row(i) << R * std::cos(angle), R * std::sin(angle);
      chain.nodes.push_back(i);
    }
    nodes.row(count).setZero();
  }
  [[nodiscard]] Index free_node() const { return static_cast<Index>(nodes.rows()) - 1; }
  [[nodiscard]] Curve curve(contact::Smoothing smoothing = contact::Smoothing::spline) const {
    return {{chain}, nodes, smoothing};
  }
  /// All positions with the free node at `point`.
  [[nodiscard]] std::vector<double> with(Vec2 const& point) const {
    auto x = flat(nodes);
    x[x.size() - 2] = point.x();
    x[x.size() - 1] = point.y();
    return x;
  }
};

/// The whole circle, closed.
inline Arc circle(int count) {
  double const turn = 2 * std::numbers::pi;
  Arc arc(count, 0, turn * (count - 1) / count);
  arc.chain.closed = true;
  return arc;
}

inline std::vector<double> shaken(std::vector<double> x, double size) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-size, size);
  for (auto& v : x)
    v += uniform(random);
  return x;
}

} // namespace stiction::test
