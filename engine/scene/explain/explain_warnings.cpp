// What is likely to go wrong or to cost too much, each with the change of the script that mends it.
#include <fmt/format.h>
#include <numbers>

#include "dynamics/bulk/critical_step.hpp"
#include "scene/build/statics.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

double kept_stiffness(material::Material const& law, double strain) {
  double const stretch = std::max(1 - strain, 0.01), squared = stretch * stretch;
  material::Voigt<4, Pack> strains = material::Voigt<4, Pack>::Zero(); // the first lane is at rest
  strains[0].set(1, (squared - 1) / 2);
  material::Response<4, Pack> at;
  solid::respond<4>(law, material::Wanted::tangent, {&strains, 1}, {&at, 1});
  return (at.stress[0][1] + squared * at.tangent(0, 0)[1]) / at.tangent(0, 0)[0];
}

namespace {

constexpr double closed_cells = 8, good_closed = 4; // cells of approach in a step: the limit, the aim
constexpr double coarse = 1.5;                      // over the primary's facets
constexpr double locking = 0.45;                    // Poisson's ratio
constexpr double small_strain = 0.05;
constexpr double softened_to = 0.46; // of the stiffness at rest: St Venant and Kirchhoff's at a strain of 0.2
constexpr double fast = 0.1;         // over the shear wave speed
constexpr double small_change = 0.02, many_periods = 25;

using Warnings = std::vector<Warning>;

void closing_steps(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  double const part = pair.motion.closing_step / pair.size;
  if (std::isfinite(part) && part > closed_cells)
    warnings.push_back(
        {fmt::format("pair {}: the motions close it by {:.2g} cells in a step: steps may be halved",
                     pair.pair->name, part),
         more_steps(all, pair.motion.closing_stage, part / good_closed)});
}

/// Where nothing of it is left, in words; "" where that is nowhere.
std::string spent(material::Material const& law) {
  double low = 0, high = 1;
  while (high - low > 1e-4) {
    double const middle = 0.5 * (low + high);
    (kept_stiffness(law, middle) > 0 ? low : high) = middle;
  }
  return high < 1 ? "; it has none at " + percent(high) : "";
}

void strain(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  auto const check = [&](BodyFacts const& facts, double strain) {
    auto const& body = *facts.body;
    auto const name = std::visit([](auto const& law) { return law.schema().name; }, body.material);
    bool const small = solid::small_strain(body.material);
    auto const law = law_of_large_strains(facts);
    if (small && strain > small_strain)
      warnings.push_back(
          {fmt::format("body {} will be strained by about {}, and {} knows small strains and rotations only",
                       body.name, percent(strain), name),
           law});
    double const kept = small ? 1 : kept_stiffness(body.material, strain);
    if (kept < softened_to)
      warnings.push_back(
          {fmt::format("body {} will be compressed by about {}, where {} keeps {} of its stiffness{}",
                       body.name, percent(strain), name, percent(std::max(0.0, kept)), spent(body.material)),
           law});
  };
  check(all.bodies[pair.secondary], pair.strain[0]);
  if (pair.primary && *pair.primary != pair.secondary)
    check(all.bodies[*pair.primary], pair.strain[1]);
}

/// The largest ratio of bulk to shear that a law and its networks have at any time: those that have relaxed
/// by then are left out.
material::Moduli least_compressible(material::Moduli const& rest,
                                    std::vector<material::PronyTerm> const& relaxing) {
  auto worst = rest;
  for (auto const& when : relaxing) {
    double shear = rest.shear(), bulk = rest.bulk();
    for (auto const& term : relaxing)
      if (term.time >= when.time) {
        shear += term.stiffness(rest.shear());
        bulk += term.bulk_stiffness(rest.bulk());
      }
    if (auto const then = material::Moduli::from(shear, bulk); then.poisson > worst.poisson)
      worst = then;
  }
  return worst;
}

void locking_cells(BodyFacts const& facts, Warnings& warnings) {
  auto const& body = *facts.body;
  if (body.interpolation != solid::Interpolation::plain || body.plane_stress)
    return;
  static std::map<mesh::CellKind, char const*> const remedies{
      {mesh::CellKind::quad4, "interpolation = \"mean_dilatation\", or quad8 cells"},
      {mesh::CellKind::hex8, "interpolation = \"mean_dilatation\", or hex20 cells"},
      {mesh::CellKind::tri3, "tri6 or quad4 cells with interpolation = \"mean_dilatation\""},
      {mesh::CellKind::tet4, "tet10 cells with interpolation = \"mean_dilatation\", or hex8 cells with it"}};
  for (std::size_t i = 0; i < body.mesh.blocks.size(); ++i)
    if (auto const remedy = remedies.find(body.mesh.blocks[i].kind);
        remedy != remedies.end() && !body.mesh.blocks[i].nodes.empty()) {
      auto const moduli = least_compressible(material::moduli(body.law_of(i)), body.relaxing);
      if (moduli.poisson < locking)
        continue;
      warnings.push_back({fmt::format("body {}: plain {} cells lock at nu = {:.3g} (K/G = {:.3g}): too stiff",
                                      body.name, mesh::info(body.mesh.blocks[i].kind).name, moduli.poisson,
                                      moduli.bulk() / moduli.shear()),
                          fmt::format("in stiction.body of {}: {}", body.name, remedy->second)});
      return;
    }
}

/// Their points hand the nodes what the cells ask for, but between nodes the other body takes it as on linear
/// facets, whose nodal forces are others.
void quadratic_faces(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  if (pair.pair->mortar || !pair.primary)
    return;
  auto const& body = *all.bodies[pair.secondary].body;
  for (auto const& block : body.mesh.blocks)
    if ((block.kind == mesh::CellKind::hex20 || block.kind == mesh::CellKind::tet10) &&
        !block.nodes.empty()) {
      warnings.push_back(
          {fmt::format(
               "pair {}: contact points at the nodes of {} cells: force and contact area come out, but "
               "where the meshes do not match the pressure is wrong by half from node to node",
               pair.pair->name, mesh::info(block.kind).name),
           fmt::format("in stiction.pair of {}: discretisation = \"mortar\"", pair.pair->name)});
      return;
    }
}

bool has_midside_nodes(mesh::Mesh const& mesh) {
  return std::ranges::any_of(mesh.blocks, [](auto const& block) {
    auto const& cell = mesh::info(block.kind);
    return !block.nodes.empty() && cell.nodes > cell.corners;
  });
}

/// Single points far apart dent a finer surface each by itself; slides of such pairs were seen to find no
/// balance.
void coarse_points(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  bool const halved = has_midside_nodes(all.bodies[pair.secondary].body->mesh); // as a primary's segments are
  double const apart = halved ? 0.5 * pair.size : pair.size;
  if (pair.pair->mortar || pair.pair->self || pair.adheres() || !pair.primary ||
      !(apart > coarse * pair.primary_size))
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: node to segment with points {} apart, on a primary whose nodes are {} apart and go "
           "into the other body between them: steps in which it slides may find no balance",
           pair.pair->name, human(apart, "m"), human(pair.primary_size, "m")),
       fmt::format("in stiction.pair of {}: secondary = \"{}\", primary = \"{}\", or discretisation = "
                   "\"mortar\"",
                   pair.pair->name, pair.part->primary, pair.part->secondary)});
}

/// A peak between two points of contact is not seen.
void sharp_peaks(Facts const& all, PairFacts const& pair, Warnings& warnings) {
  if (pair.primary)
    return;
  auto const& shape = all.scene->model->rigids[pair.rigid].shape;
  auto const* map = std::get_if<contact::RigidHeights>(&shape);
  auto const* circle = std::get_if<contact::RigidCircle>(&shape);
  auto const* ball = std::get_if<contact::RigidSphere>(&shape);
  double const radius = map != nullptr ? contact::sharpest_peak(*map)
                        : circle != nullptr && circle->side == contact::Side::outside ? circle->radius
                        : ball != nullptr && ball->side == contact::Side::outside     ? ball->radius
                                                                                      : pair.size;
  if (radius >= pair.size)
    return;
  warnings.push_back(
      {fmt::format("pair {}: peaks of {} have radii down to {}, cells of {} are {}: they are met by single "
                   "points, whose areas and forces are those of the mesh",
                   pair.pair->name, pair.part->primary, human(radius, "m"), pair.part->secondary,
                   human(pair.size, "m")),
       fmt::format("cells of {} of at most {}, or a surface without such short waves", pair.part->secondary,
                   human(radius, "m"))});
}

/// The axis along which all nodes share one coordinate; -1 if there is none.
int flat_axis(mesh::Mesh const& mesh, Indices const& nodes) {
  double const extent = (mesh.nodes.colwise().maxCoeff() - mesh.nodes.colwise().minCoeff()).norm();
  for (int c = 0; c < mesh.dim; ++c) {
    bool flat = true;
    for (Index const node : nodes)
      flat = flat && std::abs(mesh.nodes(node, c) - mesh.nodes(nodes.front(), c)) < 1e-9 * extent;
    if (flat)
      return c;
  }
  return -1;
}

/// motion.fix of one component
std::string fix_words(std::string const& set, int component, int dim) {
  std::string words = fmt::format("stiction.motion.fix {{ set = \"{}\"", set);
  for (int c = 0; c < dim; ++c)
    if (c != component)
      words += fmt::format(", {} = false", "xyz"[c]);
  return words + " }";
}

/// The axis of revolution is held by the scene itself; planes of symmetry are known by their names only.
void symmetry(Facts const& all, std::size_t b, Warnings& warnings) {
  auto const& model = *all.scene->model;
  auto const& body = *all.bodies[b].body;
  for (auto const& [name, set] : body.mesh.sets) {
    int const normal = name.starts_with("symmetry") ? flat_axis(body.mesh, set.nodes) : -1;
    if (normal < 0 || all_held(model, set.nodes, normal, model.first_node[b]))
      continue;
    warnings.push_back({fmt::format("body {}: {} is a plane of symmetry and free to leave it along {}",
                                    body.name, name, "xyz"[normal]),
                        "add to motions: " + fix_words(body.name + "." + name, normal, model.dim())});
  }
}

/// Nothing that inertia alone can move or hold: no flight, no weight, no snap.
bool plain_inertia(Facts const& all) {
  auto const& model = *all.scene->model;
  bool plain = all.dynamic() && model.gravity.isZero(0) && all.speed > 0 && model.loads.empty() &&
               model.pressures.empty() && model.gases.empty() && model.surface_stresses.empty();
  for (auto const& rigid : model.rigids)
    plain = plain && !rigid.free();
  for (auto const& body : all.bodies)
    plain = plain && !body.body->damping && body.start_speed == 0;
  for (auto const& pair : all.pairs)
    plain = plain && !pair.motion.unknown && !(pair.adheres() && snaps(all, pair));
  return plain;
}

/// The shortest way that decides: into a contact, or of a bond that opens or slides.
double smallest_way(Facts const& all) {
  double way = std::numeric_limits<double>::infinity();
  for (auto const& pair : all.pairs) {
    if (pair.motion.depth > 0)
      way = std::min(way, pair.motion.depth);
    if (!pair.adheres())
      continue;
    auto const scales = interface::scales(*pair.pair->law.adhesion);
    way = std::min(way, scales.opening);
    if (scales.along > 0)
      way = std::min(way, scales.along);
  }
  return std::isfinite(way) ? way : 0;
}

/// Bodies that are set in motion swing by speed * period / (2 pi) about where they would be without inertia.
void slow_motion(Facts const& all, Warnings& warnings) {
  if (!plain_inertia(all) || !(smallest_way(all) > 0))
    return;
  Statics statics(*all.scene->model);
  if (!statics.regular())
    return;
  double const period = statics.period();
  double const change = all.speed * period / std::numbers::pi / smallest_way(all);
  if (change < small_change && all.end > many_periods * period)
    warnings.push_back(
        {fmt::format(
             "nothing is fast: the bodies as they are held swing in {}, and in that time nothing moves "
             "by more than {}",
             human(period, "s"), human(all.speed * period, "m")),
         fmt::format("scheme.quasi_static{{}} gives the same to about {} and needs no mass",
                     percent(change))});
}

void inertia(Facts const& all, Warnings& warnings) {
  double slowest = std::numeric_limits<double>::infinity();
  for (auto const& body : all.bodies)
    slowest = std::min(slowest, body.shear_speed());
  double const mach = all.speed / slowest;
  if (!all.dynamic() && !all.scene->model->velocity.isZero(0))
    warnings.push_back(
        {"bodies are given velocities, which do nothing in a quasi-static run: it has no inertia",
         "a dynamic scheme such as scheme.theta_xi{}, or no velocities"});
  if (!all.dynamic() && mach > fast)
    warnings.push_back(
        {fmt::format("the motions are fast: {} is {:.2g} of the shear wave speed {}, and a quasi-static run "
                     "has no waves",
                     human(all.speed, "m/s"), mach, human(slowest, "m/s")),
         "scheme.theta_xi{}"});
}

/// Paths that begin elsewhere than where the bodies are.
void leaps_at_start(Facts const& all, Warnings& warnings) {
  constexpr double slight = 1e-3; // of the body, as a preload may be
  double extent = 0;
  for (auto const& body : all.bodies)
    extent = std::max(extent, body.extent());
  std::string last;
  for (auto const& motion : all.scene->model->motions) {
    double const start = motion.value(0);
    if (std::abs(start) <= slight * extent || motion.set == last || motion.set.empty())
      continue;
    last = motion.set;
    warnings.push_back(
        {fmt::format("{}: its path in {} begins at {} where the body is at rest: the first step takes "
                     "it there at once",
                     motion.set, "xyz"[motion.component], human(start, "m")),
         "a path that begins at 0 at t = 0"});
  }
}

/// Below the critical step of single cells (dynamics/bulk/critical_step.hpp).
void critical_steps(Facts const& all, Warnings& warnings) {
  constexpr double written_below = 0.995; // three digits may be rounded up
  auto const& model = *all.scene->model;
  if (!dynamics::weights(model.scheme).explicit_forces)
    return;
  double const limit = dynamics::critical_step(model, Vector::Zero(model.dofs()));
  if (all.longest_step > limit * (1 + dynamics::critical_margin))
    warnings.push_back(
        {dynamics::above_critical(all.longest_step, limit) + ": the run will refuse to start",
         fmt::format("steps of {} or less, or an implicit scheme", human(written_below * limit, "s"))});
}

/// In lasting contact the plain scheme turns the normal velocity about by -(1 - theta) / theta each step
/// (physics.md 5).
void ringing(Facts const& all, Warnings& warnings) {
  auto const scheme = dynamics::weights(all.scene->model->scheme);
  if (!all.dynamic() || all.pairs.empty() || scheme.rate > 0.5 || scheme.contact < 1 ||
      scheme.surface_apart() || scheme.velocity_level())
    return;
  warnings.push_back(
      {"a scheme that damps nothing (theta = 1/2) with the inertia of contact nodes: the contact "
       "pressure swings at every step",
       "contact_inertia = \"implicit\" in the scheme, the default"});
}

/// The pressure that keeps a volume at step ends is a constraint's: means of it leave its +-1 mode undamped.
void swinging_pressure(Facts const& all, Warnings& warnings) {
  auto const& model = *all.scene->model;
  auto const scheme = dynamics::weights(model.scheme);
  if (!all.dynamic() || scheme.explicit_forces || scheme.accelerations() || scheme.rate > 0.5 ||
      scheme.xi > 0.5)
    return;
  for (auto const& gas : model.gases)
    if (gas.by_volume)
      warnings.push_back({fmt::format("{}: a scheme that damps nothing (theta = 1/2) with a given volume: "
                                      "its pressure swings at every step, the more the shorter steps are",
                                      gas.set),
                          "theta = 0.6 in the scheme, or scheme.hht{}"});
}

} // namespace

void add_warnings(Facts const& all, Explanation& explanation) {
  auto& warnings = explanation.warnings;
  unit_of_meshes(all, warnings);
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    locking_cells(all.bodies[b], warnings);
    symmetry(all, b, warnings);
  }
  for (auto const& pair : all.pairs) {
    closing_steps(all, pair, warnings);
    strain(all, pair, warnings);
    quadratic_faces(all, pair, warnings);
    coarse_points(all, pair, warnings);
    sharp_peaks(all, pair, warnings);
    if (pair.pair->law.adhesion)
      warn_of_bonds(all, pair, warnings);
  }
  warn_of_bending(all, warnings);
  warn_of_relief(all, warnings);
  warn_of_shared_nodes(all, warnings);
  warn_of_springs(all, warnings);
  warn_of_idle(all, warnings);
  warn_of_meeting(all, warnings);
  warn_of_turns(all, warnings);
  warn_of_holes(all, warnings);
  inertia(all, warnings);
  critical_steps(all, warnings);
  ringing(all, warnings);
  leaps_at_start(all, warnings);
  warn_of_paths(all, warnings);
  swinging_pressure(all, warnings);
}

void add_advice(Facts const& all, Explanation& explanation) {
  for (auto const& pair : all.pairs)
    advise_rigid(all, pair, explanation.warnings);
  slow_motion(all, explanation.warnings);
}

} // namespace stiction::scene
