// Reading and checking what places a field figure in space.
#include "spec/solid_spec.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "spec/obstacle_spec.hpp"

namespace stiction::postproc {

namespace {

using core::Need;
using core::Reader;

constexpr char const* axis_words[] = {"x", "y", "z"};

std::optional<ViewSpec> view_at(Reader& reader) {
  auto view = reader.child("view", Need::optional);
  if (!reader.has("view"))
    return {};
  ViewSpec result;
  result.azimuth = view.number_or("azimuth", "1", {-360, 360}, result.azimuth);
  result.elevation = view.number_or("elevation", "1", {-90, 90}, result.elevation);
  view.finish();
  return result;
}

std::vector<int> mirror_at(Reader& reader, bool solid) {
  auto const& given = reader.at("mirror", Need::optional);
  if (!reader.has("mirror"))
    return {};
  std::string const wanted = solid ? "\"x\", \"y\", \"z\"" : "\"x\", \"y\" (\"z\" needs a \"view\")";
  std::vector<int> axes;
  for (auto const& element : given.list() == nullptr ? core::List{core::Input{}} : *given.list()) {
    auto const* word = element.text();
    auto const* const found =
        word == nullptr ? std::end(axis_words) : std::find(axis_words, axis_words + (solid ? 3 : 2), *word);
    auto const axis = static_cast<int>(found - axis_words);
    if (axis >= (solid ? 3 : 2) || std::count(axes.begin(), axes.end(), axis) > 0) {
      reader.complain_at("mirror", fmt::format("wants a list of {}, each once", wanted));
      return {};
    }
    axes.push_back(axis);
  }
  return axes;
}

void read_crop(Reader& reader, double metres, FieldSpec& field) {
  auto crop = reader.child("crop", Need::optional);
  if (!reader.has("crop"))
    return;
  if (!field.view)
    reader.complain_at("crop", "cuts a solid, so it needs a \"view\"; a plane mesh takes \"window\"");
  for (std::size_t i = 0; i < 6; ++i) {
    std::string const key = std::string(axis_words[i / 2]) + (i % 2 == 0 ? "min" : "max");
    double const side = crop.number_or(key, "1", core::any_number, 0);
    if (crop.has(key))
      field.crop[i] = metres * side;
    bool const empty =
        i % 2 == 1 && field.crop[i] && field.crop[i - 1] && *field.crop[i] <= *field.crop[i - 1];
    if (empty)
      crop.complain_at(key, fmt::format("is {:g}; it must be greater than {}min", side, axis_words[i / 2]));
  }
  crop.finish();
}

std::optional<SphereSpec> sphere_at(Reader& reader, double metres, bool solid) {
  auto given = reader.child("sphere", Need::optional);
  if (!reader.has("sphere"))
    return {};
  SphereSpec sphere;
  auto const centre = given.numbers("centre", "1");
  bool const good = centre.size() == 3 || (centre.size() == 2 && !solid);
  if (given.has("centre") && !good)
    given.complain_at("centre", fmt::format("has {} numbers; {} are wanted", centre.size(),
                                            solid ? "[x, y, z]" : "[x, y]"));
  for (std::size_t i = 0; good && i < centre.size(); ++i)
    sphere.centre[i] = metres * centre[i];
  sphere.radius = metres * given.number("radius", "1", core::positive);
  if (auto path = given.child("path", Need::optional); given.has("path"))
    sphere.path = read_path(path, metres);
  given.finish();
  return sphere;
}

} // namespace

void read_solid(Reader& reader, double metres, FieldSpec& field) {
  field.view = view_at(reader);
  field.mirror = mirror_at(reader, field.view.has_value());
  read_crop(reader, metres, field);
  field.sphere = sphere_at(reader, metres, field.view.has_value());
  field.obstacles = read_obstacles(reader, metres, field.view.has_value());
}

} // namespace stiction::postproc
