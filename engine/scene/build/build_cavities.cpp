// Where the wall of a cavity may end, and what of the cavity moves with its end.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>

#include "scene/build/builder.hpp"
#include "solid/facets.hpp"

namespace stiction::scene {

namespace {

/// Of each facet: sides that no other facet of the surface has, where it is open.
std::vector<std::vector<int>> open_sides(std::vector<mesh::Facet> const& facets, int dim) {
  auto const corners = [&](mesh::Facet const& facet, int side) {
    auto nodes = solid::corners_of(facet, side, dim);
    std::ranges::sort(nodes);
    return nodes;
  };
  std::map<Indices, int> count;
  for (auto const& facet : facets)
    for (int k = 0; k < solid::sides_of(facet.nodes.size(), dim); ++k)
      ++count[corners(facet, k)];
  std::vector<std::vector<int>> open(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (int k = 0; k < solid::sides_of(facets[f].nodes.size(), dim); ++k)
      if (count[corners(facets[f], k)] == 1)
        open[f].push_back(k);
  return open;
}

std::set<Index> rim_of(std::vector<mesh::Facet> const& facets, int dim) {
  std::set<Index> rim;
  auto const open = open_sides(facets, dim);
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (int const side : open[f])
      for (Index const node : solid::corners_of(facets[f], side, dim))
        rim.insert(node);
  return rim;
}

double size_of(dynamics::Model const& model) {
  return model.reference.colwise().norm().maxCoeff();
}

bool on_seal(dynamics::Model const& model, dynamics::Gas const& gas, Index node) {
  Vector const off = model.reference.row(node).transpose() - gas.centre.head(model.dim());
  return gas.seal && std::abs(off.dot(gas.seal->normal.head(model.dim()))) < 1e-9 * size_of(model);
}

/// The motion of every degree of freedom that has one.
std::map<Index, std::size_t> driven_by(dynamics::Model const& model) {
  std::map<Index, std::size_t> driven;
  for (std::size_t m = 0; m < model.motions.size(); ++m)
    for (Index const node : model.motions[m].nodes)
      driven.emplace(model.dim() * node + model.motions[m].component, m);
  return driven;
}

/// What holds the end of a wall: motions, by degree of freedom, of all that are driven.
struct Hold {
  dynamics::Model const* model;
  std::map<Index, std::size_t> motions, driven;
  [[nodiscard]] double way(Index dof, double t) const { return model->motions[driven.at(dof)].value(t); }
  [[nodiscard]] bool turned(Index node) const {
    auto const one = driven.find(model->dim() * node);
    return one != driven.end() && model->motions[one->second].turn.has_value();
  }
  [[nodiscard]] double farthest() const {
    double most = 0;
    for (auto const& [dof, m] : motions)
      most = std::max(most, model->motions[m].farthest());
    return most;
  }
  [[nodiscard]] std::set<double> times(double end) const {
    std::set<double> all;
    for (auto const& [dof, m] : motions)
      all.merge(compared_at({&model->motions[m]}, end));
    return all;
  }
  /// Component of the way of what is carried.
  [[nodiscard]] double way(std::vector<dynamics::Carrier> const& carriers, int component, double t) const {
    double sum = 0;
    for (auto const& one : carriers)
      if (one.component == component)
        sum += one.part * way(one.dof, t);
    return sum;
  }
};

/// Two nodes that turn about an axis.
struct Arm {
  Vec3 axis;
  std::array<Index, 2> nodes;
};

/// How a point moves with these: by u_0 + B (u_1 - u_0), where B takes the arm between the nodes, across the
/// axis, to that of the point.
std::vector<dynamics::Carrier> carried(dynamics::Model const& model, Arm const& arm, Vec3 const& point) {
  Vec3 const &axis = arm.axis, from = middle_of(model, {arm.nodes[0]});
  Eigen::Matrix3d const across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  Eigen::Matrix3d turned;
  for (int c = 0; c < 3; ++c)
    turned.col(c) = axis.cross(Vec3::Unit(c));
  Vec3 const own = across * (middle_of(model, {arm.nodes[1]}) - from), way = across * (point - from);
  Eigen::Matrix3d const B = (way.dot(own) * across + way.dot(turned * own) * turned) / own.squaredNorm();
  std::vector<dynamics::Carrier> carriers;
  int const dim = model.dim();
  for (int c = 0; c < dim; ++c)
    for (int k = 0; k < dim; ++k) {
      carriers.push_back({c, dim * arm.nodes[0] + k, (c == k ? 1.0 : 0.0) - B(c, k)});
      carriers.push_back({c, dim * arm.nodes[1] + k, B(c, k)});
    }
  return carriers;
}

/// Along each component with one of those that are moved in it.
std::vector<dynamics::Carrier> carried_along(Hold const& hold) {
  std::vector<dynamics::Carrier> carriers;
  std::set<int> seen;
  for (auto const& [dof, m] : hold.motions)
    if (int const c = static_cast<int>(dof % hold.model->dim()); seen.insert(c).second)
      carriers.push_back({c, dof});
  return carriers;
}

} // namespace

/// A wall may end where a motion keeps its end in a plane of symmetry, on the axis, or where it is held: then
/// the rest of the cavity, a cone up to the centre, stays as it is or moves with the end.
void Builder::check_cavity(Where const& where, dynamics::Gas& gas) {
  auto const& model = *scene_.model;
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  Hold hold{&model, {}, driven_by(model)};
  double const size = size_of(model);
  auto const kept = [&](Index node) {
    std::vector<int> all, in_plane;
    for (int c = 0; c < model.dim(); ++c) {
      bool const there = revolved ? c == 1 : std::abs(model.reference(node, c) - gas.centre[c]) < 1e-9 * size;
      if (hold.driven.contains(model.dim() * node + c))
        (there ? in_plane : all).push_back(c);
    }
    bool const held = static_cast<int>(all.size() + in_plane.size()) == model.dim();
    bool const rigid = (in_plane.empty() && held) || hold.turned(node);
    for (int c = 0; c < model.dim(); ++c)
      if (auto const one = hold.driven.find(model.dim() * node + c);
          one != hold.driven.end() && (rigid || std::ranges::count(in_plane, c) > 0))
        hold.motions.insert(*one);
    return held || !in_plane.empty();
  };
  for (Index const node : rim_of(gas.facets, model.dim()))
    if (!on_seal(model, gas, node) && !(revolved && model.reference(node, 0) == 0) && !kept(node))
      return complain(
          where, fmt::format("\"{}\" is no cavity: it is open at {}; name all of its wall, or let "
                             "that end at planes of symmetry through `centre` that motions keep it in, where "
                             "motions hold it altogether, or on its `seal`",
                             gas.set, words(middle_of(model, {node}), model.dim())));
  if (!revolved && hold.farthest() > 0) // about the axis the rest are discs across it, wherever they are
    carry_centre(where, gas, hold.motions);
}

/// The centre moves with the wall's end, which has to move as one rigid body. motions: those that hold the
/// end, by degree of freedom.
void Builder::carry_centre(Where const& where, dynamics::Gas& gas,
                           std::map<Index, std::size_t> const& motions) {
  auto const& model = *scene_.model;
  int const dim = model.dim();
  Hold const hold{&model, motions, driven_by(model)};
  auto const arm = turning_arm(motions);
  auto const carriers_of = [&](Vec3 const& point) {
    return arm ? carried(model, {arm->first, arm->second}, point) : carried_along(hold);
  };
  double const rounding = 1e-9 * (hold.farthest() + size_of(model));
  gas.carriers = carriers_of(gas.centre);
  for (double const t : hold.times(scene_.part.schedule.stages.back().until)) {
    for (auto const& [dof, m] : motions) {
      auto const X = middle_of(model, {dof / dim});
      double const off =
          std::abs(hold.way(dof, t) - hold.way(carriers_of(X), static_cast<int>(dof % dim), t));
      if (off > rounding)
        return complain(
            where, fmt::format("\"{}\" ends where motions do not move it as one rigid body: at t = {:g} s "
                               "they take {} by {:.3g} m elsewhere, and nothing says what the rest of the "
                               "cavity is then; name all of its wall, with what closes it there, or move "
                               "its ends alike",
                               gas.set, t, words(X, dim), off));
    }
    double off = 0;
    for (int c = 0; c < dim && gas.seal; ++c)
      off += gas.seal->normal[c] * hold.way(gas.carriers, c, t);
    if (std::abs(off) > rounding)
      return complain(where,
                      fmt::format("\"{}\" ends on a `seal`, which stays where it is, and where motions "
                                  "take `centre` {:.3g} m off it at t = {:g} s; let it end elsewhere in "
                                  "planes of symmetry square to the seal",
                                  gas.set, std::abs(off), t));
  }
}

/// The axis about which these motions turn the end first, and two nodes, of all that turn so, that are not
/// both at one place along it.
std::optional<std::pair<Vec3, std::array<Index, 2>>>
Builder::turning_arm(std::map<Index, std::size_t> const& motions) const {
  auto const& model = *scene_.model;
  auto const turns = [&](auto const& one) { return model.motions[one.second].turn.has_value(); };
  auto const first = std::ranges::find_if(motions, turns);
  if (first == motions.end())
    return {};
  auto const number = origins_[first->second].first;
  Vec3 const axis = std::get<TurnPart>(scene_.part.motions[number - 1]).direction();
  Index const node = first->first / model.dim();
  Index farthest = node;
  double reach = 0;
  for (std::size_t m = 0; m < origins_.size(); ++m)
    if (origins_[m].first == number) {
      Index const other = model.motions[m].nodes.front(); // a turn has motions of its own for each node
      double const arm = axis.cross(middle_of(model, {other}) - middle_of(model, {node})).norm();
      if (arm > reach)
        farthest = other;
      reach = std::max(reach, arm);
    }
  if (farthest == node)
    return {};
  return std::pair{axis, std::array{node, farthest}};
}

/// What of the wall's end is on the seal, but not on the axis.
void Builder::add_seal(Where const& where, GasPart const& part, dynamics::Gas& gas) {
  auto const& model = *scene_.model;
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  check_size({where[0], "seal"}, part.seal);
  if (vec(part.seal).isZero(0))
    return complain({where[0], "seal"}, "is no direction; give numbers that are not all 0");
  if (revolved && part.seal.front() != 0)
    return complain({where[0], "seal"}, "is the normal of a plane, which about an axis is along it: {0, 1}");
  gas.seal = dynamics::Seal{{}, {}, vec(part.seal).normalized(), part.leaks_at};
  auto const on = [&](Index node) { return on_seal(model, gas, node); };
  for (Index const node : rim_of(gas.facets, model.dim()))
    if (on(node) && !(revolved && model.reference(node, 0) == 0))
      gas.seal->rim.push_back(node);
  gas.seal->sides = open_sides(gas.facets, model.dim());
  for (std::size_t f = 0; f < gas.facets.size(); ++f)
    std::erase_if(gas.seal->sides[f], [&](int side) {
      return !std::ranges::all_of(solid::corners_of(gas.facets[f], side, model.dim()), on);
    });
  if (gas.seal->rim.empty())
    complain({where[0], "seal"},
             fmt::format("has no end of \"{}\" on it; give the normal of the plane through "
                         "`centre` that the wall stands on",
                         part.set));
}

} // namespace stiction::scene
