// Prescribed displacements of a scene: which nodes they move, and how.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>
#include <span>

#include "scene/build/builder.hpp"

namespace stiction::scene {

void Builder::add_motions() {
  auto const& motions = scene_.part.motions;
  origins_.resize(scene_.model->motions.size());
  for (std::size_t k = 0; k < motions.size(); ++k) {
    Where const where{fmt::format("motions[{}]", k + 1), "set"};
    std::visit(
        [&](auto const& part) {
          check_size({where[0], "near"}, part.near);
          add_motion(where, part);
        },
        motions[k]);
    origins_.resize(scene_.model->motions.size(), {k + 1, set_of(motions[k])});
  }
  check_driven_twice();
}

/// Nodes of the part's set, or the one that is meant.
template<class Part> Indices Builder::moved(Where const& where, Part const& part) {
  auto const nodes = resolve(where, part.set);
  if (!nodes || part.near.empty())
    return nodes.value_or(Indices{});
  return {scene_.nearest(*nodes, part.near)};
}

void Builder::add_motion(Where const& where, FixPart const& part) {
  auto const nodes = moved(where, part);
  std::array const held{part.x, part.y, part.z};
  if (std::ranges::none_of(std::span(held).first(ix(scene_.part.dim())), [](bool one) { return one; }))
    complain({where[0]}, "holds no component; name one of x, y, z as true, or leave all out to hold all");
  for (int c = 0; c < scene_.part.dim() && !nodes.empty(); ++c)
    if (held[ix(c)])
      scene_.model->motions.push_back({nodes, c, {}, part.set});
}

void Builder::add_motion(Where const& where, DrivePart const& part) {
  check_no_z({where[0], "z"}, part.z);
  check_path_end(where, part.times);
  check_components(where, part);
  auto const nodes = moved(where, part);
  std::array const values{&part.x, &part.y, &part.z};
  for (int c = 0; c < scene_.part.dim() && !nodes.empty(); ++c)
    if (!values[ix(c)]->empty())
      scene_.model->motions.push_back({nodes, c, path(part.times, *values[ix(c)]), part.set});
}

void Builder::check_turn(Where const& where, TurnPart const& part) {
  check_no_z({where[0], "z"}, part.z);
  check_path_end(where, part.times);
  check_size({where[0], "centre"}, part.centre);
  if (!part.axis.empty() && (part.axis.size() != 3 || vec(part.axis).isZero(0)))
    complain({where[0], "axis"}, "wants three numbers, not all 0");
  else if (scene_.part.dim() == 2 && !part.axis.empty() && !vec(part.axis).head(2).isZero(0))
    complain({where[0], "axis"}, "leaves the plane of a plane scene; leave it out");
  if (scene_.part.kinematics == solid::Kinematics::axisymmetric)
    complain({where[0]},
             "turns a set, which would leave the symmetry about the axis of an axisymmetric scene; "
             "use stiction.motion.drive, or another kinematics");
}

/// One motion for each component of each node, as each has its own arm.
void Builder::add_motion(Where const& where, TurnPart const& part) {
  check_turn(where, part);
  auto& model = *scene_.model;
  auto const angle = std::make_shared<dynamics::Path const>(path(part.times, part.angle));
  std::array const shifts{&part.x, &part.y, &part.z};
  Vec3 const axis = part.direction();
  for (Index const node : moved(where, part)) {
    Vec3 arm = -vec(part.centre);
    arm.head(model.dim()) += model.reference.row(node).transpose();
    arm -= axis.dot(arm) * axis;
    Vec3 const along = axis.cross(arm);
    for (int c = 0; c < model.dim(); ++c)
      model.motions.push_back(
          {{node}, c, path(part.times, *shifts[ix(c)]), part.set, dynamics::Turn{angle, arm[c], along[c]}});
  }
}

namespace {

/// Parts of a stretch between knots at which turns are looked at too, as they are no straight lines:
/// irrational, so that what has turned by whole circles at both ends has not here.
constexpr std::array between{0.3819660112501051, 0.6180339887498949};

/// The first time up to `end`, of those that matter, at which two motions of a node differ by more than
/// rounding, s.
std::optional<double> first_difference(dynamics::Motion const& one, dynamics::Motion const& other,
                                       double end) {
  double const largest = std::max(one.farthest(), other.farthest());
  for (double const t : compared_at({&one, &other}, end))
    if (std::abs(one.value(t) - other.value(t)) > 1e-12 * largest)
      return t;
  return {};
}

} // namespace

std::set<double> compared_at(std::vector<dynamics::Motion const*> const& motions, double end) {
  std::set<double> knots{end};
  bool turns = false;
  for (auto const* motion : motions) {
    knots.insert(motion->path.times.begin(), motion->path.times.end());
    if (motion->turn)
      knots.insert(motion->turn->angle->times.begin(), motion->turn->angle->times.end());
    turns = turns || motion->turn;
  }
  std::set<double> times = knots;
  for (auto knot = knots.begin(); std::next(knot) != knots.end() && turns; ++knot)
    for (double const part : between)
      times.insert(*knot + part * (*std::next(knot) - *knot));
  times.erase(times.upper_bound(end), times.end());
  return times;
}

/// Two motions may drive a node alike, as where a held and a driven set share a corner.
void Builder::check_driven_twice() {
  auto const& model = *scene_.model;
  double const end = scene_.part.schedule.stages.back().until;
  std::map<std::pair<Index, int>, std::size_t> owner;
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    for (Index const node : model.motions[m].nodes) {
      auto const [first, fresh] = owner.emplace(std::pair{node, model.motions[m].component}, m);
      auto const& other = model.motions[first->second];
      auto const& own = model.motions[m];
      auto const differ = fresh ? std::nullopt : first_difference(other, own, end);
      if (!differ)
        continue;
      auto const X = model.reference.row(node);
      auto const& [earlier, earlier_set] = origins_[first->second];
      auto const& [later, later_set] = origins_[m];
      complain({fmt::format("motions[{}]", later)},
               fmt::format("moves {0} in {1} other than motions[{2}] moves {3}, and both hold the node at "
                           "({4:g}) m: at t = {5:g} s to {6:g} m and to {7:g} m; give both the same path, "
                           "leave {1} out of one, or take the node out of one set",
                           later_set, "xyz"[model.motions[m].component], earlier, earlier_set,
                           fmt::join(X.data(), X.data() + X.size(), ", "), *differ, own.value(*differ),
                           other.value(*differ)));
      return;
    }
}

} // namespace stiction::scene
