// Whether a stiff body may be a rigid obstacle: the conditions, checked from the scene, and what it changes.
#include <algorithm>
#include <fmt/format.h>

#include "mesh/topology/surface.hpp"
#include "scene/build/statics.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr double contrast_needed = 1000; // of E / (1 - nu^2)
constexpr double most_change = 0.02;     // of the force
constexpr double reach_of_bonds = 10;    // openings u0 beyond which a bond carries next to nothing
constexpr double most_products = 5e7;    // contact points times nodes of the stiff surface

bool axisymmetric(Facts const& all) {
  return all.scene->part.kinematics == solid::Kinematics::axisymmetric;
}

bool belongs(std::string const& set, std::string const& body) {
  return set.substr(0, set.find('.')) == body;
}

/// Does every component of the body follow one path, so that it moves as a whole without a turn?
bool carried_as_one(Facts const& all, std::string const& body) {
  std::array<std::optional<std::pair<Numbers, Numbers>>, 3> paths;
  bool one = true;
  auto const take = [&](std::size_t c, Numbers const& times, Numbers const& values) {
    std::pair path(times, values);
    one = one && (!paths[c] || *paths[c] == path);
    paths[c] = std::move(path);
  };
  for (auto const& motion : all.scene->part.motions) {
    if (!belongs(set_of(motion), body))
      continue;
    one = one && !std::holds_alternative<TurnPart>(motion);
    auto const* drive = std::get_if<DrivePart>(&motion);
    auto const* fix = std::get_if<FixPart>(&motion);
    std::array const driven{drive ? &drive->x : nullptr, drive ? &drive->y : nullptr,
                            drive ? &drive->z : nullptr};
    std::array const held{fix && fix->x, fix && fix->y, fix && fix->z};
    for (std::size_t c = 0; c < 3; ++c)
      if (held[c])
        take(c, {}, {});
      else if (drive && !driven[c]->empty())
        take(c, drive->times, *driven[c]);
  }
  for (int c = axisymmetric(all) ? 1 : 0; c < all.scene->part.dim(); ++c)
    one = one && paths[ix(c)];
  return one;
}

bool in_one_pair(Facts const& all, std::string const& body) {
  auto const& pairs = all.scene->part.pairs;
  return std::count_if(pairs.begin(), pairs.end(), [&](auto const& entry) {
           return belongs(entry.second.secondary, body) || belongs(entry.second.primary, body);
         }) == 1;
}

/// Corners of a facet: in 2D its two ends.
std::vector<std::array<Index, 2>> edges_of(mesh::Facet const& facet, int dim) {
  if (dim == 2)
    return {{{facet.nodes[0], facet.nodes[0]}}, {{facet.nodes[1], facet.nodes[1]}}};
  auto const corners = ix(mesh::info(mesh::facet_kind(facet)).corners);
  std::vector<std::array<Index, 2>> edges(corners);
  for (std::size_t k = 0; k < corners; ++k) {
    Index const from = facet.nodes[k], to = facet.nodes[(k + 1) % corners];
    edges[k] = {std::min(from, to), std::max(from, to)};
  }
  return edges;
}

/// Is the edge on a plane of symmetry or on the axis of revolution?
bool goes_on(Facts const& all, mesh::Mesh const& mesh, std::array<Index, 2> const& edge) {
  if (axisymmetric(all) && mesh.nodes(edge[0], 0) == 0)
    return true;
  return std::any_of(mesh.sets.begin(), mesh.sets.end(), [&](auto const& entry) {
    auto const& nodes = entry.second.nodes;
    return (entry.first.starts_with("symmetry") || entry.first == "axis") &&
           std::binary_search(nodes.begin(), nodes.end(), edge[0]) &&
           std::binary_search(nodes.begin(), nodes.end(), edge[1]);
  });
}

/// Nodes at which a surface ends.
std::vector<bool> end_nodes(Facts const& all, mesh::Mesh const& mesh, mesh::Set const& set) {
  std::map<std::array<Index, 2>, int> count;
  for (auto const& facet : set.facets)
    for (auto const& edge : edges_of(facet, mesh.dim))
      ++count[edge];
  std::vector<bool> ends(ix(mesh.node_count()), false);
  for (auto const& [edge, uses] : count)
    if (uses == 1 && !goes_on(all, mesh, edge))
      ends[ix(edge[0])] = ends[ix(edge[1])] = true;
  return ends;
}

Vec3 row(Matrix const& nodes, Index node) {
  Vec3 position = Vec3::Zero();
  position.head(nodes.cols()) = nodes.row(node).transpose();
  return position;
}

/// The point of the shape nearest to a point.
Vec3 foot_on(ShapeFit const& fit, Vec3 const& position) {
  Vec3 const arm = position - fit.centre;
  return fit.kind == ShapeFit::flat ? Vec3(position - arm.dot(fit.normal) * fit.normal)
                                    : Vec3(fit.centre + arm * (fit.radius / arm.norm()));
}

/// Nodes of both sides where they may touch; `inside` says whether all of that lies within the stiff surface,
/// away from where it ends.
struct Zone {
  Indices soft, stiff;
  bool inside = true;
};

Zone contact_zone(Facts const& all, PairFacts const& pair, mesh::Set const& set) {
  auto const& model = *all.scene->model;
  auto const& body = *all.bodies[*pair.primary].body;
  double const bonds =
      pair.adheres() ? reach_of_bonds * interface::scales(*pair.pair->law.adhesion).opening : 0;
  double const near = pair.gap + 2 * pair.motion.depth + bonds;
  double const margin = pair.motion.travel + pair.strain[0] * all.bodies[pair.secondary].extent() +
                        2 * std::max(pair.size, pair.primary_size);
  auto const ends = end_nodes(all, body.mesh, set);
  Zone zone;
  for (Index const node : pair.pair->secondary) {
    Vec3 const position = row(model.reference, node), foot = foot_on(pair.primary_fit, position);
    if ((position - foot).norm() > near)
      continue;
    auto const distance = [&](Index other) { return (row(body.mesh.nodes, other) - foot).norm(); };
    Index const nearest = *std::ranges::min_element(set.nodes, {}, distance);
    bool const by_an_end = std::ranges::any_of(
        set.nodes, [&](Index other) { return ends[ix(other)] && distance(other) <= margin; });
    zone.inside = zone.inside && !by_an_end && !ends[ix(nearest)];
    zone.soft.push_back(node);
    zone.stiff.push_back(model.first_node[*pair.primary] + nearest);
  }
  return zone;
}

/// Displacement along the normal for a unit force on both sides, stiff over soft; infinite where neither is
/// held by itself.
double compliance_ratio(Facts const& all, PairFacts const& pair, Zone const& zone) {
  Statics statics(*all.scene->model);
  if (!statics.regular())
    return std::numeric_limits<double>::infinity();
  return statics.compliance(zone.stiff, pair.normal) / statics.compliance(zone.soft, pair.normal);
}

/// What the shape is off its facets and nodes, over the depth or, of what is only pulled, the opening of its
/// bonds.
double shape_change(PairFacts const& pair) {
  auto const& fit = pair.primary_fit;
  double const sag =
      fit.kind == ShapeFit::round ? pair.primary_size * pair.primary_size / (8 * fit.radius) : 0;
  double const opening = pair.adheres() ? interface::scales(*pair.pair->law.adhesion).opening : 0;
  double const way = pair.motion.depth > 0 ? pair.motion.depth : opening;
  return 1.5 * (sag + fit.error) / way;
}

/// Over the force at the same depth; infinite where a condition does not hold or is not known.
double change_by_rigid(Facts const& all, PairFacts const& pair) {
  constexpr double never = std::numeric_limits<double>::infinity();
  auto const &stiff = all.bodies[*pair.primary], &soft = all.bodies[pair.secondary];
  auto const& name = stiff.body->name;
  bool const quick =
      !all.dynamic() || stiff.extent() / stiff.shear_speed() < 0.1 * soft.extent() / soft.shear_speed();
  if (pair.primary_fit.kind == ShapeFit::none || pair.motion.unknown || pair.gap < 0 ||
      stiff.start_speed > 0 || !quick || !in_one_pair(all, name) || !carried_as_one(all, name))
    return never;
  auto const& set = stiff.body->mesh.sets.find(pair.part->primary.substr(name.size() + 1))->second;
  if (static_cast<double>(set.nodes.size()) * static_cast<double>(pair.pair->size()) > most_products)
    return never;
  auto const zone = contact_zone(all, pair, set);
  if (!zone.inside || zone.soft.empty())
    return never;
  return stiff.plane_modulus() > 0 ? soft.plane_modulus() / stiff.plane_modulus() + shape_change(pair) +
                                         2 * compliance_ratio(all, pair, zone)
                                   : never;
}

/// "{0 m, 10 mm}"
std::string position_words(Vec3 const& at, int dim) {
  std::string words;
  for (int c = 0; c < dim; ++c)
    words += (c > 0 ? ", " : "") + human(at[c], "m");
  return "{" + words + "}";
}

std::string shape_words(Facts const& all, PairFacts const& pair) {
  int const dim = all.scene->part.dim();
  auto const& fit = pair.primary_fit;
  if (fit.kind == ShapeFit::flat)
    return fmt::format("rigid.plane through {}", position_words(fit.centre, dim));
  bool const sphere = dim == 3 || (axisymmetric(all) && std::abs(fit.centre.x()) < 1e-2 * fit.radius);
  Vec3 centre = fit.centre;
  if (axisymmetric(all) && sphere)
    centre.x() = 0;
  for (int c = 0; c < dim; ++c)
    if (std::abs(centre[c]) < 1e-9 * fit.radius)
      centre[c] = 0;
  return fmt::format("rigid.{}{{centre = {}, radius = {}}}", sphere ? "sphere" : "circle",
                     position_words(centre, dim), human(fit.radius, "m"));
}

} // namespace

void advise_rigid(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings) {
  if (!pair.primary || *pair.primary == pair.secondary)
    return;
  auto const &stiff = all.bodies[*pair.primary], &soft = all.bodies[pair.secondary];
  double const contrast = stiff.plane_modulus() / soft.plane_modulus();
  if (contrast < contrast_needed)
    return;
  double const change = change_by_rigid(all, pair);
  if (!(change <= most_change))
    return;
  auto const carried = !stiff.driven_set.empty() ? "carried along the path of " + stiff.driven_set
                                                 : std::string("standing still");
  warnings.push_back(
      {fmt::format("body {} is {} times stiffer than body {}, and they touch only where {} does not end",
                   stiff.body->name, human(contrast, "1"), soft.body->name, pair.part->primary),
       fmt::format(
           "make it an obstacle, {}, {}: the force at the same depth changes by at most about {}, and "
           "{} of {} unknowns are saved",
           shape_words(all, pair), carried, percent(change), stiff.free, stiff.free + soft.free)});
}

} // namespace stiction::scene
