// Boundaries with heights: what they are, and whether nodes show them.
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

void warn_of_relief(Facts const& all, std::vector<Warning>& warnings) {
  for (auto const& [name, made] : all.scene->reliefs) {
    if (made.spacing <= made.finest * (1 + 1e-9))
      continue;
    auto const& part = *all.scene->part.bodies.at(name).relief;
    auto const* rough = std::get_if<halfspace::Rough>(&part.surface);
    bool const waves = rough != nullptr || std::holds_alternative<halfspace::Wave>(part.surface);
    warnings.push_back(
        {fmt::format(
             "body {}: nodes of {} are up to {} apart, and its relief has {} {}{}: they do not show all "
             "of it",
             name, part.set, human(made.spacing, "m"), waves ? "waves down to" : "a height every",
             human(waves ? show_wave * made.finest : made.finest, "m"),
             waves ? fmt::format(", {:.3g} nodes (< {:g}) to each", show_wave * made.finest / made.spacing,
                                 show_wave)
                   : ""),
         fmt::format("cells of {} with nodes {} apart, or a {}", part.set, human(made.finest, "m"),
                     rough != nullptr ? "larger `shortest`"
                     : waves          ? "longer wave"
                                      : "map of fewer points")});
  }
}

} // namespace stiction::scene
