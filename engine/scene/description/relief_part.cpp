// Heights of a body's boundary, as scripts write them.
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;

core::Schema const& ReliefPart::schema() {
  static auto const made =
      Describe<ReliefPart>{
          "relief",
          "heights from which a plane boundary of a body stands back, as rigid.height_map does: rough, "
          "measured, or any; nodes below it follow by a share that falls to 0 at `depth`",
          ""}
          .text("set", &ReliefPart::set, Need::required,
                "the boundary: plane, and the body's outermost along its normal")
          .nested("surface", "surface", Need::required,
                  "its heights: where they are 0 it stays, where they are largest it stands back most")
          .numbers("size", &ReliefPart::size, "m", Need::required,
                   "extent of the map {x, y}, in the plane {x}")
          .numbers("points", &ReliefPart::points, "1", Need::required,
                   "how many heights {x, y}, in the plane {x}: each in the middle of its rectangle")
          .choice<Rim>("boundary", &ReliefPart::boundary, {"periodic", "free"}, Need::optional,
                       "periodic: repeated for ever; free: the map covers the boundary")
          .numbers("point", &ReliefPart::point, "m", Need::optional,
                   "where the middle of the map is, {x, y [, z]}; default the middle of the boundary")
          .numbers("along", &ReliefPart::along, "1", Need::optional,
                   "3D: direction of the map's x {x, y, z}; default the first axis across the normal, y the "
                   "second")
          .number("depth", &ReliefPart::depth, "m", core::non_negative, Need::optional,
                  "nodes deeper than that stay; 0: only those of the far side do")
          .build();
  return made;
}

void ReliefPart::read_nested(core::Reader& reader) {
  if (reader.has("surface"))
    surface = reader.child("surface", Need::required).alternative<halfspace::Shape>();
  else
    static_cast<void>(reader.at("surface", Need::required));
}

} // namespace stiction::scene
