// Bodies and surfaces that are inside each other before anything moves.
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "contact/tunnelling/inside.hpp"
#include "contact/tunnelling/obstacle_tunnelling.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

using contact::Vec;

std::string position_words(Matrix const& reference, Index node) {
  auto const X = reference.row(node);
  return fmt::format("({:g}) m", fmt::join(X.data(), X.data() + X.size(), ", "));
}

/// The node of a mesh's boundary that is deepest inside another mesh, and how deep, m; those less deep than
/// `least` do not count.
struct Deepest {
  Index node = -1;
  double depth = 0;
};

template<int D> Deepest deepest_inside(mesh::Mesh const& own, mesh::Mesh const& other, double least) {
  Vec<D> const low = other.nodes.colwise().minCoeff(), high = other.nodes.colwise().maxCoeff();
  Deepest deepest{-1, least};
  std::vector<contact::Panel<D>> panels;
  std::span<double const> const x{other.nodes.data(), static_cast<std::size_t>(other.nodes.size())};
  std::vector<bool> seen(ix(own.node_count()));
  for (auto const& facet : mesh::boundary(own))
    for (Index const node : facet.nodes) {
      Vec<D> const point = own.nodes.row(node);
      bool const near =
          (point.array() > low.array() + least).all() && (point.array() < high.array() - least).all();
      if (seen[ix(node)] || !near)
        continue;
      seen[ix(node)] = true;
      if (panels.empty())
        panels = contact::panels_of<D>(other);
      if (double const depth = contact::depth_inside<D>(panels, x, point); depth > deepest.depth)
        deepest = {node, depth};
    }
  return deepest;
}

} // namespace

/// Contact looks for counterparts nearby only: bodies deep inside each other would pass unseen.
bool Builder::bodies_overlap(std::string const& pair) {
  auto const& part = scene_.part.pairs.at(pair);
  auto const body_of = [&](std::string const& set) -> mesh::Mesh const* {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      if (scene_.bodies[b] == set.substr(0, set.find('.')))
        return &scene_.model->bodies[b]->mesh;
    return nullptr;
  };
  auto const *first = body_of(part.secondary), *second = body_of(part.primary);
  if (first == nullptr || second == nullptr || first == second)
    return false;
  double const least = scene_.model->pairs[ix(scene_.pair_index(pair))].reach;
  for (auto const& [own, other] : {std::pair{first, second}, std::pair{second, first}}) {
    auto const deepest = scene_.part.dim() == 2 ? deepest_inside<2>(*own, *other, least)
                                                : deepest_inside<3>(*own, *other, least);
    if (deepest.node < 0)
      continue;
    complain({"pairs", pair},
             fmt::format("the bodies of {} and {} overlap by {:.3g} m at {} before the run starts; move one "
                         "of them apart",
                         part.secondary, part.primary, deepest.depth,
                         position_words(own->nodes, deepest.node)));
    return true;
  }
  return false;
}

/// A surface that starts inside its counterpart has no admissible first step.
void Builder::check_overlap(dynamics::State const& state) {
  for (std::size_t p = 0; p < scene_.model->pairs.size(); ++p) {
    if (bodies_overlap(scene_.model->pairs[p].name))
      continue;
    auto const& pair = scene_.model->pairs[p];
    std::size_t deepest = 0;
    double const admitted = -contact::most_overlap * pair.reach;
    double gap = admitted;
    for (std::size_t i = 0; i < state.contacts[p].size(); ++i)
      if (auto const& point = state.contacts[p][i]; point.foot.found() && point.gap <= gap) {
        deepest = i;
        gap = point.gap;
      }
    if (gap == admitted)
      continue;
    auto const& part = scene_.part.pairs.at(pair.name);
    complain({"pairs", pair.name},
             fmt::format("{} and {} overlap by {:.3g} m at {} before the run starts; move one of them apart",
                         part.secondary, part.primary, -gap,
                         position_words(scene_.model->reference, pair.secondary[deepest])));
  }
}

} // namespace stiction::scene
