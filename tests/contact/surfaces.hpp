// Sheets, balls and cubes of facets for the tests of surfaces in space.
#pragma once
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "contact/node_to_segment/kinematics.hpp"

namespace stiction::test {

using contact::Foot;
using contact::Surface;
using contact::Vec3;

/// Nodes and facets with one free node behind them.
struct Shell {
  std::vector<Vec3> nodes;
  std::vector<mesh::Facet> facets;

  [[nodiscard]] Index free_node() const { return static_cast<Index>(nodes.size()); }
  [[nodiscard]] Surface surface(Vec3 const& direction = Vec3(1, 0, 0)) const {
    Matrix reference = Matrix::Zero(free_node() + 1, 3);
    for (Index i = 0; i < free_node(); ++i)
      reference.row(i) = nodes[ix(i)].transpose();
    return {facets, reference, direction};
  }
  /// All positions with the free node at `point`.
  [[nodiscard]] std::vector<double> with(Vec3 const& point) const {
    std::vector<double> x;
    for (auto const& node : nodes)
      x.insert(x.end(), {node.x(), node.y(), node.z()});
    x.insert(x.end(), {point.x(), point.y(), point.z()});
    return x;
  }
  Shell& move(std::function<Vec3(Vec3 const&)> const& map) {
    for (auto& node : nodes)
      node = map(node);
    return *this;
  }
  Shell& shake(double size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(-size, size);
    return move(
        [&](Vec3 const& v) { return Vec3(v + Vec3(uniform(random), uniform(random), uniform(random))); });
  }
  /// Adds a quadrilateral, or two triangles with alternating diagonals.
  void add(std::array<Index, 4> const& q, bool triangles, bool other_diagonal) {
    if (!triangles)
      facets.push_back({{q[0], q[1], q[2], q[3]}});
    else if (other_diagonal)
      facets.insert(facets.end(), {{{q[0], q[1], q[3]}}, {{q[1], q[2], q[3]}}});
    else
      facets.insert(facets.end(), {{{q[0], q[1], q[2]}}, {{q[0], q[2], q[3]}}});
  }
};

/// The unit square z = 0 of n x n cells, outward up.
inline Shell sheet(int n, bool triangles) {
  Shell shell;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i)
      shell.nodes.emplace_back(static_cast<double>(i) / n, static_cast<double>(j) / n, 0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      Index const a = j * (n + 1) + i;
      shell.add({a, a + 1, a + n + 2, a + n + 1}, triangles, (i + j) % 2 == 0);
    }
  return shell;
}

/// The cube [-1, 1]^3, every side n x n cells, outward.
inline Shell cube(int n, bool triangles) {
  Shell shell;
  std::map<std::array<int, 3>, Index> number;
  auto const node = [&](std::array<int, 3> const& at) {
    auto const [entry, fresh] = number.emplace(at, shell.free_node());
    if (fresh)
      shell.nodes.emplace_back(2.0 * at[0] / n - 1, 2.0 * at[1] / n - 1, 2.0 * at[2] / n - 1);
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int const end : {0, n})
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          auto const at = [&](int u, int v) {
            std::array<int, 3> corner{};
            corner[axis] = end;
            corner[(axis + 1) % 3] = end > 0 ? u : v; // the normal points along the axis or against it
            corner[(axis + 2) % 3] = end > 0 ? v : u;
            return node(corner);
          };
          shell.add({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, triangles, (i + j) % 2 == 0);
        }
  return shell;
}

/// A unit ball from a cube whose cells meet the centre at equal angles.
inline Shell ball(int n, bool triangles) {
  return cube(n, triangles).move([](Vec3 const& v) {
    Vec3 const w = (v * std::numbers::pi / 4).array().tan();
    return Vec3(w.normalized());
  });
}

/// A wavy warped sheet.
inline Shell waves(int n, bool triangles) {
  return sheet(n, triangles).shake(0.1 / n).move([](Vec3 const& v) {
    return Vec3(v + Vec3(0, 0, 0.05 * std::sin(5 * v.x()) * std::cos(4 * v.y())));
  });
}

/// Points on and around the surface, [count].
inline std::vector<Vec3> points_in(Vec3 const& low, Vec3 const& high, int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(low + (high - low).cwiseProduct(Vec3(part(random), part(random), part(random))));
  return points;
}

inline contact::Mat<3> turned(Vec3 const& axis_angle) {
  return Eigen::AngleAxisd(axis_angle.norm(), axis_angle.normalized()).toRotationMatrix();
}

} // namespace stiction::test
