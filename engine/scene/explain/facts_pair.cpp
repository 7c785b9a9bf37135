// Facts of pairs: stiffness, curvature, cell size, and how the motions bring the two sides together.
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include <Eigen/Geometry>

#include "mesh/topology/surface.hpp"
#include "scene/build/builder.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr int most_samples = 1000; // of a stage

/// A turn about an axis through a point.
struct Swing {
  dynamics::Path angle; ///< rad
  Vec3 axis, centre;    ///< unit; m
};

/// The displacement that one motion, obstacle or initial velocity gives to a side of a pair.
struct Mover {
  std::array<dynamics::Path, 3> shift;
  Vec3 velocity = Vec3::Zero(); ///< of what flies freely, m/s
  std::optional<Swing> swing = {};
  bool flies = false; ///< nothing prescribes where it goes
  [[nodiscard]] Vec3 displacement(double t, Vec3 const& position) const {
    Vec3 u = t * velocity + Vec3(shift[0].value(t), shift[1].value(t), shift[2].value(t));
    if (swing)
      u += Eigen::AngleAxisd(swing->angle.value(t), swing->axis) * (position - swing->centre) -
           (position - swing->centre);
    return u;
  }
  /// Prescribed over the whole run.
  [[nodiscard]] bool prescribed() const { return !flies; }
};

/// Where a flight starts, m, and how long it is followed, s.
struct Flight {
  Vec3 centre;
  double end;
};
Mover flying(Vec3 const& velocity, Vec3 const& spin, Flight const& flight) {
  Mover mover;
  mover.velocity = velocity;
  mover.flies = true;
  if (!spin.isZero(0))
    mover.swing = Swing{{{0, flight.end}, {0, spin.norm() * flight.end}}, spin.normalized(), flight.centre};
  return mover;
}

bool holds_all(FixPart const& fix, int dim) {
  return fix.x && fix.y && (dim == 2 || fix.z);
}

/// Sets that are only guided, held in some components, say nothing where others are driven or held.
std::vector<Mover> movers_of(Facts const& facts, std::size_t body) {
  std::vector<Mover> movers;
  auto const& name = facts.bodies[body].body->name;
  int const dim = facts.scene->part.dim();
  for (auto const& motion : facts.scene->part.motions) {
    auto const& set = set_of(motion);
    if (set.substr(0, set.find('.')) != name)
      continue;
    if (auto const* drive = std::get_if<DrivePart>(&motion))
      movers.push_back(
          {{path(drive->times, drive->x), path(drive->times, drive->y), path(drive->times, drive->z)}});
    else if (auto const* turn = std::get_if<TurnPart>(&motion))
      movers.push_back({{path(turn->times, turn->x), path(turn->times, turn->y), path(turn->times, turn->z)},
                        Vec3::Zero(),
                        Swing{path(turn->times, turn->angle), turn->direction(), vec(turn->centre)}});
    else if (holds_all(std::get<FixPart>(motion), dim))
      movers.push_back({});
  }
  auto const& part = facts.scene->part.bodies.at(name);
  if (facts.bodies[body].driven_set.empty() &&
      facts.bodies[body].start_speed > 0) // what only guides it does not stop it
    movers = {flying(vec(part.velocity), spin_of(part.spin), {facts.bodies[body].centre, facts.end})};
  if (movers.empty())
    movers.push_back({});
  return movers;
}

std::vector<Mover> movers_of(Facts const& facts, PairFacts const& pair) {
  if (pair.primary)
    return movers_of(facts, *pair.primary);
  auto const& rigid = facts.scene->model->rigids[pair.rigid];
  auto const& part = facts.scene->part.obstacles.at(rigid.name);
  Mover mover;
  mover.shift = {path(part.times, part.x), path(part.times, part.y), path(part.times, part.z)};
  if (!rigid.free())
    mover.swing = Swing{rigid.angle, rigid.axis, rigid.pivot};
  else if (Vec3 const spin = spin_of(part.spin); !vec(part.velocity).isZero(0) || !spin.isZero(0)) {
    auto const shift = mover.shift;
    mover = flying(vec(part.velocity), spin, {rigid.pivot, facts.end});
    mover.shift = shift;
  }
  return {mover};
}

/// Follows one mover of either side over the schedule.
class Follower {
public:
  Follower(PairFacts& pair, Vec3 position, bool opening_alone = false)
      : pair_(&pair), position_(std::move(position)), opening_alone_(opening_alone) {}
  void follow(SchedulePart const& schedule, Mover const& secondary, Mover const& primary) {
    double start = 0;
    closed_ = 0;
    for (std::size_t s = 0; s < schedule.stages.size(); ++s) {
      auto const& stage = schedule.stages[s];
      dt_ = (stage.until - start) / stage.steps;
      int const samples = std::min(stage.steps, most_samples);
      for (int k = 0; k < samples; ++k)
        interval(
            s,
            {start + k * (stage.until - start) / samples, start + (k + 1) * (stage.until - start) / samples},
            {&secondary, &primary});
      start = stage.until;
    }
    if (!opening_alone_ && secondary.prescribed() && primary.prescribed())
      pair_->motion.closed_time = std::max(pair_->motion.closed_time, closed_);
  }

private:
  void interval(std::size_t stage, std::array<double, 2> t, std::array<Mover const*, 2> sides) {
    auto const apart = [&](double time) {
      return Vec3(sides[0]->displacement(time, position_) - sides[1]->displacement(time, position_));
    };
    Vec3 const end = apart(t[1]), velocity = (end - apart(t[0])) / (t[1] - t[0]);
    bool const around = pair_->normal.isZero(0);
    double const along = around ? velocity.norm() : velocity.dot(pair_->normal);
    double const sliding = around ? velocity.norm() : (velocity - along * pair_->normal).norm();
    auto& motion = pair_->motion;
    keep(around ? along : -along, stage, motion.opening, motion.opening_step, motion.opening_stage);
    if (opening_alone_)
      return;
    keep(along, stage, motion.closing, motion.closing_step, motion.closing_stage);
    keep(sliding, stage, motion.sliding, motion.sliding_step, motion.sliding_stage);
    motion.unknown |= around || pair_->gap < 0 || !sides[0]->prescribed() || !sides[1]->prescribed();
    motion.travel = std::max(motion.travel, (end - end.dot(pair_->normal) * pair_->normal).norm());
    if (motion.unknown)
      return;
    double const approach = end.dot(pair_->normal) - pair_->gap;
    motion.depth = std::max(motion.depth, approach);
    closed_ += approach >= 0 ? t[1] - t[0] : 0;
  }
  void keep(double speed, std::size_t stage, double& fastest, double& step, std::size_t& where) const {
    fastest = std::max(fastest, speed);
    if (speed * dt_ <= step)
      return;
    step = speed * dt_;
    where = stage;
  }

  PairFacts* pair_;
  Vec3 position_;
  bool opening_alone_;
  double dt_ = 0, closed_ = 0;
};

Vec3 position_of(dynamics::Model const& model, Index node) {
  Vec3 position = Vec3::Zero();
  position.head(model.dim()) = model.reference.row(node).transpose();
  return position;
}

/// Mean outward unit normal of a boundary set; 0 where it closes around.
Vec3 mean_normal(dynamics::Model const& model, std::size_t b, mesh::Set const& set) {
  Vec3 sum = Vec3::Zero();
  double size = 0;
  Index const first = model.first_node[b];
  for (auto const& facet : set.facets) {
    Vec3 const a = position_of(model, first + facet.nodes[0]),
               edge = position_of(model, first + facet.nodes[1]) - a;
    Vec3 const normal = model.dim() == 2
                            ? Vec3(edge.y(), -edge.x(), 0)
                            : Vec3(0.5 * edge.cross(position_of(model, first + facet.nodes[2]) - a));
    sum += normal;
    size += normal.norm();
  }
  return sum.norm() > 0.3 * size ? Vec3(sum.normalized()) : Vec3(Vec3::Zero());
}

/// The body and the set behind "body.set".
struct Side {
  std::size_t body = 0;
  mesh::Set const* set = nullptr;
};
Side side_of(Scene const& scene, std::string const& name) {
  auto const dot = name.find('.');
  Side side;
  while (scene.bodies[side.body] != name.substr(0, dot))
    ++side.body;
  side.set = &scene.model->bodies[side.body]->mesh.sets.find(name.substr(dot + 1))->second;
  return side;
}

ShapeFit fit_of(solid::Body const& body, mesh::Set const& set) {
  Matrix points(static_cast<Eigen::Index>(set.nodes.size()), body.mesh.dim);
  for (std::size_t i = 0; i < set.nodes.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = body.mesh.nodes.row(set.nodes[i]);
  return fit_shape(points);
}

/// 1/m, positive where convex; nothing if not known.
std::optional<double> curvature(ShapeFit const& fit, Vec3 const& outward, Vec3 const& position) {
  if (fit.kind == ShapeFit::flat)
    return 0;
  if (fit.kind == ShapeFit::none)
    return {};
  return (position - fit.centre).dot(outward) >= 0 ? 1 / fit.radius : -1 / fit.radius;
}
std::optional<double> curvature(contact::Obstacle const& shape) {
  return std::visit(
      [](auto const& part) -> std::optional<double> {
        using Part = std::decay_t<decltype(part)>;
        if constexpr (std::is_same_v<Part, contact::RigidPlane>)
          return 0;
        else if constexpr (std::is_same_v<Part, contact::RigidCircle> ||
                           std::is_same_v<Part, contact::RigidSphere>)
          return (part.side == contact::Side::outside ? 1 : -1) / part.radius;
        else
          return {};
      },
      shape);
}

/// Length, or square root of the area, of a facet, m.
double facet_size(dynamics::Model const& model, Index first, mesh::Facet const& facet) {
  auto const corner = [&](std::size_t k) { return position_of(model, first + facet.nodes[k]); };
  Vec3 const edge = corner(1) - corner(0);
  if (model.dim() == 2)
    return edge.norm();
  bool const triangle = mesh::info(mesh::facet_kind(facet)).corners == 3;
  return std::sqrt(0.5 * (triangle ? edge.cross(corner(2) - corner(0))
                                   : (corner(2) - corner(0)).cross(corner(3) - corner(1)))
                             .norm());
}

double median(std::vector<double> values) {
  auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The contact point nearest to the primary, the gap there, and the median size of the facets around the
/// nearest tenth of the points.
Index find_nearest(dynamics::Model const& model, std::vector<dynamics::ContactState> const& states,
                   Side const& side, PairFacts& facts) {
  auto const& nodes = facts.pair->secondary;
  std::vector<std::size_t> order(states.size());
  std::iota(order.begin(), order.end(), 0);
  auto const gap = [&](std::size_t i) {
    return states[i].foot.found() ? states[i].gap : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return gap(a) < gap(b); });
  bool const found = std::isfinite(gap(order[0]));
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  double const least = rounding * model.reference.cwiseAbs().maxCoeff();
  if (found) {
    facts.gap = gap(order[0]) > least ? gap(order[0]) : 0;
    facts.overlap = gap(order[0]) < -least ? -gap(order[0]) : 0;
  }
  std::vector<bool> near(ix(model.node_count()), !found);
  for (std::size_t k = 0; k < 1 + order.size() / 10; ++k)
    near[ix(nodes[order[k]])] = true;
  Index const first = model.first_node[side.body];
  std::vector<double> sizes;
  for (auto const& facet : side.set->facets)
    if (std::any_of(facet.nodes.begin(), facet.nodes.end(),
                    [&](Index node) { return near[ix(first + node)]; }))
      sizes.push_back(facet_size(model, first, facet));
  facts.size = median(std::move(sizes));
  return nodes[order[0]];
}

/// Of the points that are bonded at the start, the farthest from a position: what turns opens them fastest.
std::optional<Vec3> farthest_bond(dynamics::Model const& model, dynamics::Pair const& pair,
                                  std::vector<dynamics::ContactState> const& states, Vec3 const& from) {
  std::optional<Vec3> farthest;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (Vec3 const at = position_of(model, pair.secondary[i]);
        states[i].bond.beta > 0 &&
        (!farthest || (at - from).squaredNorm() > (*farthest - from).squaredNorm()))
      farthest = at;
  return farthest;
}

/// Does anything move the sides that no path prescribes?
bool moved_by_forces(dynamics::Model const& model, PairFacts const& facts) {
  return !model.springs.empty() || !model.loads.empty() || !model.pressures.empty() || !model.gases.empty() ||
         !model.gravity.isZero(0) || (!facts.primary && model.rigids[facts.rigid].free());
}

/// Into a plane that the pair meets, whatever the secondary side looks like; nothing of other counterparts.
std::optional<Vec3> towards_plane(dynamics::Model const& model, dynamics::Pair const& pair) {
  auto const* side = std::get_if<dynamics::RigidSide>(&pair.primary);
  auto const* plane =
      side != nullptr ? std::get_if<contact::RigidPlane>(&model.rigids[side->body].shape) : nullptr;
  if (plane == nullptr)
    return std::nullopt;
  return plane->normal.empty() ? -Vec3::Unit(model.dim() - 1) : Vec3(-vec(plane->normal).normalized());
}

void add_primary(Facts const& all, PairFacts& facts, Vec3 const& position, std::optional<double>& curved) {
  auto const& model = *all.scene->model;
  if (auto const* side = std::get_if<dynamics::RigidSide>(&facts.pair->primary)) {
    facts.rigid = side->body;
    curved = curvature(model.rigids[side->body].shape);
    return;
  }
  auto const side = side_of(*all.scene, facts.part->primary);
  facts.primary = side.body;
  facts.facets = static_cast<int>(side.set->facets.size());
  if (auto const* curve = std::get_if<contact::Curve>(&facts.pair->primary))
    facts.primary_size = curve->segment_length();
  else if (auto const* cells = std::get_if<contact::CellSurface>(&facts.pair->primary))
    facts.primary_size = cells->facet_size();
  else
    facts.primary_size = std::get<contact::Surface>(facts.pair->primary).facet_size();
  facts.primary_fit = fit_of(*model.bodies[side.body], *side.set);
  curved = curvature(facts.primary_fit, mean_normal(model, side.body, *side.set), position);
}

/// Of a body along the normal; where the other side closes around, its extent. m
double thickness_of(PairFacts const& facts, BodyFacts const& body) {
  return facts.normal.isZero(0) ? body.extent() : facts.normal.cwiseAbs().dot(body.sides);
}

/// The part of a pair's points that have a node of a body's motions, of those that move or of all, above or
/// beneath them, no farther along the surface than the body is thick, of fifty points at most; nothing
/// without such nodes.
std::optional<double> part_taken(Facts const& all, PairFacts const& facts, std::size_t body, bool moving) {
  auto const& model = *all.scene->model;
  auto const along = [&](Index node) {
    Vec3 const at = position_of(model, node);
    return Vec3(at - at.dot(facts.normal) * facts.normal);
  };
  std::vector<Vec3> taken;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      if (node >= model.first_node[body] && node < model.first_node[body + 1] &&
          (!moving || motion.farthest() > 0))
        taken.push_back(along(node));
  auto const& points = facts.pair->nodes();
  if (taken.empty() || points.empty())
    return std::nullopt;
  double const thickness = thickness_of(facts, all.bodies[body]);
  std::size_t const stride = 1 + points.size() / 50;
  double looked = 0, found = 0;
  for (std::size_t i = 0; i < points.size(); i += stride, ++looked)
    found += std::ranges::any_of(taken, [at = along(points[i]), thickness](Vec3 const& other) {
      return (at - other).norm() <= thickness;
    });
  return found / looked;
}

/// Does a body bend under its bonds, as an arm or a tape does, most of which nothing holds from behind?
bool bends(Facts const& all, PairFacts const& facts, std::size_t body) {
  return !facts.normal.isZero(0) && part_taken(all, facts, body, false).value_or(0) < 0.5;
}

/// Is a body moved, but beside most of its bonds? Where it bends there these do not follow.
bool moved_beside(Facts const& all, PairFacts const& facts, std::size_t body) {
  return !facts.normal.isZero(0) && part_taken(all, facts, body, true).value_or(1) < 0.5;
}

/// E*, and the stiffness of the two bodies as columns along the normal and, where they bend, as plates.
void add_stiffness(Facts const& all, PairFacts& facts) {
  double compliance = 0, column = 0, bending = 0;
  auto const add = [&](std::size_t number) {
    auto const& body = all.bodies[number];
    compliance += 1 / body.plane_modulus();
    double const thickness = thickness_of(facts, body);
    column += thickness / body.moduli.young;
    if (bends(all, facts, number))
      bending += 1 / (body.plane_modulus() * thickness * thickness * thickness);
  };
  add(facts.secondary);
  if (facts.primary && *facts.primary != facts.secondary)
    add(*facts.primary);
  facts.modulus = 1 / compliance;
  facts.column = 1 / column;
  facts.bending = 1 / bending;
}

/// Length of a body along the surface, m.
double span_of(PairFacts const& facts, BodyFacts const& body) {
  return body.sides.cwiseProduct(Vec3::Ones() - facts.normal.cwiseAbs()).maxCoeff();
}

/// Does a body give way to what presses it by bending: held or moved beside it, or a slender one that nothing
/// but round obstacles hold?
bool gives_way(Facts const& all, PairFacts const& facts, std::size_t number) {
  constexpr double slender = 0.2; // thickness over length
  if (facts.normal.isZero(0))
    return false;
  auto const& body = all.bodies[number];
  bool const holds = part_taken(all, facts, number, false).has_value();
  return holds ? bends(all, facts, number)
               : facts.radius > 0 && thickness_of(facts, body) < slender * span_of(facts, body);
}

/// Of a beam of three points, 6 h depth / L^2; else of the bodies as columns, depth K_column / E, or beneath
/// a Hertz contact of radius a = sqrt(R depth), where the strain is about 0.6 p0 / E = 0.4 a/R E*/E (p0 = 2
/// E* a / (pi R)); the larger. What bends takes all of the depth.
void add_strain(Facts const& all, PairFacts& facts) {
  double const depth = facts.motion.depth;
  double const slope = facts.radius > 0 ? std::sqrt(std::min(1.0, depth / facts.radius)) : 0;
  std::array<bool, 2> const bent{gives_way(all, facts, facts.secondary),
                                 facts.primary && gives_way(all, facts, *facts.primary)};
  auto const strain = [&](std::size_t number, bool by_bending) {
    auto const& body = all.bodies[number];
    double const span = span_of(facts, body);
    if (by_bending)
      return 6 * thickness_of(facts, body) * depth / (span * span);
    return bent[0] || bent[1]
               ? 0.0
               : std::max(depth * facts.column, 0.4 * slope * facts.modulus) / body.moduli.young;
  };
  facts.strain[0] = strain(facts.secondary, bent[0]);
  if (facts.primary)
    facts.strain[1] = strain(*facts.primary, bent[1]);
}

} // namespace

namespace {

/// Sum of the surface stresses that act on all of the secondary side, N/m.
double tension_of(dynamics::Model const& model, dynamics::Pair const& pair) {
  double sum = 0;
  for (auto const& stress : model.surface_stresses) {
    std::set<Index> stretched;
    for (auto const& facet : stress.facets)
      stretched.insert(facet.nodes.begin(), facet.nodes.end());
    if (std::ranges::all_of(pair.nodes(), [&](Index node) { return stretched.contains(node); }))
      sum += stress.gamma;
  }
  return sum;
}

} // namespace

PairFacts pair_facts(Facts const& all, std::size_t p, dynamics::State const& start) {
  auto const& scene = *all.scene;
  PairFacts facts;
  facts.pair = &scene.model->pairs[p];
  facts.part = &scene.part.pairs.at(scene.pairs[p]);
  auto const side = side_of(scene, facts.part->secondary);
  facts.secondary = side.body;
  auto const into_plane = towards_plane(*scene.model, *facts.pair);
  Vec3 const own_normal = mean_normal(*scene.model, side.body, *side.set);
  facts.normal = into_plane.value_or(own_normal);
  Vec3 const position = position_of(*scene.model, find_nearest(*scene.model, start.contacts[p], side, facts));
  std::optional<double> curved;
  add_primary(all, facts, position, curved);
  for (auto const& point : start.contacts[p])
    facts.bond = std::max(facts.bond, point.bond.beta);
  facts.secondary_fit = fit_of(*scene.model->bodies[side.body], *side.set);
  auto const own = curvature(facts.secondary_fit, facts.normal, position);
  if (own && curved && *own + *curved > 0)
    facts.radius = 1 / (*own + *curved);
  if (into_plane)
    facts.alike = -own_normal.dot(*into_plane);
  else if (facts.primary)
    facts.alike =
        own_normal.dot(mean_normal(*scene.model, *facts.primary, *side_of(scene, facts.part->primary).set));
  add_stiffness(all, facts);
  std::vector<Follower> followers{Follower(facts, position)};
  if (auto const far = farthest_bond(*scene.model, *facts.pair, start.contacts[p], position))
    followers.emplace_back(facts, *far, true);
  for (auto const& secondary : movers_of(all, facts.secondary))
    for (auto const& primary : movers_of(all, facts))
      for (auto& follower : followers)
        follower.follow(scene.part.schedule, secondary, primary);
  facts.motion.beside = moved_beside(all, facts, facts.secondary) ||
                        (facts.primary && moved_beside(all, facts, *facts.primary));
  facts.motion.forced = moved_by_forces(*scene.model, facts);
  add_strain(all, facts);
  facts.tension = tension_of(*scene.model, *facts.pair);
  return facts;
}

} // namespace stiction::scene
