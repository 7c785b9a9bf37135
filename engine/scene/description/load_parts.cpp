// Schemas of the loads that follow a surface, and their reading.
#include <fmt/format.h>

#include "scene/description/check_path.hpp"
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;
using core::Reader;

core::Schema const& PressurePart::schema() {
  static auto const made =
      Describe<PressurePart>{
          "pressure",
          "pressure on a surface as it is deformed, against its outward normal. Newton's matrix has the "
          "symmetric part of what it does, which is all of it where the surface is closed or its edge is "
          "held, on a plane of symmetry or on the axis; elsewhere steps take some iterations more, and do "
          "not converge, however small, where it acts on the free end of a slender body by several times "
          "what bending bears (E I / L^2 over the end's size). Thin or hardly compressible bodies want small "
          "steps, as under any load",
          "physics.md 4"}
          .text("set", &PressurePart::set, Need::required, "the surface, \"body.set\"")
          .numbers("times", &PressurePart::times, "s", Need::required, "times of the path, ascending")
          .numbers("pressure", &PressurePart::pressure, "Pa", Need::required,
                   "pressure at those times; below 0 it pulls")
          .flag("follows", &PressurePart::follows,
                "default true; false: dead, by area and normal of the undeformed surface")
          .build();
  return made;
}

void PressurePart::read_nested(Reader& reader) {
  check_path(reader, times, pressure, "pressure");
}

core::Schema const& GasPart::schema() {
  static auto const made =
      Describe<GasPart>{
          "gas",
          "gas in a cavity, of a given amount or of a given volume: past the largest pressure that a body "
          "bears steps go by volume",
          "physics.md 4"}
          .text("set", &GasPart::set, Need::required,
                "the cavity's whole wall, \"body.set\", closed or ending at planes of symmetry through "
                "`centre` that motions keep it in, at the axis, or where motions hold it: the rest is then a "
                "cone up to `centre`, which goes with those motions, about an axis discs across it, whatever "
                "`centre` is; they move all of the end as one rigid body")
          .numbers("times", &GasPart::times, "s", Need::required, "times of the path, ascending")
          .numbers("pressure", &GasPart::pressure, "Pa", Need::optional,
                   "the amount: pressure over `outside` that it would have in the cavity of the start")
          .number("outside", &GasPart::outside, "Pa", core::non_negative, Need::optional,
                  "pressure on the other side, as (p + outside) V^exponent stays")
          .number("exponent", &GasPart::exponent, "1", {0, 10, false, false}, Need::optional,
                  "polytropic: 1 keeps its temperature, 1.4 its heat as air, 0 its pressure")
          .numbers("volume", &GasPart::volume, "1", Need::optional,
                   "instead: volume of the cavity over that of the start; the pressure follows. Dynamic runs "
                   "want a scheme that damps what swings from step to step: theta = 0.6, or hht")
          .numbers("centre", &GasPart::centre, "m", Need::optional,
                   "point {x, y [, z]} of the planes of symmetry that the wall ends at, or tip of the cone "
                   "over its rim; "
                   "default the origin")
          .numbers(
              "seal", &GasPart::seal, "1", Need::optional,
              "normal {x, y [, z]} of a plane through `centre` that the wall's end stands on and may leave, "
              "as a suction cup does: the cavity reaches down to the plane along the normal, as by a skirt, "
              "whose pull the rim bears; under it gas goes out whenever its pressure is over that outside")
          .number("leaks_at", &GasPart::leaks_at, "m", core::non_negative, Need::optional,
                  "how far off the seal any of that end may be; farther off the gas leaks, for good, to the "
                  "pressure "
                  "outside")
          .build();
  return made;
}

void GasPart::read_nested(Reader& reader) {
  if (reader.has("pressure") == reader.has("volume"))
    return reader.complain_at("", "wants one of `pressure`, its amount, and `volume`, that of the cavity");
  check_path(reader, times, pressure, "pressure");
  check_path(reader, times, volume, "volume", 1);
  if (reader.has("seal") != reader.has("leaks_at") || (reader.has("seal") && reader.has("volume")))
    return reader.complain_at("seal", "wants `leaks_at`, and gas of a given amount, by `pressure`");
  for (char const* key : {"outside", "exponent"})
    if (reader.has("volume") && reader.has(key))
      reader.complain_at(key, "is of gas of a given amount, but `volume` is given; leave it out");
  for (double const one : pressure)
    if (one < -outside)
      return reader.complain_at(
          "pressure",
          fmt::format("has {:g} Pa over an `outside` of {:g} Pa, which is less than nothing; give the "
                      "pressure outside, of air 101325 Pa, or a load.pressure that pulls",
                      one, outside));
  for (double const one : volume)
    if (!(one > 0))
      return reader.complain_at("volume", fmt::format("has {:g}; a cavity's volume stays above 0", one));
  if (!volume.empty() && volume.front() != 1)
    reader.complain_at("volume", fmt::format("begins with {:g}; it is over that of the start: begin with 1",
                                             volume.front()));
}

core::Schema const& SurfaceStressPart::schema() {
  static auto const made =
      Describe<SurfaceStressPart>{"surface_stress",
                                  "surface stress of a soft solid or a liquid: energy per present area, "
                                  "which rounds edges and presses by "
                                  "twice the mean curvature",
                                  "physics.md 4"}
          .text("set", &SurfaceStressPart::set, Need::required, "the surface, \"body.set\"")
          .number(
              "gamma", &SurfaceStressPart::gamma, "N/m", core::positive, Need::required,
              "energy per area, J/m^2; it stretches with the surface without change. It acts from the start, "
              "at once: what it rounds by much flows there in steps under "
              "scheme.quasi_static{stabilisation = 0.03}, say; slender bodies, which bend easily, stay "
              "behind "
              "unless stabilisation (length / thickness)^2 is far below 1")
          .build();
  return made;
}

} // namespace stiction::scene
