// What the closed forms are called, and which scenes they fit.
#include "contact/obstacle/obstacle_shapes.hpp"

#include <algorithm>

namespace stiction::contact {

using core::Need;

namespace {

std::vector<std::string> sides() {
  return {"outside", "inside"};
}
constexpr auto side_meaning = "the side that is touched; \"inside\": the shape is hollow";

bool off_axis(core::Numbers const& centre) {
  return !centre.empty() && centre[0] != 0;
}

} // namespace

std::string wrong_count(char const* name, core::Numbers const& given, int dim) {
  if (given.empty() || given.size() == static_cast<std::size_t>(dim))
    return "";
  return std::string(name) + " has " + std::to_string(given.size()) + " components; give " +
         (dim == 2 ? "2, {x, y}" : "3, {x, y, z}");
}

std::string wrong_direction(char const* name, core::Numbers const& given, int dim) {
  if (auto const wrong = wrong_count(name, given, dim); !wrong.empty())
    return wrong;
  bool const zero = std::all_of(given.begin(), given.end(), [](double x) { return x == 0; });
  if (given.empty() || !zero)
    return "";
  return std::string(name) + " is " + core::to_string(given) + "; give a direction";
}

std::string first_of(std::initializer_list<std::string> complaints) {
  for (auto const& complaint : complaints)
    if (!complaint.empty())
      return complaint;
  return "";
}

core::Schema const& RigidPlane::schema() {
  static auto const made = core::Describe<RigidPlane>{"plane", "rigid half-space", ""}
                               .numbers("point", &RigidPlane::point, "m", Need::optional,
                                        "a point {x, y [, z]} of it; default the origin")
                               .numbers("normal", &RigidPlane::normal, "1", Need::optional,
                                        "outward normal {x, y [, z]}, of any length; default the last axis")
                               .build();
  return made;
}

core::Schema const& RigidCircle::schema() {
  static auto const made =
      core::Describe<RigidCircle>{"circle", "rigid disc (sphere or torus when axisymmetric)", ""}
          .numbers("centre", &RigidCircle::centre, "m", Need::optional,
                   "its centre {x, y}; default the origin")
          .number("radius", &RigidCircle::radius, "m", core::positive, Need::required, "its radius")
          .choice("side", &RigidCircle::side, sides(), Need::optional, side_meaning)
          .build();
  return made;
}

core::Schema const& RigidSphere::schema() {
  static auto const made =
      core::Describe<RigidSphere>{"sphere", "rigid ball; in the plane a disc", ""}
          .numbers("centre", &RigidSphere::centre, "m", Need::optional,
                   "its centre {x, y [, z]}; default the origin")
          .number("radius", &RigidSphere::radius, "m", core::positive, Need::required, "its radius")
          .choice("side", &RigidSphere::side, sides(), Need::optional, side_meaning)
          .build();
  return made;
}

core::Schema const& RigidCylinder::schema() {
  static auto const made =
      core::Describe<RigidCylinder>{"cylinder", "rigid circular cylinder without ends, in 3D", ""}
          .numbers("centre", &RigidCylinder::centre, "m", Need::optional,
                   "a point {x, y, z} of its axis; default the origin")
          .numbers("axis", &RigidCylinder::axis, "1", Need::optional,
                   "its axis {x, y, z}, of any length; default the last axis")
          .number("radius", &RigidCylinder::radius, "m", core::positive, Need::required, "its radius")
          .choice("side", &RigidCylinder::side, sides(), Need::optional, side_meaning)
          .build();
  return made;
}

core::Schema const& RigidTorus::schema() {
  static auto const made = core::Describe<RigidTorus>{"torus", "rigid ring, in 3D or axisymmetric", ""}
                               .numbers("centre", &RigidTorus::centre, "m", Need::optional,
                                        "its centre {x, y [, z]}; default the origin")
                               .numbers("axis", &RigidTorus::axis, "1", Need::optional,
                                        "axis of rotation {x, y [, z]}, of any length; default the last axis")
                               .number("major_radius", &RigidTorus::major_radius, "m", core::positive,
                                       Need::required, "radius of the circle in the middle of its tube")
                               .number("minor_radius", &RigidTorus::minor_radius, "m", core::positive,
                                       Need::required, "radius of its tube, less than major_radius")
                               .choice("side", &RigidTorus::side, sides(), Need::optional, side_meaning)
                               .build();
  return made;
}

std::string unfit(RigidPlane const& plane, int dim, bool /*axisymmetric*/) {
  return first_of({wrong_count("point", plane.point, dim), wrong_direction("normal", plane.normal, dim)});
}

std::string unfit(RigidCircle const& circle, int dim, bool /*axisymmetric*/) {
  if (dim == 3)
    return "a circle is a shape of the plane; in 3D use a sphere, cylinder or torus";
  return wrong_count("centre", circle.centre, dim);
}

std::string unfit(RigidSphere const& sphere, int dim, bool axisymmetric) {
  if (auto const wrong = wrong_count("centre", sphere.centre, dim); !wrong.empty())
    return wrong;
  if (axisymmetric && off_axis(sphere.centre))
    return "centre is " + core::to_string(sphere.centre) +
           ", off the axis of symmetry, where there is no sphere; give x = 0 or use a torus";
  return "";
}

std::string unfit(RigidCylinder const& cylinder, int dim, bool axisymmetric) {
  if (axisymmetric)
    return "a cylinder needs 3D; in axisymmetry use a plane whose normal is {1, 0} (outside) or {-1, 0} "
           "(inside)";
  if (dim == 2)
    return "a cylinder needs 3D; in the plane use a circle, its section";
  return first_of({wrong_count("centre", cylinder.centre, dim), wrong_direction("axis", cylinder.axis, dim)});
}

std::string unfit(RigidTorus const& torus, int dim, bool axisymmetric) {
  if (dim == 2 && !axisymmetric)
    return "a torus needs 3D or axisymmetry; in the plane use a circle";
  auto const wrong =
      first_of({wrong_count("centre", torus.centre, dim), wrong_direction("axis", torus.axis, dim)});
  if (!wrong.empty())
    return wrong;
  if (axisymmetric && off_axis(torus.centre))
    return "centre is " + core::to_string(torus.centre) + ", off the axis of symmetry; give x = 0";
  if (axisymmetric && off_axis(torus.axis))
    return "axis is " + core::to_string(torus.axis) + "; in axisymmetry it is {0, 1}";
  if (torus.minor_radius >= torus.major_radius)
    return "minor_radius is " + core::to_string(torus.minor_radius) +
           " m; give less than major_radius, which is " + core::to_string(torus.major_radius) + " m";
  return "";
}

} // namespace stiction::contact
