// Shapes of counterparts as heights over the plane: of their surface off the half space, where they start.
#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "core/reader.hpp"
#include "halfspace/measured.hpp"
#include "halfspace/rough.hpp"

namespace stiction::halfspace {

/// Where a shape lies; missing coordinates are 0.
[[nodiscard]] inline double coordinate(core::Numbers const& place, std::size_t k) {
  return k < place.size() ? place[k] : 0;
}

struct Sphere {
  double radius = 0;  ///< m
  core::Numbers apex; ///< m
  [[nodiscard]] double height(double x, double y) const {
    double const u = x - coordinate(apex, 0), v = y - coordinate(apex, 1);
    return (u * u + v * v) / (2 * radius);
  }
  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Sphere>{"sphere", "a sphere near its apex, as a paraboloid", "Hertz 1882"}
            .number("radius", &Sphere::radius, "m", core::positive, core::Need::required, "of curvature")
            .numbers("apex", &Sphere::apex, "m", core::Need::optional,
                     "where it is lowest {x, y}; default the origin")
            .build();
    return made;
  }
};

struct Cylinder {
  double radius = 0; ///< m
  double apex = 0;   ///< m
  [[nodiscard]] double height(double x, double) const { return (x - apex) * (x - apex) / (2 * radius); }
  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Cylinder>{"cylinder", "a cylinder along y near its apex, as a parabola", "Hertz 1882"}
            .number("radius", &Cylinder::radius, "m", core::positive, core::Need::required, "of curvature")
            .number("apex", &Cylinder::apex, "m", core::any_number, core::Need::optional,
                    "x where it is lowest")
            .build();
    return made;
  }
};

struct Punch {
  double radius = 0;    ///< m
  double clearance = 0; ///< m
  core::Numbers centre; ///< m
  [[nodiscard]] double height(double x, double y) const {
    return std::hypot(x - coordinate(centre, 0), y - coordinate(centre, 1)) <= radius ? 0 : clearance;
  }
  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Punch>{"punch", "a flat punch: round in space, a strip in plane strain",
                              "Johnson 1985, 3.4"}
            .number("radius", &Punch::radius, "m", core::positive, core::Need::required, "or half width")
            .number("clearance", &Punch::clearance, "m", core::positive, core::Need::required,
                    "height of all that lies outside it")
            .numbers("centre", &Punch::centre, "m", core::Need::optional, "{x, y}; default the origin")
            .build();
    return made;
  }
};

struct Wave {
  double amplitude = 0;      ///< m
  core::Numbers wavelengths; ///< m
  [[nodiscard]] double height(double x, double y) const {
    double sum = 0;
    for (std::size_t k = 0; k < std::min<std::size_t>(2, wavelengths.size()); ++k)
      if (wavelengths[k] > 0)
        sum += 1 - std::cos(2 * std::numbers::pi * (k == 0 ? x : y) / wavelengths[k]);
    return amplitude * sum;
  }
  /// What the grid cannot hold.
  [[nodiscard]] core::Complaints check(Grid const& grid) const;
  /// Where it has a step when the grid is repeated.
  [[nodiscard]] core::Complaints check_period(Grid const& grid) const;
  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Wave>{"wave", "cosines along x, along y, or the sum of both, lowest at the origin",
                             "Westergaard 1939; Johnson 1985, 13"}
            .number("amplitude", &Wave::amplitude, "m", core::positive, core::Need::required,
                    "half of what crests and troughs along one axis differ by")
            .numbers("wavelengths", &Wave::wavelengths, "m", core::Need::required,
                     "along {x} or {x, y}; 0: constant along it")
            .build();
    return made;
  }
};

struct Map {
  core::Numbers heights; ///< of `scale`, [points], along x first
  double scale = 1;      ///< m
  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Map>{"map", "any heights at the points of the surface", ""}
            .numbers("heights", &Map::heights, "1", core::Need::required,
                     "at every point, along x first: a list of numbers, or a function of x and y in m")
            .number("scale", &Map::scale, "m", core::positive, core::Need::optional, "of the numbers")
            .build();
    return made;
  }
};

using Shape = std::variant<Sphere, Cylinder, Punch, Wave, Map, Rough, Measured>;

/// At all points, m; of a map of another size nothing.
[[nodiscard]] inline Vector heights(Shape const& shape, Grid const& grid) {
  if (auto const* rough = std::get_if<Rough>(&shape))
    return heights(*rough, grid);
  if (auto const* measured = std::get_if<Measured>(&shape))
    return heights(*measured, grid);
  Vector all(grid.size());
  if (auto const* map = std::get_if<Map>(&shape)) {
    if (map->heights.size() != ix(grid.size()))
      return {};
    return map->scale * Eigen::Map<Vector const>(map->heights.data(), grid.size());
  }
  std::visit(
      [&](auto const& one) {
        if constexpr (requires { one.height(0, 0); })
          for (Index i = 0; i < grid.size(); ++i)
            all[i] = one.height(grid.x(i), grid.y(i));
      },
      shape);
  return all;
}

} // namespace stiction::halfspace
