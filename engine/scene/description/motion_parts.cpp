// Schemas of prescribed displacements and of constraints, and their reading.
#include <algorithm>
#include <array>

#include "scene/description/check_path.hpp"
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;
using core::Reader;

std::string const& set_of(MotionPart const& motion) {
  return std::visit([](auto const& part) -> std::string const& { return part.set; }, motion);
}

core::Schema const& DrivePart::schema() {
  static auto const made =
      Describe<DrivePart>{"drive", "displacements of a set, straight lines between given times", ""}
          .text("set", &DrivePart::set, Need::required, "the nodes, \"body.set\"")
          .numbers("near", &DrivePart::near, "m", Need::optional, "only its node nearest to {x, y [, z]}")
          .numbers("times", &DrivePart::times, "s", Need::required, "times of the path, ascending")
          .numbers("x", &DrivePart::x, "m", Need::optional,
                   "displacement in x at those times; without it x is free")
          .numbers("y", &DrivePart::y, "m", Need::optional,
                   "displacement in y at those times; without it y is free")
          .numbers("z", &DrivePart::z, "m", Need::optional,
                   "displacement in z at those times; without it z is free (3D)")
          .build();
  return made;
}

void DrivePart::read_nested(Reader& reader) {
  check_paths(reader, *this);
}

core::Schema const& FixPart::schema() {
  static auto const made =
      Describe<FixPart>{"fix", "a set held where it is", ""}
          .text("set", &FixPart::set, Need::required, "the nodes, \"body.set\"")
          .numbers("near", &FixPart::near, "m", Need::optional, "only its node nearest to {x, y [, z]}")
          .flag("x", &FixPart::x, "hold x; where one of x, y, z is named true, those not named are free")
          .flag("y", &FixPart::y, "hold y")
          .flag("z", &FixPart::z, "hold z (3D)")
          .build();
  return made;
}

void FixPart::read_nested(Reader& reader) {
  std::array const flags{std::pair{"x", &x}, std::pair{"y", &y}, std::pair{"z", &z}};
  bool const picked =
      std::ranges::any_of(flags, [&](auto const& flag) { return reader.has(flag.first) && *flag.second; });
  for (auto const& [name, held] : flags)
    *held = *held && (!picked || reader.has(name));
}

core::Schema const& RollerPart::schema() {
  static auto const made =
      Describe<RollerPart>{"roller", "a set on rollers along an oblique plane, with what the plane bears", ""}
          .text("set", &RollerPart::set, Need::required, "the nodes, \"body.set\"")
          .numbers("normal", &RollerPart::normal, "1", Need::required,
                   "across the plane {x, y [, z]}: no node of the set moves along it")
          .build();
  return made;
}

core::Schema const& PeriodicPart::schema() {
  static auto const made =
      Describe<PeriodicPart>{"periodic",
                             "one cell of many alike: opposite sides move alike, and what one side bears the "
                             "other gives",
                             ""}
          .text("set", &PeriodicPart::set, Need::required, "the nodes of one side, \"body.set\"")
          .text("to", &PeriodicPart::to, Need::required,
                "those of the other, \"body.set\": the same nodes, shifted")
          .build();
  return made;
}

core::Schema const& TiedPart::schema() {
  static auto const made =
      Describe<TiedPart>{"tied",
                         "two surfaces of different meshes joined: the nodes of one follow the facets of the "
                         "other by mortar integrals, so that uniform stress and rigid motions pass exactly",
                         "Wohlmuth 2000; Popp et al. 2010; physics.md 4"}
          .text("set", &TiedPart::set, Need::required,
                "the surface that follows, \"body.set\": all of it lies on the other, no farther off than a "
                "tenth of a facet; the finer of the two, and the one that less is asked of elsewhere")
          .text("to", &TiedPart::to, Need::required, "the surface that it follows, \"body.set\"")
          .build();
  return made;
}

core::Schema const& TurnPart::schema() {
  static auto const made =
      Describe<TurnPart>{
          "turn",
          "a set that turns as a rigid body about an axis, which may be carried along; straight "
          "lines of the angle between given times",
          ""}
          .text("set", &TurnPart::set, Need::required, "the nodes, \"body.set\"")
          .numbers("near", &TurnPart::near, "m", Need::optional, "only its node nearest to {x, y [, z]}")
          .numbers("times", &TurnPart::times, "s", Need::required, "times of the paths, ascending")
          .numbers("angle", &TurnPart::angle, "rad", Need::required, "turn since the start at those times")
          .numbers("centre", &TurnPart::centre, "m", Need::required,
                   "point of the axis at the start {x, y [, z]}")
          .numbers("axis", &TurnPart::axis, "1", Need::optional, "its direction {x, y, z} in 3D; default z")
          .numbers("x", &TurnPart::x, "m", Need::optional, "displacement of the axis in x at those times")
          .numbers("y", &TurnPart::y, "m", Need::optional, "displacement of the axis in y at those times")
          .numbers("z", &TurnPart::z, "m", Need::optional,
                   "displacement of the axis in z at those times (3D)")
          .build();
  return made;
}

void TurnPart::read_nested(Reader& reader) {
  check_path(reader, times, angle, "angle");
  check_paths(reader, *this);
}

} // namespace stiction::scene
