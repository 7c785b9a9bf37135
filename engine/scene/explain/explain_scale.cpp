// A mesh file whose unit nobody gave, beside the lengths that the script gives with theirs.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr double far_in_size = 100; // times as large or as small as any other length

/// A length of the scene and what it is of.
struct KnownLength {
  double length = 0; ///< m
  std::string what;
};

double way_of(dynamics::Path const& path) {
  auto const [low, high] = std::ranges::minmax(path.values);
  return high - low;
}

double size_of(contact::Obstacle const& shape) {
  struct {
    double operator()(contact::RigidPlane const&) const { return 0; }
    double operator()(contact::RigidCircle const& circle) const { return circle.radius; }
    double operator()(contact::RigidSphere const& sphere) const { return sphere.radius; }
    double operator()(contact::RigidCylinder const& cylinder) const { return cylinder.radius; }
    double operator()(contact::RigidTorus const& torus) const { return torus.minor_radius; }
    double operator()(contact::RigidPolyline const& line) const {
      auto const [low, high] = std::ranges::minmax(line.points);
      return high - low;
    }
    double operator()(contact::RigidSurface const&) const { return 0; } // of a file with its own scale
    double operator()(contact::RigidHeights const& map) const { return std::ranges::max(map.size); }
  } size;
  return std::visit(size, shape);
}

bool unit_is_given(Facts const& all, std::string const& body) {
  auto const* file = std::get_if<mesh::MshFile>(&all.scene->part.bodies.at(body).mesh);
  return file == nullptr || file->scaled;
}

/// All but those of meshes whose unit is not given.
std::vector<KnownLength> known_lengths(Facts const& all) {
  std::vector<KnownLength> lengths;
  auto const add = [&](double length, std::string what) {
    if (length > 0)
      lengths.push_back({length, std::move(what)});
  };
  for (auto const& body : all.bodies)
    if (unit_is_given(all, body.body->name))
      add(body.extent(), "body " + body.body->name);
  for (auto const& [name, part] : all.scene->part.obstacles)
    add(size_of(part.shape), "obstacle " + name);
  for (auto const& motion : all.scene->model->motions)
    add(way_of(motion.path) + (motion.turn ? motion.turn->farthest() : 0.0), "the way of " + motion.set);
  for (auto const& rigid : all.scene->model->rigids)
    for (auto const& path : rigid.shift)
      add(way_of(path), "the way of an obstacle");
  for (auto const& spring : all.scene->model->springs)
    for (auto const& path : spring.to.shift)
      add(way_of(path), "the way of the end of spring " + spring.name);
  for (auto const& pair : all.pairs)
    add(pair.gap, "the gap of pair " + pair.pair->name);
  return lengths;
}

} // namespace

void unit_of_meshes(Facts const& all, std::vector<Warning>& warnings) {
  auto const lengths = known_lengths(all);
  if (lengths.empty())
    return;
  for (auto const& body : all.bodies) {
    double const extent = body.extent();
    auto const apart = [extent](KnownLength const& known) {
      return std::abs(std::log(known.length / extent));
    };
    auto const nearest = std::ranges::min_element(lengths, {}, apart);
    if (unit_is_given(all, body.body->name) || apart(*nearest) < std::log(far_in_size))
      continue;
    warnings.push_back(
        {fmt::format(
             "body {}: its mesh file is taken to be in metres and {} long, {:.2g} times {} ({}), the nearest "
             "of all other lengths",
             body.body->name, human(extent, "m"), extent / nearest->length, nearest->what,
             human(nearest->length, "m")),
         fmt::format("in stiction.mesh.msh_file of {}: scale = 1*mm if the file is in millimetres; scale = "
                     "1*m if it is "
                     "in metres",
                     body.body->name)});
  }
}

} // namespace stiction::scene
