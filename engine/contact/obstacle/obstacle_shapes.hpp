// Rigid shapes with a closed form of their gap: half-space, disc, sphere, cylinder and torus.
#pragma once
#include "contact/surface/foot.hpp"
#include "core/schema.hpp"

namespace stiction::contact {

/// Which side of a closed shape is touched: inside it is hollow, and gap and normal change sign.
enum class Side { outside, inside };

/// Half-space below the line or plane through `point` with outward `normal`.
struct RigidPlane {
  core::Numbers point;  ///< {x, y [, z]}, m; default the origin
  core::Numbers normal; ///< need not be of unit length; default the last axis
  [[nodiscard]] static core::Schema const& schema();
};

/// Disc of `radius` about `centre` in the plane; when axisymmetric a sphere, or a torus if off the axis.
struct RigidCircle {
  core::Numbers centre; ///< {x, y}, m; default the origin
  double radius = 0;    ///< m
  Side side = Side::outside;
  [[nodiscard]] static core::Schema const& schema();
};

/// Ball of `radius` about `centre`; in the plane its section, which is the disc.
struct RigidSphere {
  core::Numbers centre; ///< {x, y [, z]}, m; default the origin
  double radius = 0;    ///< m
  Side side = Side::outside;
  [[nodiscard]] static core::Schema const& schema();
};

/// Infinite circular cylinder in space.
struct RigidCylinder {
  core::Numbers centre; ///< a point of the axis, m; default the origin
  core::Numbers axis;   ///< of any length; default the last axis
  double radius = 0;    ///< m
  Side side = Side::outside;
  [[nodiscard]] static core::Schema const& schema();
};

/// Ring torus in space; when axisymmetric its section, a disc at x = major radius.
struct RigidTorus {
  core::Numbers centre;    ///< m; default the origin
  core::Numbers axis;      ///< of any length; default the last axis
  double major_radius = 0; ///< of the circle in the middle of the tube, m
  double minor_radius = 0; ///< of the tube, m
  Side side = Side::outside;
  [[nodiscard]] static core::Schema const& schema();
};

/// "" or what keeps the shape from use in a scene of `dim` dimensions.
[[nodiscard]] std::string unfit(RigidPlane const& plane, int dim, bool axisymmetric);
[[nodiscard]] std::string unfit(RigidCircle const& circle, int dim, bool axisymmetric);
[[nodiscard]] std::string unfit(RigidSphere const& sphere, int dim, bool axisymmetric);
[[nodiscard]] std::string unfit(RigidCylinder const& cylinder, int dim, bool axisymmetric);
[[nodiscard]] std::string unfit(RigidTorus const& torus, int dim, bool axisymmetric);

/// A complaint if `given` is neither left out nor of `dim` components; of a direction also if it vanishes.
[[nodiscard]] std::string wrong_count(char const* name, core::Numbers const& given, int dim);
[[nodiscard]] std::string wrong_direction(char const* name, core::Numbers const& given, int dim);
[[nodiscard]] std::string first_of(std::initializer_list<std::string> complaints);

/// The point that `given` names; the origin if it is empty.
template<int D> [[nodiscard]] Vec<D> point_or_origin(core::Numbers const& given) {
  return given.empty() ? Vec<D>::Zero() : Vec<D>(Eigen::Map<Vec<D> const>(given.data()));
}

/// The unit vector along `given`; the last axis if it is empty.
template<int D> [[nodiscard]] Vec<D> unit_or_last_axis(core::Numbers const& given) {
  return given.empty() ? Vec<D>::Unit(D - 1) : Vec<D>(Eigen::Map<Vec<D> const>(given.data()).normalized());
}

} // namespace stiction::contact
