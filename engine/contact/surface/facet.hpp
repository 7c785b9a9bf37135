// Linear facets in space: shape functions, sides and area, for plain numbers and for numbers with
// derivatives.
#pragma once
#include <Eigen/Geometry>
#include <array>
#include <numbers>

#include "contact/surface/foot.hpp"

namespace stiction::contact {

/// A triangle (xi, eta >= 0, xi + eta <= 1) or a quadrilateral (-1 <= xi, eta <= 1), the body behind it.
struct Facet {
  std::array<Index, 4> nodes{};
  int count = 0;
  std::array<int, 4> neighbour{-1, -1, -1, -1}; ///< across side k, from node k to node k + 1; -1: border
  std::array<int, 4> across{};                  ///< which side of the neighbour that is
  std::array<bool, 4> sharp{};                  ///< the surface has an edge there
  std::array<int, 4> corner{};                  ///< which nodal normal each node has on this side of edges
  std::array<Vec3, 4> reference{};              ///< where the nodes lie in the reference, m
  Vec3 direction = Vec3::UnitX();               ///< of the first tangent, in the reference
};

/// Where neighbours turn by more the surface has an edge, rad.
inline constexpr double edge_angle = 40 * std::numbers::pi / 180;
/// Cosine between the tangents' direction and a facet's normal from which on another direction is taken.
inline constexpr double nearly_parallel = 0.98;
/// A foot this little beyond a side with a neighbour stays where it is.
inline constexpr double on_side = 1e-9;

/// A corner of a facet as one number.
[[nodiscard]] inline std::size_t slot(int facet, int corner) {
  return 4 * ix(facet) + ix(corner);
}

template<class T> using Vec3Of = Eigen::Matrix<T, 3, 1>;

/// Shape functions and their derivatives by xi and eta.
template<class T> struct Shape { std::array<T, 4> N, by_xi, by_eta; };

template<class T> [[nodiscard]] Shape<T> shape(int count, T const& xi, T const& eta) {
  if (count == 3)
    return {{T(1.0 - xi - eta), xi, eta, T(0.0)},
            {T(-1.0), T(1.0), T(0.0), T(0.0)},
            {T(-1.0), T(0.0), T(1.0), T(0.0)}};
  T const l = 0.5 * (1.0 - xi), r = 0.5 * (1.0 + xi), d = 0.5 * (1.0 - eta), u = 0.5 * (1.0 + eta);
  return {{T(l * d), T(r * d), T(r * u), T(l * u)},
          {T(-0.5 * d), T(0.5 * d), T(0.5 * u), T(-0.5 * u)},
          {T(-0.5 * l), T(-0.5 * r), T(0.5 * r), T(0.5 * l)}};
}

/// sum_k N_k v_k.
template<class T, class V>
[[nodiscard]] Vec3Of<T> combine(std::array<T, 4> const& N, std::array<V, 4> const& v, int count) {
  Vec3Of<T> sum;
  for (int c = 0; c < 3; ++c) {
    sum[c] = N[0] * v[0][c];
    for (int k = 1; k < count; ++k)
      sum[c] += N[ix(k)] * v[ix(k)][c];
  }
  return sum;
}

/// How far inside of side k: 0 on it, 1 on the opposite node or side, negative beyond it.
[[nodiscard]] inline double inside(int count, int side, Vec2 const& at) {
  if (count == 3)
    return side == 0 ? at.y() : side == 1 ? 1 - at.x() - at.y() : at.x();
  return 0.5 * (side == 0 ? 1 + at.y() : side == 1 ? 1 - at.x() : side == 2 ? 1 - at.y() : 1 + at.x());
}

/// Local coordinates of node k.
[[nodiscard]] inline Vec2 node_coordinates(int count, int k) {
  static constexpr double triangle[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  static constexpr double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  auto const* at = count == 3 ? triangle[k] : square[k];
  return {at[0], at[1]};
}

/// Local coordinates on side k, a part 0 <= part <= 1 of the way from its first to its last node.
[[nodiscard]] inline Vec2 side_coordinates(int count, int side, double part) {
  return (1 - part) * node_coordinates(count, side) + part * node_coordinates(count, (side + 1) % count);
}

/// Along side k, how far `at` is from its first to its last node.
[[nodiscard]] inline double side_part(int count, int side, Vec2 const& at) {
  Vec2 const from = node_coordinates(count, side), along = node_coordinates(count, (side + 1) % count) - from;
  return (at - from).dot(along) / along.squaredNorm();
}

/// Vector area, 1/2 sum_k x_k x x_{k+1}; also of a warped quadrilateral, m^2.
[[nodiscard]] inline Vec3 area_vector(std::array<Vec3, 4> const& x, int count) {
  return count == 3 ? Vec3(0.5 * (x[1] - x[0]).cross(x[2] - x[0]))
                    : Vec3(0.5 * (x[2] - x[0]).cross(x[3] - x[1]));
}

} // namespace stiction::contact
