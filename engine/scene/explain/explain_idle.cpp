// What a scene gives and what does nothing in it.
#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

void warn_of_parameters(std::string const& owner, core::Schema const& schema, void const* object,
                        std::vector<Warning>& warnings) {
  for (auto const* parameter : schema.idle(object))
    warnings.push_back({fmt::format("{}: {} of {} acts only where {}", owner, parameter->name, schema.name,
                                    parameter->where),
                        fmt::format("leave {} out", parameter->name)});
}

/// Is a node of the set moved, held or bound to others?
bool any_held(dynamics::Model const& model, Indices const& nodes) {
  std::unordered_set<Index> const all(nodes.begin(), nodes.end());
  auto const among = [&](Index node) { return all.contains(node); };
  auto const dim = model.dim();
  return std::ranges::any_of(model.motions,
                             [&](auto const& motion) { return std::ranges::any_of(motion.nodes, among); }) ||
         std::ranges::any_of(model.links, [&](dynamics::Link const& link) {
           return among(link.dof / dim) || std::ranges::any_of(link.masters, [&](auto const& master) {
                    return among(master.first / dim);
                  });
         });
}

/// A path that the run ends before: all stays as at its start.
void warn_of_late(std::string const& owner, core::Numbers const& times, double end,
                  std::vector<Warning>& warnings) {
  if (!times.empty() && times.front() >= end)
    warnings.push_back({fmt::format("{}: its path begins at {}, the run ends at {}: it does not move", owner,
                                    human(times.front(), "s"), human(end, "s")),
                        "times within the run, or a stage to the end of the path"});
}

void warn_of_late_paths(Facts const& all, std::vector<Warning>& warnings) {
  auto const& motions = all.scene->part.motions;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    auto const owner = fmt::format("motions[{}] of {}", i + 1, set_of(motions[i]));
    if (auto const* drive = std::get_if<DrivePart>(&motions[i]))
      warn_of_late(owner, drive->times, all.end, warnings);
    else if (auto const* turn = std::get_if<TurnPart>(&motions[i]))
      warn_of_late(owner, turn->times, all.end, warnings);
  }
  for (auto const& [name, part] : all.scene->part.obstacles)
    warn_of_late("obstacle " + name, part.times, all.end, warnings);
}

} // namespace

void warn_of_idle_law(std::string const& pair, interface::Law const& law, int dim,
                      std::vector<Warning>& warnings) {
  if (!law.adhesion)
    return;
  auto const owner = fmt::format("pair {}", pair);
  std::visit(
      [&](auto const& bond) {
        auto const& schema = bond.schema();
        warn_of_parameters(owner, schema, &bond, warnings);
        auto const* friction = schema.find("friction");
        if (friction != nullptr && !law.friction &&
            friction->get(&bond) == core::Value{std::string("damage")})
          warnings.push_back({fmt::format("{}: friction = \"damage\" of {} has no friction to take away",
                                          owner, schema.name),
                              "friction = stiction.friction.coulomb { ... } in the pair, or leave it out"});
        auto const *across = schema.find("C_t2"), *along = schema.find("C_t");
        if (dim == 2 && across != nullptr && across->get(&bond) != along->get(&bond))
          warnings.push_back(
              {fmt::format("{}: C_t2 of {} acts only in space", owner, schema.name), "leave C_t2 out"});
      },
      *law.adhesion);
}

void warn_of_idle(Facts const& all, std::vector<Warning>& warnings) {
  auto const& model = *all.scene->model;
  for (auto const& pair : model.pairs)
    warn_of_idle_law(pair.name, pair.law, model.dim(), warnings);
  std::visit([&](auto const& scheme) { warn_of_parameters("scheme", scheme.schema(), &scheme, warnings); },
             model.scheme);
  warn_of_late_paths(all, warnings);
  for (auto const& [name, probe] : all.scene->part.probes) {
    auto const* force = std::get_if<ForceProbe>(&probe);
    if (force != nullptr && !any_held(model, *all.scene->nodes_of(force->set)))
      warnings.push_back(
          {fmt::format("probe {}: nothing moves or holds {}, so that its force is 0", name, force->set),
           "probe.contact or probe.rigid for the force of contact; probe.energy and probe.momentum "
           "for loads"});
  }
}

} // namespace stiction::scene
