// Springs of a scene: their ends, their directions, what they cannot have.
#include <fmt/format.h>

#include "mesh/topology/traction.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

using dynamics::SpringAlong;
using dynamics::SpringEnd;

void Builder::add_springs() {
  for (auto const& [name, part] : scene_.part.springs)
    add_spring({"springs", name}, part);
}

namespace {

/// Of each node in the mean of a set: its share of the area, or of the mass where the set is no surface.
std::vector<double> shares_in(dynamics::Model const& model, std::size_t body, mesh::Set const& set) {
  auto const& mesh = model.bodies[body]->mesh;
  Vector all = Vector::Zero(mesh.node_count());
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  for (auto const& facet : set.facets) {
    Vector const integrals = mesh::shape_integrals(mesh.nodes, facet, revolved);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i)
      all[facet.nodes[i]] += integrals[static_cast<Eigen::Index>(i)];
  }
  if (set.facets.empty())
    model.cells[body].each_mass([&](std::span<Index const> nodes, Dense const& m) {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        all[nodes[k]] += m.row(static_cast<Eigen::Index>(k)).sum();
    });
  double sum = 0;
  for (Index const node : set.nodes)
    sum += all[node];
  std::vector<double> shares;
  shares.reserve(set.nodes.size());
  for (Index const node : set.nodes)
    shares.push_back(all[node] / sum);
  return shares;
}

} // namespace

/// The mean of a set, the pivot of a free obstacle, or the pivot that an obstacle's paths carry.
std::optional<SpringEnd> Builder::spring_end(Where const& where, std::string const& name) {
  auto const& model = *scene_.model;
  SpringEnd end;
  for (auto const& rigid : model.rigids)
    if (rigid.name == name) {
      end.at = rigid.pivot;
      if (!rigid.free()) {
        end.shift = rigid.shift;
        return end;
      }
      end.nodes = {rigid.node};
      end.shares = {1};
      return end;
    }
  auto nodes = resolve(where, name);
  if (!nodes)
    return {};
  end.nodes = *std::move(nodes);
  auto const dot = name.find('.');
  std::size_t body = 0;
  while (scene_.bodies[body] != name.substr(0, dot))
    ++body;
  end.shares = shares_in(model, body, model.bodies[body]->mesh.sets.find(name.substr(dot + 1))->second);
  for (std::size_t k = 0; k < end.nodes.size(); ++k)
    end.at.head(model.dim()) += end.shares[k] * model.reference.row(end.nodes[k]).transpose();
  return end;
}

void Builder::check_spring(Where const& where, SpringPart const& part) {
  auto const at = [&](char const* key) { return Where{where[0], where[1], key}; };
  bool const revolved = scene_.part.kinematics == solid::Kinematics::axisymmetric;
  auto const weights = dynamics::weights(scene_.part.scheme);
  check_size(at("anchor"), part.anchor);
  check_size(at("direction"), part.direction);
  check_size(at("axes"), part.axes);
  check_no_z(at("z"), part.z);
  check_path_end(at("times"), part.times);
  if (!part.direction.empty() && vec(part.direction).isZero(0))
    complain(at("direction"), "is no direction: all its numbers are 0");
  if (!part.axes.empty() && (vec(part.axes).minCoeff() < 0 || vec(part.axes).isZero(0)))
    complain(at("axes"), "wants parts of at least 0, not all 0");
  if (part.damping > 0 && !weights.inertia)
    complain(at("damping"), "a quasi-static run has no rates; leave it out or use scheme.theta_xi");
  if (part.damping > 0 && weights.explicit_forces)
    complain(at("damping"), "would lower the stability limit of scheme.central_difference and lag by a step; "
                            "leave it out or use an implicit scheme");
  if (!revolved || part.spread)
    return;
  if (part.along == SpringAlong::line)
    complain(at("along"),
             "in an axisymmetric scene the mean of a set lies on the axis; use direction = {0, 1}");
  if ((!part.direction.empty() && part.direction[0] != 0) || (!part.axes.empty() && part.axes[0] != 0))
    complain(at(part.direction.empty() ? "axes" : "direction"),
             "acts along x, where the mean of a ring does not move; use {0, 1}, or spread = true");
}

/// Along what it acts, and its elongation at the start; ends are known.
void Builder::set_spring_way(Where const& where, SpringPart const& part, dynamics::Spring& spring) {
  spring.along = part.direction.empty() ? part.along : SpringAlong::direction;
  spring.axes.setZero();
  spring.axes.head(scene_.part.dim()).setOnes();
  if (!part.axes.empty())
    spring.axes = vec(part.axes);
  else if (scene_.part.kinematics == solid::Kinematics::axisymmetric && !part.spread)
    spring.axes.x() = 0;
  if (spring.along == SpringAlong::axes)
    return;
  double const length = spring.along == SpringAlong::line
                            ? spring.start().norm()
                            : vec(part.direction).normalized().dot(spring.start());
  if (spring.along == SpringAlong::line && length == 0)
    return complain(
        {where[0], where[1], "along"},
        "is \"line\", but both ends are at the same place at the start; give an anchor elsewhere, "
        "or a direction");
  if (spring.along == SpringAlong::line && part.rest < 0)
    return complain({where[0], where[1], "rest"},
                    fmt::format("is {:g} m; a length is at least 0", part.rest));
  spring.direction = spring.along == SpringAlong::line ? Vec3(spring.start() / length)
                                                       : Vec3(vec(part.direction).normalized());
  spring.stretch = part.rests ? length - part.rest : 0;
}

void Builder::add_spring(Where const& where, SpringPart const& part) {
  auto const complaints = complaints_.size();
  check_spring(where, part);
  dynamics::Spring spring;
  spring.name = where[1];
  spring.stiffness = part.stiffness;
  spring.damping = part.damping;
  spring.spread = part.spread;
  auto from = spring_end({where[0], where[1], "from"}, part.from);
  auto to = part.to.empty() ? SpringEnd{} : spring_end({where[0], where[1], "to"}, part.to);
  if (!from || !to || complaints_.size() > complaints)
    return;
  if (from->nodes.empty())
    return complain(
        {where[0], where[1], "from"},
        fmt::format("\"{}\" is an obstacle that its paths carry; name it in `to`, and in `from` what "
                    "it pulls",
                    part.from));
  if (part.from == part.to)
    return complain({where[0], where[1], "to"}, "is `from` itself; name another end");
  if (part.spread && (!to->nodes.empty() || scene_.part.obstacles.contains(part.from)))
    return complain(
        {where[0], where[1], "spread"},
        "is for the nodes of a set and a place, or an obstacle that its paths carry; leave it out");
  spring.from = *std::move(from);
  spring.to = *std::move(to);
  if (part.to.empty()) {
    spring.to.at = part.anchor.empty() ? spring.from.at : vec(part.anchor);
    spring.to.shift = {path(part.times, part.x), path(part.times, part.y), path(part.times, part.z)};
  }
  set_spring_way(where, part, spring);
  scene_.model->springs.push_back(std::move(spring));
}

} // namespace stiction::scene
