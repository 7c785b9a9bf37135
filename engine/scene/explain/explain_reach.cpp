// Whether a half space in place of a block would do, and what keeps it from it.
#include <algorithm>
#include <fmt/format.h>
#include <numbers>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "scene/explain/reach.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

namespace {

constexpr double same_place = 1e-6; // of the extent

/// Is the bound of what strain changes measured for this law? Of others it is not known: with Blatz-Ko, Ogden
/// and steep Yeoh laws, and below Poisson's ratio 0, it was broken by up to 2.4 times.
struct IsMeasured {
  template<class Law> bool operator()(Law const& law) const {
    if constexpr (requires { law.dent_is_measured(); })
      return law.dent_is_measured();
    return false;
  }
};

/// Nothing but one block, one rigid counterpart and, at most, adhesion along the normal.
bool plain(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  auto const& body = *all.bodies.front().body;
  auto const& law = pair.pair->law;
  bool const free_of_loads = model.gravity.isZero(0) && model.loads.empty() && model.springs.empty() &&
                             model.pressures.empty() && model.gases.empty() &&
                             model.surface_stresses.empty() && model.links.empty();
  return all.scene->part.kinematics == solid::Kinematics::axisymmetric && !all.dynamic() &&
         all.bodies.size() == 1 && all.pairs.size() == 1 && !pair.primary && free_of_loads &&
         body.relaxing.empty() && !body.damping && body.laws.empty() && !law.tangential() &&
         !(law.adhesion && interface::bond_time(*law.adhesion) > 0);
}

/// A profile that only rises from the axis, relative to the surface it is pressed into.
struct Profile {
  double radius = 0; ///< of a sphere, m; 0: of another shape
  double most = 0;   ///< radius up to which it lies within the depth, m
};

/// Radius at which a line from the axis has risen by this much, the side of the surface being `up`; 0 where
/// it does not start at the axis, falls or ends before.
double reached(contact::RigidPolyline const& line, double up, double depth) {
  auto const& points = line.points;
  std::vector<Vec3> corners;
  corners.reserve(points.size() / 2);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2)
    corners.emplace_back(points[i], up * points[i + 1], 0);
  if (corners.front().x() > corners.back().x())
    std::ranges::reverse(corners);
  if (line.closed || corners.front().x() != 0)
    return 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Vec3 const &from = corners[i - 1], &to = corners[i];
    double const left = corners.front().y() + depth - from.y();
    if (to.x() < from.x() || to.y() < from.y())
      return 0;
    if (to.y() - from.y() >= left)
      return from.x() + (to.x() - from.x()) * left / (to.y() - from.y());
  }
  return 0;
}

/// Nothing where the counterpart is neither a sphere nor a profile, or not about the axis.
std::optional<Profile> profile_of(Facts const& all, PairFacts const& pair) {
  auto const& shape = all.scene->model->rigids[pair.rigid].shape;
  auto const* circle = std::get_if<contact::RigidCircle>(&shape); // off the axis a torus
  bool const off_axis = circle != nullptr && !circle->centre.empty() && circle->centre[0] != 0;
  if (pair.radius > 0 && !off_axis)
    return Profile{pair.radius, 0};
  auto const* line = std::get_if<contact::RigidPolyline>(&shape);
  double const most =
      line != nullptr && !pair.adheres() ? reached(*line, pair.normal.y(), pair.motion.depth) : 0;
  return most > 0 ? std::optional(Profile{0, most}) : std::nullopt;
}

/// How the far side is held; nothing where it is not, or where something else is.
std::optional<bool> base_sticks(dynamics::Model const& model, double base, double extent) {
  std::array<std::size_t, 2> held{}, wanted{};
  auto const& nodes = model.reference;
  for (Index i = 0; i < model.node_count(); ++i)
    wanted[0] += std::abs(nodes(i, 1) - base) < same_place * extent ? 1 : 0;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes) {
      bool const at_base = std::abs(nodes(node, 1) - base) < same_place * extent;
      if (!at_base && (motion.component != 0 || nodes(node, 0) != 0))
        return {};
      held[ix(motion.component)] += at_base ? 1 : 0;
    }
  bool const lies = held[1] >= wanted[0], sticks = held[0] + 1 >= wanted[0]; // the axis holds one itself
  if (!lies || (!sticks && held[0] > 1))
    return {};
  return sticks;
}

/// Thickness and radius of a body that is all between its surface and its base.
bool is_block(Facts const& all, PairFacts const& pair) {
  auto const& body = all.bodies.front();
  auto const& nodes = all.scene->model->reference;
  double const L = body.sides.x(), h = body.sides.y();
  double const full = std::numbers::pi * L * L * h * body.body->density;
  bool const to_the_rim = std::ranges::any_of(
      pair.pair->secondary, [&](Index node) { return nodes(node, 0) >= (1 - same_place) * L; });
  return pair.secondary_fit.kind == ShapeFit::flat && std::abs(pair.normal.y()) > 1 - same_place &&
         nodes.col(0).minCoeff() == 0 && std::abs(body.mass - full) < 1e-3 * full && to_the_rim;
}

/// What the depth and the adhesion make of the contact.
void add_contact(PairFacts const& pair, Profile const& profile, Reach& reach) {
  double const depth = pair.motion.depth;
  if (profile.radius == 0) {
    reach.contact = profile.most;
    reach.slope = depth / profile.most;
    return;
  }
  double const R = profile.radius, E = pair.modulus;
  auto const scales = pair.adheres() ? interface::scales(*pair.pair->law.adhesion) : interface::Scales {};
  reach.contact = contact_radius(depth, R, scales.work / E);
  reach.slope = std::max(reach.contact / R, scales.strength / E);
  if (!(scales.work > 0))
    return;
  double const a3 = std::pow(reach.contact, 3), pressing = 4 * E * a3 / (3 * R);
  double const pulling = std::sqrt(8 * std::numbers::pi * scales.work * E * a3);
  double const held = 1.5 * std::numbers::pi * scales.work * R;
  reach.balance = std::max(1.0, (pressing + pulling) / std::max(std::abs(pressing - pulling), held));
}

/// The numbers of the estimate, or nothing where it does not apply.
std::optional<Reach> reach_of(Facts const& all, PairFacts const& pair) {
  auto const& bulk = all.bodies.front();
  if (!plain(all, pair) || bulk.moduli.poisson < 0 || !std::visit(IsMeasured{}, bulk.body->material) ||
      pair.motion.unknown || pair.motion.sliding > 0 || !is_block(all, pair) ||
      !(pair.motion.depth > 0 || pair.adheres()))
    return {};
  auto const profile = profile_of(all, pair);
  auto const& nodes = all.scene->model->reference;
  double const base = pair.normal.y() > 0 ? nodes.col(1).minCoeff() : nodes.col(1).maxCoeff();
  auto const& body = all.bodies.front();
  auto const sticks = base_sticks(*all.scene->model, base, body.extent());
  if (!profile || !sticks)
    return {};
  Reach reach{.thickness = body.sides.y(),
              .width = body.sides.x(),
              .poisson = body.moduli.poisson,
              .stuck = *sticks,
              .small_strain = solid::small_strain(body.body->material)};
  add_contact(pair, *profile, reach);
  if (!reach.small_strain)
    reach.softening = std::max(
        0.0, 1 - kept_stiffness(body.body->material, 0.4 * reach.slope * pair.modulus / body.moduli.young));
  return reach;
}

std::string verdict(ReachError const& error) {
  for (double const share : {0.01, 0.03, 0.1})
    if (error.total() <= share)
      return fmt::format("would do to {}", percent(share));
  return "would not do";
}

} // namespace

void add_half_space(Facts const& all, PairFacts const& pair, Section& section) {
  auto const reach = reach_of(all, pair);
  if (!reach)
    return;
  auto const error = error_of(*reach);
  section.lines.push_back(
      {"half space", verdict(error), error.total(), "1",
       fmt::format(
           "beside its force at the same approach the block's is larger by the base, at most about {} "
           "(a/h {:.2g}), or smaller by the sides, {} (a/L {:.2g}); strain changes it by {} ({} {:.2g})",
           percent(error.base), reach->contact / reach->thickness, percent(error.sides),
           reach->contact / reach->width, percent(std::max(error.larger, error.smaller)),
           pair.radius > 0 ? "a/R" : "depth/a", reach->slope)});
}

} // namespace stiction::scene
