// Probes of a scene: do the names and points that they give exist?
#include <algorithm>
#include <fmt/format.h>

#include "scene/build/builder.hpp"

namespace stiction::scene {

void Builder::check_probes() {
  for (auto const& [name, probe] : scene_.part.probes) {
    std::visit([this, &name = name](auto const& part) { check_probe(name, part); }, probe);
    if (name == "time" || name == "step")
      complain({"probes", name}, "this name is taken by the series itself; choose another");
  }
}

namespace {
template<class Map> std::vector<std::string> names(Map const& map) {
  std::vector<std::string> all;
  all.reserve(map.size());
  for (auto const& [name, part] : map)
    all.push_back(name);
  return all;
}
} // namespace

void Builder::check_about(Where const& where, Numbers const& about) {
  check_size(where, about);
  if (!about.empty() && scene_.part.kinematics == solid::Kinematics::axisymmetric)
    complain(where, "an axisymmetric scene has no moments nor angular momentum; leave it out");
}

void Builder::check_momentum(Where const& where) {
  if (!dynamics::weights(scene_.part.scheme).inertia)
    complain(where, "a quasi-static scheme has no momentum; choose another scheme or leave the "
                    "probe out");
}

void Builder::check_patch(Where const& where, ContactProbe const& part) {
  Index const p = scene_.pair_index(part.pair);
  auto const nodes = part.set.empty() || p < 0 ? std::nullopt : resolve(where, part.set);
  if (!nodes)
    return;
  auto const& points = scene_.model->pairs[ix(p)].secondary;
  if (std::ranges::none_of(*nodes,
                           [&](Index node) { return std::ranges::find(points, node) != points.end(); }))
    complain(where,
             fmt::format("\"{}\" has none of the points of pair {}, which are on {}; name a set of that "
                         "surface",
                         part.set, part.pair, scene_.part.pairs.at(part.pair).secondary));
}

void Builder::check_gas(Where const& where, GasProbe const& part) {
  std::vector<std::string> known;
  for (auto const& load : scene_.part.loads)
    if (auto const* gas = std::get_if<GasPart>(&load))
      known.push_back(gas->set);
  if (std::ranges::find(known, part.set) == known.end())
    unknown_name(where, "load.gas in", part.set, known);
}

template<class Part> void Builder::check_probe(std::string const& name, Part const& part) {
  if constexpr (requires { part.pair; })
    if (!scene_.part.pairs.contains(part.pair))
      unknown_name({"probes", name, "pair"}, "pair", part.pair, names(scene_.part.pairs));
  if constexpr (requires { part.obstacle; })
    if (!scene_.part.obstacles.contains(part.obstacle))
      unknown_name({"probes", name, "obstacle"}, "obstacle", part.obstacle, names(scene_.part.obstacles));
  if constexpr (requires { part.spring; })
    if (!scene_.part.springs.contains(part.spring))
      unknown_name({"probes", name, "spring"}, "spring", part.spring, names(scene_.part.springs));
  if constexpr (requires { part.set; })
    if (scene_.part.obstacles.contains(part.set))
      return complain(
          {"probes", name, "set"},
          fmt::format("\"{0}\" is an obstacle, not a set of a body; where it is and what acts on it "
                      "shows stiction.probe.rigid {{ obstacle = \"{0}\" }}",
                      part.set));
  if constexpr (std::is_same_v<Part, GasProbe>)
    check_gas({"probes", name, "set"}, part);
  else if constexpr (std::is_same_v<Part, ContactProbe>)
    check_patch({"probes", name, "set"}, part);
  else if constexpr (requires { part.set; })
    static_cast<void>(resolve({"probes", name, "set"}, part.set));
  if constexpr (requires { part.near; })
    check_size({"probes", name, "near"}, part.near);
  if constexpr (requires { part.about; })
    check_about({"probes", name, "about"}, part.about);
  if constexpr (std::is_same_v<Part, MomentumProbe>)
    check_momentum({"probes", name});
}

} // namespace stiction::scene
