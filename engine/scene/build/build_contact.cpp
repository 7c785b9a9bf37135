// Obstacles and contact pairs of a scene.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

#include "contact/surface/direction.hpp"
#include "mesh/topology/hats.hpp"
#include "mesh/topology/surface.hpp"
#include "mesh/topology/traction.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

using contact::Vec2;

namespace {

/// The centre of a shape, or the point that describes it; the origin if it has neither.
Vec3 middle(contact::Obstacle const& obstacle) {
  return std::visit(
      [](auto const& shape) {
        if constexpr (requires { shape.centre; })
          return vec(shape.centre);
        else if constexpr (requires { shape.point; })
          return vec(shape.point);
        else
          return Vec3(Vec3::Zero());
      },
      obstacle);
}

} // namespace

void Builder::add_obstacles() {
  for (auto const& [name, part] : scene_.part.obstacles)
    add_obstacle(name, part);
  settle();
}

void Builder::add_obstacle(std::string const& name, ObstaclePart const& part) {
  Where const where{"obstacles", name};
  auto& model = *scene_.model;
  bool const axisymmetric = model.kinematics == solid::Kinematics::axisymmetric;
  dynamics::RigidBody rigid;
  rigid.name = name;
  rigid.shape = part.shape;
  if (auto const words = contact::unfit(part.shape, model.dim(), axisymmetric); !words.empty())
    return complain({"obstacles", name, "shape"}, words);
  if (auto* map = std::get_if<contact::RigidHeights>(&rigid.shape)) {
    take_heights({"obstacles", name, "shape", "surface"}, *part.surface, *map);
    if (map->heights.empty())
      return;
  }
  try {
    contact::prepare(rigid.shape);
  } catch (core::InputError const& error) {
    for (auto const& complaint : error.complaints())
      complain({"obstacles", name, "shape"}, complaint.message());
  }
  check_no_z({"obstacles", name, "z"}, part.z);
  for (auto const& [key, numbers] :
       {std::pair{"pivot", &part.pivot}, {"velocity", &part.velocity}, {"force", &part.force}})
    check_size({"obstacles", name, key}, *numbers);
  check_spin({"obstacles", name, "spin"}, part.spin);
  if (!part.axis.empty() && (part.axis.size() != 3 || vec(part.axis).isZero(0)))
    complain({"obstacles", name, "axis"}, "wants three numbers, not all 0");
  else if (scene_.part.dim() == 2 && !part.axis.empty() && !vec(part.axis).head<2>().isZero(0))
    complain({"obstacles", name, "axis"}, "leaves the plane of a plane scene; leave it out");
  check_path_end({"obstacles", name, "times"}, part.times);
  rigid.pivot = part.pivot.empty() ? middle(part.shape) : vec(part.pivot);
  rigid.axis = part.axis.size() == 3 ? Vec3(vec(part.axis).normalized()) : Vec3::UnitZ();
  rigid.mass = part.mass;
  rigid.inertia = part.inertia;
  take_tensor(rigid, part);
  if (part.mass > 0 && rigid.inertia == 0 && !axisymmetric && !spin_of(part.spin).isZero(0))
    complain({"obstacles", name, "spin"},
             "turns a body that has no inertia, which does not turn; give it an inertia, or leave it out");
  rigid.force = vec(part.force);
  if (axisymmetric)
    check_symmetry(name, part);
  check_paths_alone(name, part);
  if (part.mass > 0) {
    if (!dynamics::weights(model.scheme).inertia)
      complain(where, "is free, but a quasi-static run has no inertia that could hold it; give it paths "
                      "instead of a mass, or use scheme.theta_xi");
    dynamics::add_unknowns(model, rigid, vec(part.velocity), spin_of(part.spin));
    drive_rigid(rigid, part);
    if (axisymmetric && part.x.empty())
      model.motions.push_back({{rigid.node}, 0, {}});
  } else {
    rigid.shift = {path(part.times, part.x), path(part.times, part.y), path(part.times, part.z)};
    rigid.angle = path(part.times, part.angle);
  }
  model.rigids.push_back(rigid);
}

/// A rigid body about an axis moves along it alone.
void Builder::check_symmetry(std::string const& name, ObstaclePart const& part) {
  auto const refuse = [&](bool given, char const* key, char const* remedy) {
    if (given)
      complain({"obstacles", name, key},
               fmt::format("would leave the symmetry of an axisymmetric scene; {}", remedy));
  };
  refuse(!part.angle.empty(), "angle", "leave it out");
  refuse(part.inertia > 0, "inertia", "leave it out, as nothing turns");
  refuse(!spin_of(part.spin).isZero(0), "spin", "leave it out");
  refuse(vec(part.velocity).x() != 0, "velocity", "give {0, y}");
  refuse(vec(part.force).x() != 0, "force", "give {0, y}");
}

/// Where a path leads a free body it has no say in how it moves there.
void Builder::check_paths_alone(std::string const& name, ObstaclePart const& part) {
  Vec3 const velocity = vec(part.velocity);
  std::array const paths{&part.x, &part.y, &part.z};
  for (int c = 0; c < 3; ++c)
    if (velocity[c] != 0 && !paths[ix(c)]->empty())
      complain({"obstacles", name, "velocity"},
               fmt::format("along {0} is what the path of {0} says; leave one of the two out", "xyz"[c]));
  if (!spin_of(part.spin).isZero(0) && !part.angle.empty())
    complain({"obstacles", name, "spin"}, "is what the path of angle says; leave one of the two out");
}

/// The inertia tensor of a free body in space.
void Builder::take_tensor(dynamics::RigidBody& rigid, ObstaclePart const& part) {
  auto const& J = part.inertia_tensor;
  if (J.empty())
    return;
  Where const where{"obstacles", rigid.name, "inertia_tensor"};
  auto const scheme = dynamics::weights(scene_.model->scheme);
  if (scene_.part.dim() != 3 || part.inertia > 0)
    return complain(where, "is for bodies in space, instead of inertia; leave one of them out");
  if (scheme.accelerations() || scheme.explicit_forces || scheme.velocity_level())
    return complain(where, "needs one of Jean's schemes at the position level; use scheme.theta_xi");
  if (J.size() != 3 && J.size() != 6)
    return complain(
        where, fmt::format("has {} numbers; give {{xx, yy, zz}} or {{xx, yy, zz, xy, yz, zx}}", J.size()));
  rigid.tensor.diagonal() << J[0], J[1], J[2];
  if (J.size() == 6) {
    rigid.tensor(0, 1) = rigid.tensor(1, 0) = J[3];
    rigid.tensor(1, 2) = rigid.tensor(2, 1) = J[4];
    rigid.tensor(0, 2) = rigid.tensor(2, 0) = J[5];
  }
  Vec3 const principal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(rigid.tensor).eigenvalues();
  if (!(principal[0] > 0) || principal[2] > (1 + 1e-9) * (principal[0] + principal[1]))
    return complain(
        where, fmt::format("has the principal moments {:.4g}, {:.4g}, {:.4g} kg m^2; those of a body are "
                           "positive, and none is larger than the sum of the others",
                           principal[0], principal[1], principal[2]));
  rigid.inertia = rigid.tensor.trace() / 3;
}

/// Paths of a body with a mass drive its unknowns.
void Builder::drive_rigid(dynamics::RigidBody const& rigid, ObstaclePart const& part) {
  auto& motions = scene_.model->motions;
  int component = 0;
  for (auto const* values : {&part.x, &part.y, &part.z}) {
    if (!values->empty())
      motions.push_back({{rigid.node}, component, path(part.times, *values)});
    ++component;
  }
  if (part.angle.empty())
    return;
  if (scene_.part.dim() == 3 || rigid.inertia == 0)
    complain({"obstacles", rigid.name, "angle"},
             "a path for the turn of a body with a mass is for plane scenes and wants an inertia");
  else
    motions.push_back({{rigid.node + 1}, 0, path(part.times, part.angle)});
}

/// The boundary set behind "body.set" with model node numbers.
std::optional<mesh::Set> Builder::surface(Where const& where, std::string const& name) {
  if (!resolve(where, name))
    return {};
  auto const dot = name.find('.');
  auto const& model = *scene_.model;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    if (model.bodies[b]->name != name.substr(0, dot))
      continue;
    mesh::Set set = model.bodies[b]->mesh.sets.find(name.substr(dot + 1))->second;
    try {
      mesh::check_surface(model.bodies[b]->mesh, set, name);
    } catch (core::InputError const& error) {
      for (auto const& complaint : error.complaints())
        complain(where, complaint.message());
      return {};
    }
    for (auto& node : set.nodes)
      node += model.first_node[b];
    for (auto& facet : set.facets)
      for (auto& node : facet.nodes)
        node += model.first_node[b];
    return set;
  }
  return {};
}

namespace {

Indices sorted(Indices nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// How many facets of one set are of the other too, whatever their nodes' order.
std::ptrdiff_t common_facets(mesh::Set const& one, mesh::Set const& other) {
  std::set<Indices> facets;
  for (auto const& facet : other.facets)
    facets.insert(sorted(facet.nodes));
  return std::ranges::count_if(one.facets,
                               [&](auto const& facet) { return facets.contains(sorted(facet.nodes)); });
}

} // namespace

void Builder::add_pairs() {
  for (auto const& [name, part] : scene_.part.pairs)
    try {
      add_pair(name, part);
    } catch (core::InputError const& error) {
      for (auto const& complaint : error.complaints())
        complain({"pairs", name}, complaint.message());
    }
  auto& pairs = scene_.model->pairs;
  for (std::size_t later = 0; later < pairs.size(); ++later)
    for (std::size_t first = 0; first < later; ++first)
      share_border(first, later);
}

/// Where two pairs of one counterpart border on each other, the nodes between them would be a point of both,
/// and W singular: they are of the pair that bonds, else of the first, with the areas of both where one is
/// as good as the other.
void Builder::share_border(std::size_t first, std::size_t later) {
  auto& pairs = scene_.model->pairs;
  auto const part_of = [&](std::size_t pair) -> PairPart const& {
    return scene_.part.pairs.at(scene_.pairs[pair]);
  };
  auto const points = [&](std::size_t pair) { return !pairs[pair].shared() && !pairs[pair].self; };
  if (!points(first) || !points(later) || part_of(first).primary != part_of(later).primary)
    return;
  bool const bonds = pairs[later].law.adhesion && !pairs[first].law.adhesion;
  auto &keeps = pairs[bonds ? later : first], &gives = pairs[bonds ? first : later];
  bool const alike = keeps.law.adhesion.has_value() == gives.law.adhesion.has_value();
  std::map<Index, std::size_t> own;
  for (std::size_t i = 0; i < keeps.secondary.size(); ++i)
    own.emplace(keeps.secondary[i], i);
  auto const common = [&](Index node) { return own.contains(node); };
  auto const count = std::ranges::count_if(gives.secondary, common);
  if (count == 0 || count == static_cast<std::ptrdiff_t>(gives.secondary.size()))
    return;
  auto const one = surface({"pairs"}, part_of(first).secondary),
             other = surface({"pairs"}, part_of(later).secondary);
  if (!one || !other || common_facets(*one, *other) > 0)
    return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < gives.secondary.size(); ++i)
    if (auto const taken = own.find(gives.secondary[i]); taken == own.end()) {
      gives.secondary[kept] = gives.secondary[i];
      gives.areas[kept++] = gives.areas[i];
    } else if (alike) {
      keeps.areas[taken->second] += gives.areas[i];
    }
  gives.secondary.resize(kept);
  gives.areas.resize(kept);
}

/// Two pairs of the same surfaces would both act: what bonds once would bond twice.
void Builder::refuse_again(std::string const& name, PairPart const& part) {
  for (auto const& [other, before] : scene_.part.pairs) {
    if (other == name)
      return; // the later one is told
    bool const same = before.secondary == part.secondary && before.primary == part.primary,
               back = before.secondary == part.primary && before.primary == part.secondary;
    if (same || (back && before.law.adhesion && part.law.adhesion))
      complain(
          {"pairs", name},
          fmt::format("is of the surfaces that pairs.{} is of, {} and {}{}: leave one of them out", other,
                      part.secondary, part.primary,
                      part.law.adhesion && before.law.adhesion ? ", and would hold them a second time" : ""));
  }
}

void Builder::add_pair(std::string const& name, PairPart const& part) {
  refuse_again(name, part);
  check_size({"pairs", name, "direction"}, part.direction);
  if (scene_.part.dim() == 2 && !part.direction.empty())
    complain({"pairs", name, "direction"},
             "is for scenes in space; a plane one has a single tangent: leave it out");
  if (part.discretisation == Discretisation::mortar && part.secondary == part.primary)
    return complain(
        {"pairs", name, "discretisation"},
        "mortar is for two surfaces, and this one touches itself; use \"node_to_segment\", or split "
        "the set into the two parts that meet");
  if (part.law.adhesion && dynamics::weights(scene_.model->scheme).restitution > 0)
    complain({"pairs", name, "adhesion"},
             "does not go with restitution > 0, which throws a closed point off its bond at every pull; set "
             "scheme.moreau_jean{restitution = 0} or leave the adhesion out");
  auto const secondary = surface({"pairs", name, "secondary"}, part.secondary);
  bool const rigid = scene_.part.obstacles.contains(part.primary);
  auto const primary = rigid ? std::nullopt : surface({"pairs", name, "primary"}, part.primary);
  if (!secondary || (!rigid && !primary))
    return;
  auto pair = secondary_side(name, part, *secondary);
  if (rigid) {
    dynamics::RigidSide side;
    while (scene_.model->rigids[side.body].name != part.primary)
      ++side.body;
    side.direction = first_tangent(part, *secondary);
    pair.primary = side;
  } else {
    add_primary(part, *primary, pair);
    if (!pair.self && !leave_out_shared(name, *secondary, *primary, pair))
      return;
  }
  pair.reach = std::max(pair.reach, part.law.range());
  scene_.model->pairs.push_back(std::move(pair));
  scene_.pairs.push_back(name);
}

dynamics::Pair Builder::secondary_side(std::string const& name, PairPart const& part, mesh::Set const& set) {
  dynamics::Pair pair{name, {}, {}, dynamics::RigidSide{}, part.law, part.reach};
  if (scene_.part.dim() == 2)
    share_edges(set, pair);
  else
    share_facets(part.secondary, set, pair);
  if (part.discretisation == Discretisation::mortar)
    average_facets(part, set, pair);
  else
    lend_areas(set, pair);
  return pair;
}

/// Nodes of both sides, as where a body's surface folds, would be counterparts of themselves, and are no
/// points. False where the two sides are the same facets, or where a node cannot be left out.
bool Builder::leave_out_shared(std::string const& name, mesh::Set const& secondary, mesh::Set const& primary,
                               dynamics::Pair& pair) {
  Indices const theirs = sorted(primary.nodes);
  auto const shared = [&](Index node) { return std::binary_search(theirs.begin(), theirs.end(), node); };
  if (std::ranges::none_of(secondary.nodes, shared))
    return true;
  auto const same = common_facets(secondary, primary);
  if (same > 0) {
    complain(
        {"pairs", name, "secondary"},
        fmt::format("has {} of the facets of the primary; name one set on both sides, which then touches "
                    "itself, or two sets without a facet in common",
                    same));
    return false;
  }
  if (pair.mortar)
    return true;
  if (!pair.means.empty()) {
    complain({"pairs", name, "secondary"},
             "shares nodes with the primary, and its points are means over nodes; set discretisation = "
             "\"mortar\" or leave the cells there out of one of the two sets");
    return false;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pair.secondary.size(); ++i)
    if (!shared(pair.secondary[i])) {
      pair.secondary[kept] = pair.secondary[i];
      pair.areas[kept++] = pair.areas[i];
    }
  pair.secondary.resize(kept);
  pair.areas.resize(kept);
  return true;
}

/// Where the shape functions of a facet leave its nodes without an area, points are means over nodes.
void Builder::lend_areas(mesh::Set const& set, dynamics::Pair& pair) const {
  auto const& reference = scene_.model->reference;
  bool const revolved = scene_.part.kinematics == solid::Kinematics::axisymmetric;
  if (std::all_of(set.facets.begin(), set.facets.end(),
                  [&](auto const& facet) { return mesh::shares_well(reference, facet, revolved); }))
    return;
  auto shares = mesh::surface_shares(reference, set, pair.secondary, revolved);
  pair.areas = std::move(shares.areas);
  pair.means = std::move(shares.means);
}

/// Points at the corner nodes alone, each with the area of its hat.
void Builder::average_facets(PairPart const& part, mesh::Set const& set, dynamics::Pair& pair) const {
  auto const& model = *scene_.model;
  pair.mortar.emplace(set.facets, model.reference, first_tangent(part, set));
  auto const& corners = pair.mortar->corner_nodes();
  std::erase_if(pair.secondary,
                [&](Index node) { return !std::binary_search(corners.begin(), corners.end(), node); });
  pair.areas = pair.mortar->hat_areas(pair.secondary, model.kinematics == solid::Kinematics::axisymmetric);
  if (!(part.reach > 0))
    pair.reach = 0.5 * pair.mortar->facet_size();
}

/// Nodes in walking order, their areas, and half an edge as reach where none is given.
void Builder::share_edges(mesh::Set const& set, dynamics::Pair& pair) const {
  auto const chains = contact::chains_of(set, pair.name);
  auto const& reference = scene_.model->reference;
  std::map<Index, std::size_t> number;
  for (auto const& chain : chains)
    for (Index const node : chain.nodes)
      if (number.emplace(node, pair.secondary.size()).second)
        pair.secondary.push_back(node);
  pair.areas.assign(pair.secondary.size(), 0.0);
  bool const revolved = scene_.part.kinematics == solid::Kinematics::axisymmetric;
  double total = 0;
  for (auto const& facet : set.facets) {
    Vector const share = mesh::shape_integrals(reference, facet, revolved);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i)
      pair.areas[number.at(facet.nodes[i])] += share[static_cast<Eigen::Index>(i)];
    total += mesh::shape_integrals(reference, facet, false).sum();
  }
  if (!(pair.reach > 0))
    pair.reach = 0.5 * total / static_cast<double>(pair.secondary.size());
}

void Builder::share_facets(std::string const& name, mesh::Set const& set, dynamics::Pair& pair) const {
  auto const& model = *scene_.model;
  auto const& body = **std::find_if(model.bodies.begin(), model.bodies.end(), [&](auto const& candidate) {
    return candidate->name == name.substr(0, name.find('.'));
  });
  auto const& local = body.mesh.sets.find(name.substr(name.find('.') + 1))->second;
  Vector const areas = mesh::nodal_areas(body.mesh, local);
  pair.secondary = set.nodes;
  pair.areas.assign(areas.data(), areas.data() + areas.size());
  if (!(pair.reach > 0))
    pair.reach = 0.5 * std::sqrt(areas.sum() / static_cast<double>(set.facets.size()));
}

void Builder::add_primary(PairPart const& part, mesh::Set const& set, dynamics::Pair& pair) const {
  auto const& reference = scene_.model->reference;
  pair.self = part.secondary == part.primary;
  if (pair.mortar) {
    contact::CellSurface surface(set.facets, reference, first_tangent(part, set));
    if (!(part.reach > 0))
      pair.reach = 0.5 * surface.facet_size();
    pair.primary = std::move(surface);
    return;
  }
  if (scene_.part.dim() == 3) {
    contact::Surface surface(set.facets, reference, first_tangent(part, set));
    if (!(part.reach > 0))
      pair.reach = 0.5 * surface.facet_size();
    pair.primary = std::move(surface);
    return;
  }
  contact::Curve curve(contact::chains_of(set, part.primary), reference, part.smoothing);
  if (!(part.reach > 0))
    pair.reach = 0.5 * curve.segment_length();
  pair.primary = std::move(curve);
}

/// The direction given, or one along the surface.
Vec3 Builder::first_tangent(PairPart const& part, mesh::Set const& set) const {
  if (!part.direction.empty())
    return vec(part.direction);
  return scene_.part.dim() == 2 ? Vec3(Vec3::UnitX())
                                : contact::first_direction(set.facets, scene_.model->reference);
}

} // namespace stiction::scene
