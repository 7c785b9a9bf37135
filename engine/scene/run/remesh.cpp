// Sizes from the error of the stress and from the cohesive length.
#include "scene/run/remesh.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "scene/explain/facts.hpp"
#include "solid/stress_error.hpp"

namespace stiction::scene {

namespace {

constexpr double deepest = 1.0 / 3; ///< part of its size that a cell may shrink to in one pass
constexpr double widest = 1.5;
constexpr double slack = 1.1; ///< by which a mesher misses the size that it is asked for

/// Visits the nodes of each cell, block after block.
template<class Visit> void each_cell(mesh::Mesh const& mesh, Visit&& visit) {
  std::size_t c = 0;
  for (auto const& block : mesh.blocks) {
    auto const nodes = static_cast<std::size_t>(mesh::info(block.kind).nodes);
    auto const corners = static_cast<std::size_t>(mesh::info(block.kind).corners);
    for (std::size_t first = 0; first < block.nodes.size(); first += nodes)
      visit(c++, std::span<Index const>(block.nodes).subspan(first, corners));
  }
}

/// Square root of the area of a plane cell by its corners, m.
double size_of(Matrix const& X, std::span<Index const> corners) {
  double twice = 0;
  for (std::size_t a = 0; a < corners.size(); ++a) {
    auto const p = X.row(corners[a]), q = X.row(corners[(a + 1) % corners.size()]);
    twice += p[0] * q[1] - p[1] * q[0];
  }
  return std::sqrt(0.5 * std::abs(twice));
}

core::Input metres(double value) {
  auto quantity = *core::parse_unit("m");
  quantity.value *= value;
  return {quantity, "", ""};
}

} // namespace

MeshControl::MeshControl(Scene const& scene, dynamics::State const& start) : scene_(&scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    auto const& part = scene.part.bodies.at(scene.bodies[b]);
    if (!part.remesh)
      continue;
    Seen seen{b, *part.remesh, 0, 0, {}, {}, {}};
    auto const& mesh = scene.model->bodies[b]->mesh;
    seen.centres.setZero(mesh.cell_count(), 2);
    each_cell(mesh, [&](std::size_t c, std::span<Index const> corners) {
      seen.now.push_back(size_of(mesh.nodes, corners));
      for (Index const node : corners)
        seen.centres.row(static_cast<Eigen::Index>(c)) +=
            mesh.nodes.row(node) / static_cast<double>(corners.size());
    });
    for (double const size : seen.now)
      seen.size.push_back(widest * size);
    bodies_.push_back(std::move(seen));
  }
  if (bodies_.empty())
    return;
  auto const facts = facts_of(scene, start);
  for (auto const& pair : facts.pairs) {
    cohesive_.push_back(std::numeric_limits<double>::infinity());
    if (pair.adheres())
      cohesive_.back() = pair.elastic_length();
  }
}

void MeshControl::examine(dynamics::State const& state) {
  for (auto& seen : bodies_) {
    note_errors(seen, state);
    note_bonds(seen, state);
  }
}

/// Every cell is to have the same error, and all of them together the target's; the error of a cell falls
/// with its size.
void MeshControl::note_errors(Seen& seen, dynamics::State const& state) const {
  auto const& model = *scene_->model;
  int const dim = model.dim();
  auto const first = ix(dim * model.first_node[seen.body]),
             count = ix(dim * model.first_node[seen.body + 1]) - first;
  auto const found = solid::stress_error(*model.bodies[seen.body], model.kinematics,
                                         {state.u.data() + first, count}, state.memory_of(seen.body));
  seen.error = std::max(seen.error, found.relative());
  double whole = 0;
  for (std::size_t c = 0; c < found.error.size(); ++c)
    whole += found.error[c] + found.size[c];
  double const allowed = seen.part.target * std::sqrt(whole / static_cast<double>(found.error.size()));
  for (std::size_t c = 0; c < found.error.size(); ++c)
    if (found.error[c] > 0)
      seen.size[c] = std::min(seen.size[c],
                              seen.now[c] * std::clamp(allowed / std::sqrt(found.error[c]), deepest, widest));
}

/// Cells at bonded points of secondary surfaces resolve the cohesive length.
void MeshControl::note_bonds(Seen& seen, dynamics::State const& state) const {
  if (seen.part.cohesive_cells <= 0)
    return;
  auto const& model = *scene_->model;
  Index const first = model.first_node[seen.body], end = model.first_node[seen.body + 1];
  std::vector<double> limit(ix(end - first), std::numeric_limits<double>::infinity());
  for (std::size_t p = 0; p < model.pairs.size(); ++p)
    for (std::size_t i = 0; i < model.pairs[p].secondary.size(); ++i) {
      Index const node = model.pairs[p].secondary[i];
      if (node >= first && node < end && state.contacts[p][i].bond.beta > 0)
        limit[ix(node - first)] = cohesive_[p] / seen.part.cohesive_cells;
    }
  each_cell(model.bodies[seen.body]->mesh, [&](std::size_t c, std::span<Index const> corners) {
    for (Index const node : corners) {
      seen.size[c] = std::min(seen.size[c], limit[ix(node)]);
      seen.coarsest = std::max(seen.coarsest, seen.now[c] / limit[ix(node)]);
    }
  });
}

bool MeshControl::fine_enough() const {
  return doubts().empty();
}

std::vector<std::string> MeshControl::doubts() const {
  std::vector<std::string> all;
  for (auto const& seen : bodies_) {
    std::string const& name = scene_->bodies[seen.body];
    if (seen.error > seen.part.target)
      all.push_back(
          fmt::format("body '{}': the error of the stress is {:.3g}, above the target {:g}; allow more "
                      "passes or a smaller `smallest`, or a larger target",
                      name, seen.error, seen.part.target));
    if (seen.coarsest > slack)
      all.push_back(
          fmt::format("body '{}': bonded cells are {:.3g} times as large as cohesive_cells = {:g} asks "
                      "for; allow more passes or a smaller `smallest`, or fewer cohesive_cells",
                      name, seen.coarsest, seen.part.cohesive_cells));
  }
  return all;
}

int MeshControl::passes() const {
  int most = 1;
  for (auto const& seen : bodies_)
    most = std::max(most, seen.part.passes);
  return most;
}

double MeshControl::error() const {
  double largest = 0;
  for (auto const& seen : bodies_)
    largest = std::max(largest, seen.error);
  return largest;
}

CellSizes MeshControl::sizes() const {
  CellSizes all;
  for (auto const& seen : bodies_) {
    auto const& name = scene_->bodies[seen.body];
    auto& own = all[name];
    double const least =
        std::max(seen.part.smallest,
                 mesh::smallest_size(std::get<mesh::GmshGeometry>(scene_->part.bodies.at(name).mesh)));
    for (std::size_t c = 0; c < seen.size.size(); ++c) {
      auto const centre = seen.centres.row(static_cast<Eigen::Index>(c));
      own.insert(own.end(), {centre[0], centre[1], std::max(seen.size[c], least)});
    }
  }
  return all;
}

core::Input with_sizes(core::Input input, CellSizes const& sizes) {
  auto entry = [](core::Input& owner, std::string const& key) -> core::Input& {
    return std::get<core::Table>(owner.value)[key];
  };
  for (auto const& [name, numbers] : sizes) {
    core::List list;
    for (double const number : numbers)
      list.push_back(metres(number));
    auto& body = entry(entry(input, "bodies"), name);
    entry(entry(body, "mesh"), "sizes") = {std::move(list), "", ""};
  }
  return input;
}

} // namespace stiction::scene
