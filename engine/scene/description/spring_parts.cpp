// Schema of springs, and its reading.
#include <algorithm>

#include "scene/description/check_path.hpp"
#include "scene/description/parts.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;
using core::Reader;

namespace {

/// Is a number not given, or given as 0?
bool nothing(Reader& reader, char const* key) {
  auto const* given = reader.at(key, Need::optional).quantity();
  return !reader.has(key) || (given != nullptr && given->value == 0);
}

} // namespace

core::Schema const& SpringPart::schema() {
  static auto const made =
      Describe<SpringPart>{
          "spring",
          "a linear spring with a dashpot beside it, between the mean places of two sets, an obstacle, or a "
          "place that may move; free of force at the start unless `rest` is given",
          "physics.md 4"}
          .text(
              "from", &SpringPart::from, Need::required,
              "one end: the mean of a set's nodes, \"body.set\" (of a surface by area, else by mass), or the "
              "pivot of an obstacle with a mass")
          .text("to", &SpringPart::to, Need::optional,
                "other end: a set, or an obstacle's pivot; none: a place, where `from` is at the start or "
                "`anchor`")
          .numbers("anchor", &SpringPart::anchor, "m", Need::optional,
                   "the place {x, y [, z]} that is the other end at the start")
          .numbers("times", &SpringPart::times, "s", Need::optional, "times of that place's paths, ascending")
          .numbers("x", &SpringPart::x, "m", Need::optional, "its displacement in x at those times")
          .numbers("y", &SpringPart::y, "m", Need::optional, "its displacement in y at those times")
          .numbers("z", &SpringPart::z, "m", Need::optional, "its displacement in z at those times (3D)")
          .number("stiffness", &SpringPart::stiffness, "N/m", core::non_negative, Need::optional,
                  "force per elongation; in plane strain per metre of depth, about an axis around the whole "
                  "circle")
          .number("damping", &SpringPart::damping, "N s/m", core::non_negative, Need::optional,
                  "of the dashpot: force per rate of elongation; wants a scheme with inertia")
          .choice(
              "along", &SpringPart::along, {"axes", "line"}, Need::optional,
              "axes: it resists displacements along x, y [, z], each by itself, whatever its length; line: "
              "it pulls along the line between its ends, which turns with them")
          .numbers("axes", &SpringPart::axes, "1", Need::optional,
                   "parts of stiffness and damping along x, y [, z]; {1, 0} acts along x alone. Default 1 "
                   "each; about an axis {0, 1} unless it is spread")
          .numbers(
              "direction", &SpringPart::direction, "1", Need::optional,
              "instead: it acts along this fixed direction {x, y [, z]} alone, on the distance between its "
              "ends along it")
          .number("rest", &SpringPart::rest, "m", core::any_number, Need::optional,
                  "distance between its ends, along the line or the direction, at which it is free of force; "
                  "default that of the start")
          .flag("spread", &SpringPart::spread,
                "each node of `from` has its share of the spring, from where it is: a bedding")
          .build();
  return made;
}

void SpringPart::read_nested(Reader& reader) {
  check_paths(reader, *this);
  rests = reader.has("rest");
  bool const moves =
      std::ranges::any_of(std::array{&x, &y, &z}, [](auto const* path) { return !path->empty(); });
  if (!to.empty() && (moves || !anchor.empty()))
    reader.complain_at(moves ? "times" : "anchor",
                       "is of a place, but `to` names the other end; leave one of them out");
  else if (!times.empty() && !moves)
    reader.complain_at("times", "has no values beside it; give x, y or z, or leave it out");
  if (nothing(reader, "stiffness") && nothing(reader, "damping"))
    reader.complain_at("", "neither pulls nor damps; give it a stiffness or a damping above 0");
  if (along == dynamics::SpringAlong::line && !direction.empty())
    reader.complain_at("direction", "is a fixed one, but along is \"line\"; leave one of them out");
  bool const of_axes = along == dynamics::SpringAlong::axes && direction.empty();
  if (!of_axes && !axes.empty())
    reader.complain_at("axes", "is for springs along the axes; leave it out, or `along` and `direction`");
  if (rests && (of_axes || spread))
    reader.complain_at("rest",
                       "is for a spring along a line or a direction that is not spread; leave it out");
  if (spread && along == dynamics::SpringAlong::line)
    reader.complain_at("spread", "is for springs along the axes or a direction; leave it or `along` out");
}

} // namespace stiction::scene
