// Reads the parts first: they are cheap, and tell the number of cells.
#include "fuzz/small_scene.hpp"

#include "scene/build/build.hpp"

namespace stiction::fuzz {

namespace {

constexpr double most_cells = 300;

double cells(core::Numbers const& numbers) {
  double product = 1;
  for (double const n : numbers)
    product *= n;
  return product;
}

bool is_small(mesh::Generator const& generator) {
  if (auto const* block = std::get_if<mesh::BlockOptions>(&generator))
    return cells(block->cells) <= most_cells;
  if (auto const* box = std::get_if<mesh::BoxOptions>(&generator))
    return cells(box->cells) <= most_cells;
  return false;
}

} // namespace

void check_small_scene(core::Input const& input) {
  core::Complaints complaints;
  core::Reader reader(input, "", complaints);
  auto const part = reader.record<scene::ScenePart>();
  if (!complaints.empty())
    throw core::InputError(complaints);
  for (auto const& [name, body] : part.bodies)
    if (!is_small(body.mesh))
      return;
  static_cast<void>(scene::build(input));
}

} // namespace stiction::fuzz
