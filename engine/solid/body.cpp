// Refuses interpolations that a body's cells cannot carry.
#include "solid/body.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"

namespace stiction::solid {

bool linear(Body const& body) {
  return material::linear(body.material) &&
         std::all_of(body.laws.begin(), body.laws.end(),
                     [](auto const& law) { return material::linear(law); });
}

void check_interpolation(Body const& body) {
  if (body.interpolation == Interpolation::plain)
    return;
  core::Complaints complaints;
  for (auto const& block : body.mesh.blocks)
    if (mesh::stiffness_rule(block.kind).weights.size() == 1)
      complaints.push_back(
          {"", fmt::format("bodies.{}.interpolation", body.name),
           fmt::format("is mean_dilatation, but {} cells have constant strain: averaging their volume "
                       "change cannot help; use {}, or plain",
                       mesh::info(block.kind).name, body.mesh.dim == 3 ? "hex8 or tet10" : "quad4 or tri6")});
  if (!complaints.empty())
    throw core::InputError(complaints);
}

} // namespace stiction::solid
