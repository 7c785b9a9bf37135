// Half spaces and what is pressed onto them, as scripts write them.
#include "scene/description/check_path.hpp"
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;

core::Schema const& HalfSpacePart::schema() {
  static auto const made =
      Describe<HalfSpacePart>{
          "half_space",
          "a linear elastic half space below z = 0 (in plane strain y = 0), known at the points "
          "of its surface alone, whose middle is the origin; its set is \"surface\"",
          "Johnson 1985, 3"}
          .number("young", &HalfSpacePart::young, "Pa", core::positive, Need::required, "Young's modulus")
          .number("poisson", &HalfSpacePart::poisson, "1", {-1, 0.5, true, false}, Need::required,
                  "Poisson's ratio; 0.5 is incompressible")
          .numbers("size", &HalfSpacePart::size, "m", Need::required,
                   "extent of its points {x, y}, in plane strain {x}")
          .numbers("points", &HalfSpacePart::points, "1", Need::required,
                   "how many {x, y}, in plane strain {x}; fastest as products of 2, 3 and 5")
          .choice(
              "boundary", &HalfSpacePart::boundary, {"periodic", "free"}, Need::optional,
              "periodic: repeated for ever, displacements are those about the mean of the surface; free: "
              "nothing acts outside the points, displacements are those against points far away (in plane "
              "strain as far as `size`)")
          .number("depth", &HalfSpacePart::depth, "m", core::non_negative, Need::optional,
                  "periodic: so much of the body, and of an elastic counterpart, gives under the mean "
                  "traction too, "
                  "laterally confined; 0: the mean of the surfaces stays")
          .build();
  return made;
}

core::Schema const& HeightMapPart::schema() {
  static auto const made =
      Describe<HeightMapPart>{
          "height_map",
          "heights that are pressed onto a half space and moved along it; they stay over the "
          "points where they start",
          ""}
          .nested("surface", "surface", Need::required, "its heights over the half space at the start")
          .number("young", &HeightMapPart::young, "Pa", core::non_negative, Need::optional,
                  "Young's modulus; 0: rigid")
          .number("poisson", &HeightMapPart::poisson, "1", {-1, 0.5, true, false}, Need::optional,
                  "Poisson's ratio, with `young`")
          .numbers("times", &HeightMapPart::times, "s", Need::optional, "times of the paths")
          .numbers("x", &HeightMapPart::x, "m", Need::optional, "displacement in x at those times")
          .numbers("y", &HeightMapPart::y, "m", Need::optional,
                   "displacement in y at those times; in plane strain along the normal")
          .numbers("z", &HeightMapPart::z, "m", Need::optional,
                   "displacement in z at those times (3D): below 0 it is pressed on")
          .numbers("force", &HeightMapPart::force, "N", Need::optional,
                   "force that presses at those times (per metre of depth in plane strain), in place of the "
                   "displacement along the normal")
          .build();
  return made;
}

void HeightMapPart::read_nested(core::Reader& reader) {
  if (reader.has("surface"))
    surface = reader.child("surface", Need::required).alternative<halfspace::Shape>();
  else
    static_cast<void>(reader.at("surface", Need::required));
  check_paths(reader, *this);
  check_path(reader, times, force, "force");
  if (reader.has("young") != reader.has("poisson"))
    reader.complain_at(reader.has("young") ? "young" : "poisson",
                       "goes with the other of `young` and `poisson`; give both, or none for a rigid one");
}

} // namespace stiction::scene
