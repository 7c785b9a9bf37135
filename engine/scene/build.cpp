// Names to numbers: bodies, sets, pairs, motions; all complaints are gathered before any is thrown.
#include "scene/build.hpp"

#include <fmt/format.h>
#include <numbers>

#include "mesh/quality.hpp"

namespace stiction::scene {

using contact::Vec2;

namespace {

Vec2 vec(Numbers const& numbers) {
  return {numbers[0], numbers[1]};
}

dynamics::Path path(Numbers const& times, Numbers const& values) {
  if (values.empty())
    return {};
  return {times, values};
}

/// What stands under "name", or under "name[k]" in a list; nothing if there is no such part.
core::Input const* part_of(core::Input const& input, std::string const& key) {
  auto const bracket = key.find('[');
  auto const* table = input.table();
  if (table == nullptr)
    return nullptr;
  auto const found = table->find(key.substr(0, bracket));
  if (found == table->end() || bracket == std::string::npos)
    return found == table->end() ? nullptr : &found->second;
  auto const* list = found->second.list();
  auto const number = std::stoul(key.substr(bracket + 1));
  return list != nullptr && number >= 1 && number <= list->size() ? &(*list)[number - 1] : nullptr;
}

/// Gathers complaints by path and finds the script line of the table that the path leads to.
class Builder {
public:
  explicit Builder(core::Input const& input) : input_(&input) {}

  Scene run() {
    core::Reader reader(*input_, "", complaints_);
    scene_.part = reader.record<ScenePart>();
    settle();
    scene_.model = std::make_unique<dynamics::Model>();
    auto& model = *scene_.model;
    model.kinematics = scene_.part.kinematics;
    model.gravity = vec(scene_.part.gravity);
    model.scheme = scene_.part.scheme;
    model.solver = scene_.part.solver;
    model.control = scene_.part.control;
    add_bodies();
    settle();
    add_motions();
    add_pairs();
    check_probes();
    settle();
    check_overlap();
    settle();
    return std::move(scene_);
  }

private:
  void settle() const {
    if (!complaints_.empty())
      throw core::InputError(complaints_);
  }

  void complain(std::vector<std::string> const& where, std::string text) {
    core::Input const* at = input_;
    std::string place = at->place, full;
    for (auto const& key : where) {
      full += (full.empty() ? "" : ".") + key;
      at = at == nullptr ? nullptr : part_of(*at, key);
      if (at != nullptr && !at->place.empty())
        place = at->place;
    }
    complaints_.push_back({place, full, std::move(text)});
  }

  void add_bodies() {
    auto& model = *scene_.model;
    model.first_node.push_back(0);
    for (auto const& [name, part] : scene_.part.bodies) {
      try {
        auto body = std::make_unique<solid::Body>(
            solid::Body{name, mesh::make(part.mesh), part.material, part.density});
        mesh::check(body->mesh, name);
        check_radius(name, body->mesh);
        model.first_node.push_back(model.first_node.back() + body->mesh.node_count());
        model.bodies.push_back(std::move(body));
        scene_.bodies.push_back(name);
      } catch (core::InputError const& error) {
        for (auto const& complaint : error.complaints())
          complain({"bodies", name, "mesh"}, complaint.message());
      }
    }
    if (scene_.part.bodies.empty())
      complain({"bodies"}, "is empty; a scene needs at least one body");
    settle();
    model.reference.resize(model.first_node.back(), 2);
    model.velocity.resize(model.first_node.back(), 2);
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      auto const count = model.bodies[b]->mesh.node_count();
      model.reference.middleRows(model.first_node[b], count) = model.bodies[b]->mesh.nodes;
      model.velocity.middleRows(model.first_node[b], count).rowwise() =
          vec(scene_.part.bodies.at(scene_.bodies[b]).velocity).transpose();
      model.cells.emplace_back(*model.bodies[b], model.kinematics);
    }
  }

  void check_radius(std::string const& name, mesh::Mesh const& mesh) {
    if (scene_.part.kinematics == solid::Kinematics::axisymmetric && mesh.nodes.col(0).minCoeff() < 0)
      complain({"bodies", name, "mesh"},
               fmt::format("reaches the radius {:g} m; axisymmetric bodies lie at x >= 0",
                           mesh.nodes.col(0).minCoeff()));
  }

  /// Nodes of "body.set", or a complaint naming what there is.
  std::optional<Indices> resolve(std::vector<std::string> const& where, std::string const& name) {
    if (auto nodes = scene_.nodes_of(name))
      return nodes;
    std::vector<std::string> known;
    for (auto const& body : scene_.model->bodies)
      for (auto const& [set, members] : body->mesh.sets)
        known.push_back(body->name + "." + set);
    auto const meant = core::nearest(name, known);
    complain(where, fmt::format("there is no set \"{}\"; known are {}{}", name, fmt::join(known, ", "),
                                meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
    return {};
  }

  void add_motions() {
    auto& model = *scene_.model;
    for (std::size_t k = 0; k < scene_.part.motions.size(); ++k) {
      std::vector<std::string> const where{fmt::format("motions[{}]", k + 1), "set"};
      auto add = [&](std::string const& set, int component, dynamics::Path motion) {
        if (auto nodes = resolve(where, set))
          model.motions.push_back({*nodes, component, std::move(motion)});
      };
      if (auto const* fix = std::get_if<FixPart>(&scene_.part.motions[k])) {
        if (fix->x)
          add(fix->set, 0, {});
        if (fix->y)
          add(fix->set, 1, {});
      } else {
        auto const& drive = std::get<DrivePart>(scene_.part.motions[k]);
        if (!drive.x.empty())
          add(drive.set, 0, path(drive.times, drive.x));
        if (!drive.y.empty())
          add(drive.set, 1, path(drive.times, drive.y));
        check_reach(where, drive.times);
      }
    }
    check_driven_twice();
  }

  void check_reach(std::vector<std::string> const& where, Numbers const& times) {
    auto const& stages = scene_.part.schedule.stages;
    if (times.empty() || stages.empty() || times.back() >= stages.back().until * (1 - 1e-9))
      return;
    complain(
        where,
        fmt::format(
            "its path ends at {:g} s, before the run does at {:g} s; give the path a last point at the end",
            times.back(), stages.back().until));
  }

  void check_driven_twice() {
    auto const& model = *scene_.model;
    std::map<std::pair<Index, int>, std::size_t> owner;
    for (std::size_t m = 0; m < model.motions.size(); ++m)
      for (Index const node : model.motions[m].nodes) {
        auto const [first, fresh] = owner.emplace(std::pair{node, model.motions[m].component}, m);
        auto const& other = model.motions[first->second].path;
        auto const& own = model.motions[m].path;
        if (fresh || (other.times == own.times && other.values == own.values))
          continue;
        complain(
            {"motions"},
            fmt::format(
                "node at ({:g}, {:g}) m is driven in {} by two different motions; take it out of one set",
                model.reference(node, 0), model.reference(node, 1), "xy"[model.motions[m].component]));
        return;
      }
  }

  /// The boundary set behind "body.set" with model node numbers.
  std::optional<mesh::Set> surface(std::vector<std::string> const& where, std::string const& name) {
    if (!resolve(where, name))
      return {};
    auto const dot = name.find('.');
    auto const& model = *scene_.model;
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      if (model.bodies[b]->name != name.substr(0, dot))
        continue;
      mesh::Set set = model.bodies[b]->mesh.sets.find(name.substr(dot + 1))->second;
      for (auto& facet : set.facets)
        for (auto& node : facet.nodes)
          node += model.first_node[b];
      return set;
    }
    return {};
  }

  std::optional<std::vector<contact::Chain>> chains(std::vector<std::string> const& where,
                                                    std::string const& name) {
    auto const set = surface(where, name);
    if (!set)
      return {};
    try {
      return contact::chains_of(*set, name);
    } catch (core::InputError const& error) {
      for (auto const& complaint : error.complaints())
        complain(where, complaint.message());
      return {};
    }
  }

  void add_pairs() {
    for (auto const& [name, part] : scene_.part.pairs) {
      auto const secondary = chains({"pairs", name, "secondary"}, part.secondary);
      bool const rigid = scene_.part.obstacles.contains(part.primary);
      auto const primary = rigid ? std::nullopt : chains({"pairs", name, "primary"}, part.primary);
      if (!secondary || (!rigid && !primary))
        continue;
      scene_.model->pairs.push_back(rigid ? against_obstacle(name, part, *secondary)
                                          : against_curve(name, part, *secondary, *primary));
      scene_.pairs.push_back(name);
    }
  }

  dynamics::Pair secondary_side(std::string const& name, PairPart const& part,
                                std::vector<contact::Chain> const& chains) {
    dynamics::Pair pair{name, {}, {}, dynamics::MovingObstacle{}, part.law, part.reach};
    std::map<Index, std::size_t> number;
    for (auto const& chain : chains)
      for (Index const node : chain.nodes)
        if (number.emplace(node, pair.secondary.size()).second)
          pair.secondary.push_back(node);
    pair.areas.assign(pair.secondary.size(), 0.0);
    for (auto const& chain : chains) {
      auto const n = chain.nodes.size();
      for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < n; ++i) {
        Index const a = chain.nodes[i], b = chain.nodes[(i + 1) % n];
        auto const share = edge_areas(scene_.model->reference.row(a), scene_.model->reference.row(b));
        pair.areas[number.at(a)] += share[0];
        pair.areas[number.at(b)] += share[1];
      }
    }
    return pair;
  }

  /// Integrals of the two shape functions of an edge.
  std::array<double, 2> edge_areas(Vec2 const& a, Vec2 const& b) const {
    double const length = (b - a).norm();
    if (scene_.part.kinematics == solid::Kinematics::plane_strain)
      return {length / 2, length / 2};
    double const turn = 2 * std::numbers::pi * length / 6;
    return {turn * (2 * a.x() + b.x()), turn * (a.x() + 2 * b.x())};
  }

  dynamics::Pair against_curve(std::string const& name, PairPart const& part,
                               std::vector<contact::Chain> const& secondary,
                               std::vector<contact::Chain> const& primary) {
    auto pair = secondary_side(name, part, secondary);
    contact::Curve curve(primary, scene_.model->reference, part.smoothing);
    if (!(pair.reach > 0))
      pair.reach = 0.5 * curve.segment_length();
    pair.primary = std::move(curve);
    return pair;
  }

  dynamics::Pair against_obstacle(std::string const& name, PairPart const& part,
                                  std::vector<contact::Chain> const& secondary) {
    auto pair = secondary_side(name, part, secondary);
    auto const& obstacle = scene_.part.obstacles.at(part.primary);
    pair.primary = dynamics::MovingObstacle{obstacle.shape, path(obstacle.times, obstacle.x),
                                            path(obstacle.times, obstacle.y)};
    check_reach({"obstacles", part.primary, "times"}, obstacle.times);
    if (!(pair.reach > 0)) {
      double total = 0;
      for (auto const& chain : secondary)
        for (std::size_t i = 1; i < chain.nodes.size(); ++i)
          total +=
              (scene_.model->reference.row(chain.nodes[i]) - scene_.model->reference.row(chain.nodes[i - 1]))
                  .norm();
      pair.reach = 0.5 * total / static_cast<double>(pair.secondary.size());
    }
    return pair;
  }

  void check_probes() {
    for (auto const& [name, probe] : scene_.part.probes) {
      std::visit([this, &name = name](auto const& part) { check_probe(name, part); }, probe);
      if (name == "time" || name == "step")
        complain({"probes", name}, "this name is taken by the series itself; choose another");
    }
  }

  template<class Part> void check_probe(std::string const& name, Part const& part) {
    if constexpr (requires { part.pair; })
      check_pair_name({"probes", name, "pair"}, part.pair);
    if constexpr (requires { part.set; })
      static_cast<void>(resolve({"probes", name, "set"}, part.set));
    if constexpr (requires { part.near; })
      if (part.near.size() != 2)
        complain({"probes", name, "near"},
                 fmt::format("has {} numbers; two are wanted: {{x, y}}", part.near.size()));
  }

  void check_pair_name(std::vector<std::string> const& where, std::string const& name) {
    if (scene_.part.pairs.contains(name))
      return;
    std::vector<std::string> known;
    for (auto const& [pair, part] : scene_.part.pairs)
      known.push_back(pair);
    auto const meant = core::nearest(name, known);
    complain(where, fmt::format("there is no pair \"{}\"; known are {}{}", name, fmt::join(known, ", "),
                                meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
  }

  /// A surface that starts inside its counterpart has no admissible first step.
  void check_overlap() {
    dynamics::Stepper stepper(*scene_.model);
    auto const state = stepper.initial();
    for (std::size_t p = 0; p < scene_.model->pairs.size(); ++p) {
      auto const& pair = scene_.model->pairs[p];
      for (std::size_t i = 0; i < state.contacts[p].size(); ++i) {
        auto const& point = state.contacts[p][i];
        if (!point.foot.found() || point.gap > -0.2 * pair.reach)
          continue;
        auto const X = scene_.model->reference.row(pair.secondary[i]);
        complain({"pairs", pair.name}, fmt::format("the surfaces overlap by {:.3g} m at ({:g}, {:g}) m "
                                                   "before the run starts; move one of them apart",
                                                   -point.gap, X[0], X[1]));
        break;
      }
    }
  }

  core::Input const* input_;
  core::Complaints complaints_;
  Scene scene_;
};

} // namespace

std::optional<Indices> Scene::nodes_of(std::string const& name) const {
  auto const dot = name.find('.');
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (dot == std::string::npos || bodies[b] != name.substr(0, dot))
      continue;
    auto const& sets = model->bodies[b]->mesh.sets;
    auto const found = sets.find(name.substr(dot + 1));
    if (found == sets.end())
      return {};
    Indices nodes = found->second.nodes;
    for (auto& node : nodes)
      node += model->first_node[b];
    return nodes;
  }
  return {};
}

Index Scene::pair_index(std::string const& name) const {
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (pairs[p] == name)
      return static_cast<Index>(p);
  return -1;
}

Index Scene::nearest(Indices const& nodes, Numbers const& place) const {
  Index best = nodes.front();
  auto distance = [&](Index node) {
    return (model->reference.row(node).transpose() - vec(place)).squaredNorm();
  };
  for (Index const node : nodes)
    if (distance(node) < distance(best))
      best = node;
  return best;
}

Scene build(core::Input const& input) {
  return Builder(input).run();
}

} // namespace stiction::scene
