// Slender bodies that are bent, and whose cells are too stiff for that.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

namespace {

constexpr double long_for_thick = 5; // length over thickness
constexpr double stiff_told = 0.1,
                 stiff_left = 0.03; // of its stiffness: what is too much, and what may be left
constexpr int places_along = 50;    // along the length, where it is asked who holds it

/// Quadratic kinds in place of those whose edges stay straight; null: is one.
char const* curved_kind(mesh::CellKind kind) {
  switch (kind) {
  case mesh::CellKind::quad4:
    return "quad8";
  case mesh::CellKind::tri3:
    return "tri6";
  case mesh::CellKind::hex8:
    return "hex20";
  case mesh::CellKind::tet4:
    return "tet10";
  default:
    return nullptr;
  }
}

/// A body with its directions of least and most extent, and the model's numbers of its nodes.
struct Strip {
  Facts const& all;
  BodyFacts const& body;
  int across, along;
  Index first, last;
  [[nodiscard]] double thickness() const { return body.sides[across]; }
  [[nodiscard]] double length() const { return body.sides[along]; }
  [[nodiscard]] bool has(Index node) const { return node >= first && node < last; }
};

/// Do motions hold or move it across its length over most of that, from behind as it were?
bool backed(Strip const& strip) {
  auto const& model = *strip.all.scene->model;
  double const start =
      model.reference.middleRows(strip.first, strip.last - strip.first).col(strip.along).minCoeff();
  std::array<bool, places_along> held{};
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      if (motion.component == strip.across && strip.has(node))
        for (int place = 0; place < places_along; ++place)
          if (double const at = start + (place + 0.5) / places_along * strip.length();
              std::abs(model.reference(node, strip.along) - at) <= strip.thickness())
            held[ix(place)] = true;
  return 2 * std::ranges::count(held, true) >= places_along;
}

bool any_within(Strip const& strip, std::vector<mesh::Facet> const& facets) {
  return std::ranges::any_of(facets, [&](auto const& facet) { return strip.has(facet.nodes.front()); });
}

/// Does anything move or load it across its length: motions, loads, or what it meets, if that is no flat it
/// lies on?
bool is_bent(Strip const& strip) {
  auto const& model = *strip.all.scene->model;
  auto const moved = [&](auto const& motion) {
    return motion.component == strip.across && motion.farthest() > 0 && !motion.nodes.empty() &&
           strip.has(motion.nodes.front());
  };
  auto const pushed = [&](auto const& load) {
    for (Index node = strip.first; node < strip.last; ++node)
      if (load.force[model.dim() * node + strip.across] != 0)
        return true;
    return false;
  };
  bool bent =
      std::ranges::any_of(model.motions, moved) || std::ranges::any_of(model.loads, pushed) ||
      (model.gravity[strip.across] != 0 && strip.body.held[ix(strip.across)]) ||
      std::ranges::any_of(model.pressures, [&](auto const& one) { return any_within(strip, one.facets); });
  for (auto const& pair : strip.all.pairs) {
    if (!is_side(strip.all, pair, strip.body) || std::abs(pair.normal[strip.across]) < 0.7)
      continue;
    if (!(pair.radius > 0) && !pair.motion.beside)
      return false;
    bent = bent || pair.motion.depth > 0 || pair.motion.opening > 0;
  }
  return bent;
}

/// Mean of the cells of a block along an axis, m.
double mean_extent(mesh::Mesh const& mesh, mesh::Block const& block, int axis) {
  auto const size = static_cast<std::size_t>(mesh::info(block.kind).nodes);
  double sum = 0;
  for (std::size_t first = 0; first < block.nodes.size(); first += size) {
    double low = mesh.nodes(block.nodes[first], axis), high = low;
    for (std::size_t k = first + 1; k < first + size; ++k) {
      low = std::min(low, mesh.nodes(block.nodes[k], axis));
      high = std::max(high, mesh.nodes(block.nodes[k], axis));
    }
    sum += high - low;
  }
  return sum / (static_cast<double>(block.nodes.size()) / static_cast<double>(size));
}

/// A surface under tension stiffens what it is on as a string is; what it presses in balance gives that back,
/// but not by laws of small strains: with k^2 = gamma L^2 / (E' h^3 / 12) a strip bends by 2 (1 - 1/cosh k) /
/// k^2 of it.
void tensioned(Strip const& strip, std::vector<Warning>& warnings) {
  constexpr double much = 0.05;
  auto const& model = *strip.all.scene->model;
  auto const& body = *strip.body.body;
  double const h = strip.thickness(), L = strip.length();
  double tension = 0;
  for (auto const& stress : model.surface_stresses)
    if (any_within(strip, stress.facets))
      tension += stress.gamma;
  double const k = std::sqrt(tension * L * L / (strip.body.plane_modulus() * h * h * h / 12));
  double const less = k > 0 ? 1 - 2 * (1 - 1 / std::cosh(k)) / (k * k) : 0;
  if (!solid::small_strain(body.material) || less < much || backed(strip))
    return;
  warnings.push_back(
      {fmt::format("body {}: under its surface stress it bends by {} less than it should: {} knows small "
                   "strains only, and not how the compression in balance with that tension gives way",
                   body.name, percent(less),
                   std::visit([](auto const& law) { return law.schema().name; }, body.material)),
       law_of_large_strains(strip.body)});
}

} // namespace

/// A cell with straight edges that is bent shears: by that it is stiffer by G / E' (a / h)^2, a its length
/// and h the thickness of all of them.
void warn_of_bending(Facts const& all, std::vector<Warning>& warnings) {
  auto const& model = *all.scene->model;
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    auto const& body = all.bodies[b];
    Strip strip{all, body, 0, 0, model.first_node[b], model.first_node[b + 1]};
    body.sides.head(model.dim()).minCoeff(&strip.across);
    body.sides.head(model.dim()).maxCoeff(&strip.along);
    if (strip.length() < long_for_thick * strip.thickness())
      continue;
    tensioned(strip, warnings);
    auto const& mesh = body.body->mesh;
    auto const block = std::ranges::find_if(
        mesh.blocks, [](auto const& own) { return !own.nodes.empty() && curved_kind(own.kind); });
    if (block == mesh.blocks.end())
      continue;
    double const ratio =
        body.moduli.shear() / (body.body->plane_stress ? body.moduli.young : body.plane_modulus());
    double const length = mean_extent(mesh, *block, strip.along), part = length / strip.thickness();
    if (ratio * part * part < stiff_told || backed(strip) || !is_bent(strip))
      continue;
    warnings.push_back(
        {fmt::format("body {}: as it bends, {} cells of {} along its length in a thickness of {} are too "
                     "stiff by {} or more",
                     body.body->name, mesh::info(block->kind).name, human(length, "m"),
                     human(strip.thickness(), "m"), percent(ratio * part * part)),
         fmt::format("{} cells, or cells of {} or less along {}, which leave {}", curved_kind(block->kind),
                     human(std::sqrt(stiff_left / ratio) * strip.thickness(), "m"), "xyz"[strip.along],
                     percent(stiff_left))});
  }
}

} // namespace stiction::scene
