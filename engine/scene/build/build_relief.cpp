// A body's boundary with heights: its nodes and those below it are moved along the boundary's normal.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "mesh/topology/quality.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

constexpr double flat = 1e-6;     // of the boundary's extent: meshes from files are in single precision
constexpr double rounding = 1e-9; // of the map's extent

/// The plane that a boundary lies in.
struct Plane {
  Vec3 normal = Vec3::Zero(); ///< outward; 0: the boundary closes around
  Vec3 middle = Vec3::Zero(); ///< of its bounding box, m
  double level = 0;           ///< of the plane along the normal, m
  double off = 0;             ///< that nodes lie out of it, m
  double extent = 0;          ///< of the bounding box, m
};

Vec3 place(mesh::Mesh const& mesh, Index node) {
  Vec3 X = Vec3::Zero();
  X.head(mesh.dim) = mesh.nodes.row(node).transpose();
  return X;
}

std::size_t corners_of(mesh::Mesh const& mesh, mesh::Facet const& facet) {
  auto const nodes = facet.nodes.size();
  return mesh.dim == 2 ? 2 : nodes == 3 || nodes == 6 ? 3 : 4;
}

/// Along the outward normal, its area long (its length in the plane).
Vec3 area_of(mesh::Mesh const& mesh, mesh::Facet const& facet) {
  auto const at = [&](std::size_t k) { return place(mesh, facet.nodes[k]); };
  if (mesh.dim == 2)
    return (at(1) - at(0)).cross(Vec3::UnitZ());
  std::size_t const last = corners_of(mesh, facet) - 1;
  return 0.5 * (at(last - 1) - at(0)).cross(at(last) - at(1));
}

Plane plane_of(mesh::Mesh const& mesh, mesh::Set const& set) {
  Plane plane;
  Vec3 low = place(mesh, set.nodes.front()), high = low, area = Vec3::Zero();
  double all = 0;
  for (Index const node : set.nodes) {
    low = low.cwiseMin(place(mesh, node));
    high = high.cwiseMax(place(mesh, node));
  }
  for (auto const& facet : set.facets) {
    area += area_of(mesh, facet);
    all += area_of(mesh, facet).norm();
  }
  plane.middle = 0.5 * (low + high);
  plane.extent = (high - low).norm();
  if (!(area.norm() > flat * all))
    return plane;
  plane.normal = area.normalized();
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (Index const node : set.nodes) {
    double const level = plane.normal.dot(place(mesh, node));
    least = std::min(least, level);
    most = std::max(most, level);
  }
  plane.level = 0.5 * (least + most);
  plane.off = most - least;
  return plane;
}

std::vector<std::string> boundaries_of(mesh::Mesh const& mesh) {
  std::vector<std::string> names;
  for (auto const& [name, set] : mesh.sets)
    if (!set.facets.empty())
      names.push_back(name);
  return names;
}

/// Least and largest distance of nodes below the plane, m.
std::pair<double, double> depths(mesh::Mesh const& mesh, Plane const& plane) {
  Vector const below = plane.level - (mesh.nodes * plane.normal.head(mesh.dim)).array();
  return {below.minCoeff(), below.maxCoeff()};
}

/// How far the boundary reaches past a map that is not repeated, in words; "" where it is covered.
std::string past_rim(contact::RigidHeights const& map, mesh::Mesh const& mesh, mesh::Set const& set) {
  if (map.boundary == contact::RigidHeights::Rim::periodic)
    return "";
  for (std::size_t k = 0; k < map.size.size(); ++k) {
    double low = 0, high = map.size[k];
    for (Index const node : set.nodes) {
      double const at = map.prepared->local(place(mesh, node))[static_cast<Eigen::Index>(k)];
      low = std::min(low, at);
      high = std::max(high, at);
    }
    double const past = std::max(-low, high - map.size[k]);
    if (past > rounding * map.size[k])
      return fmt::format("has {:g} m along the map's {}, and the boundary goes on for {:g} m past it; give a "
                         "map that covers it, or boundary = \"periodic\"",
                         map.size[k], "xy"[k], past);
  }
  return "";
}

/// By which the surface stands out at a place, m: that of the rim past it.
double outward(contact::RigidHeights const& map, Vec3 const& X) {
  Vec3 at = map.prepared->local(X);
  if (map.boundary == contact::RigidHeights::Rim::free)
    for (std::size_t k = 0; k < map.size.size(); ++k) {
      auto& one = at[static_cast<Eigen::Index>(k)];
      one = std::clamp(one, 0.0, map.size[k]);
    }
  return map.prepared->field.at(at.x(), map.size.size() == 1 ? 0 : at.y()).h;
}

/// Distance of neighbouring nodes, where it is largest, m.
double spacing_of(mesh::Mesh const& mesh, mesh::Set const& set) {
  double most = 0;
  for (auto const& facet : set.facets) {
    std::size_t const corners = corners_of(mesh, facet), order = facet.nodes.size() > corners ? 2 : 1;
    for (std::size_t k = 0; k < corners; ++k)
      most =
          std::max(most, (place(mesh, facet.nodes[k]) - place(mesh, facet.nodes[(k + 1) % corners])).norm() /
                             static_cast<double>(order));
  }
  return most;
}

/// Nodes so far apart show all of a surface, m.
double finest_of(ReliefPart const& part) {
  double step = std::numeric_limits<double>::infinity();
  if (auto const* rough = std::get_if<halfspace::Rough>(&part.surface))
    return rough->shortest / show_wave;
  if (auto const* wave = std::get_if<halfspace::Wave>(&part.surface)) {
    for (double const length : wave->wavelengths)
      step = length > 0 ? std::min(step, length / show_wave) : step;
    return step;
  }
  if (std::holds_alternative<halfspace::Map>(part.surface) ||
      std::holds_alternative<halfspace::Measured>(part.surface))
    for (std::size_t k = 0; k < part.size.size(); ++k)
      step = std::min(step, part.size[k] / part.points[k]);
  return step;
}

/// What does not fit, and the key that says so; no words where all does.
struct Misfit {
  char const* key = "set";
  std::string words;
};

Misfit misfit_of(ReliefPart const& part, Plane const& plane, double above, double thickness) {
  if (plane.normal.isZero(0))
    return {"set", fmt::format("\"{}\" closes around, so that it has no one normal; give a plane boundary",
                               part.set)};
  if (plane.off > flat * plane.extent)
    return {"set",
            fmt::format("\"{}\" is not plane: along its mean normal its nodes lie up to {:g} m apart; give a "
                        "plane boundary",
                        part.set, plane.off)};
  if (above > flat * plane.extent)
    return {"set",
            fmt::format("the body goes on {:g} m beyond \"{}\" along its normal; give its outermost boundary",
                        above, part.set)};
  if (part.depth > thickness * (1 + rounding))
    return {
        "depth",
        fmt::format("is {:g} m, and the body is {:g} m thick below \"{}\"; give at most that, or leave it "
                    "out",
                    part.depth, thickness, part.set)};
  return {};
}

/// The relief's map in the plane of its boundary; yet without heights.
contact::RigidHeights map_in(Plane const& plane, ReliefPart const& part, int dim) {
  contact::RigidHeights map = part;
  map.normal.assign(plane.normal.data(), plane.normal.data() + dim);
  if (map.point.empty())
    map.point.assign(plane.middle.data(), plane.middle.data() + dim);
  return map;
}

Relief facts_of(ReliefPart const& part, contact::RigidHeights const& map, mesh::Mesh const& mesh,
                mesh::Set const& set) {
  Relief made{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              spacing_of(mesh, set), finest_of(part)};
  for (Index const node : set.nodes) {
    double const height = -outward(map, place(mesh, node));
    made.least = std::min(made.least, height);
    made.most = std::max(made.most, height);
  }
  return made;
}

void move_nodes(mesh::Mesh& mesh, Plane const& plane, contact::RigidHeights const& map, double depth) {
  for (Index node = 0; node < mesh.node_count(); ++node) {
    Vec3 const X = place(mesh, node);
    double const share = std::min(1.0, 1 - (plane.level - plane.normal.dot(X)) / depth);
    if (share > 0)
      mesh.nodes.row(node) += (share * outward(map, X) * plane.normal.head(mesh.dim)).transpose();
  }
}

} // namespace

/// Moves nodes of the mesh, or complains.
void Builder::take_relief(std::string const& name, ReliefPart const& part, mesh::Mesh& mesh) {
  Where const where{"bodies", name, "relief"};
  auto const at = [&](char const* key) { return Where{"bodies", name, "relief", key}; };
  if (scene_.part.kinematics == solid::Kinematics::axisymmetric)
    return complain(where, "heights are not the same all around an axis; give the profile as edges of a "
                           "mesh.gmsh, or set kinematics = \"three_dimensional\"");
  auto const found = mesh.sets.find(part.set);
  if (found == mesh.sets.end() || found->second.facets.empty())
    return unknown_name(at("set"), "boundary", part.set, boundaries_of(mesh));
  auto const& set = found->second;
  auto const plane = plane_of(mesh, set);
  auto const [least, thickness] = depths(mesh, plane);
  if (auto const misfit = misfit_of(part, plane, -least, thickness); !misfit.words.empty())
    return complain(at(misfit.key), misfit.words);
  auto map = map_in(plane, part, mesh.dim);
  if (auto const words = contact::unfit(map, mesh.dim, false); !words.empty())
    return complain(where, words);
  take_heights(at("surface"), part.surface, map);
  if (map.heights.empty())
    return;
  contact::prepare(map);
  if (auto const words = past_rim(map, mesh, set); !words.empty())
    return complain(at("size"), words);
  auto const made = facts_of(part, map, mesh, set);
  double const depth = part.depth > 0 ? part.depth : thickness;
  move_nodes(mesh, plane, map, depth);
  if (double const jacobian = mesh::least_jacobian(mesh); !(jacobian > mesh::degenerate))
    return complain(where,
                    fmt::format("its heights, from {:g} to {:g} m, fold cells over within a depth of {:g} m: "
                                "the smallest scaled Jacobian is {:.3g}, it must be > {:g}; give a taller "
                                "body or a larger depth, a finer mesh, or smaller heights",
                                made.least, made.most, depth, jacobian, mesh::degenerate));
  scene_.reliefs.emplace(name, made);
}

} // namespace stiction::scene
