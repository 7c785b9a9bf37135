// What the networks of a body that relaxes do and remember.
#include <algorithm>

#include "core/threads.hpp"
#include "solid/cells.hpp"

namespace stiction::solid {

/// Where each block's points are in memory and in the order of the mesh's cells.
void Cells::number_points() {
  std::vector<std::ptrdiff_t> first_point;
  Indices first_cell{0};
  for (auto const& block : body_->mesh.blocks) {
    auto const count = static_cast<Index>(block.nodes.size()) / mesh::info(block.kind).nodes;
    auto const points = static_cast<std::ptrdiff_t>(mesh::stiffness_rule(block.kind).weights.size());
    first_point.push_back(points_ - first_cell.back() * points);
    first_cell.push_back(first_cell.back() + count);
    points_ += count * points;
  }
  mesh_points_.reserve(blocks_.size());
  for (auto& block : blocks_) {
    auto const after = block.number.empty() ? first_cell.begin() + 1
                                            : std::ranges::upper_bound(first_cell, block.number.front());
    mesh_points_.push_back(first_point[static_cast<std::size_t>(after - first_cell.begin()) - 1]);
    block.first_point = block.by_cell ? mesh_points_.back() : places_;
    places_ += std::ptrdiff_t{Pack::lanes} * block.groups() * block.points;
  }
  if (shared_)
    places_ = points_;
}

std::size_t Cells::remembered_each() const {
  return network_steps(body_->material, 0).each(ix(stress_components(kinematics_)));
}

Eigen::Index Cells::memory_size() const {
  return relaxing() ? places_ * static_cast<Eigen::Index>(remembered_each()) : 0;
}

/// Calls visit(place in memory, place by cell) for every number.
template<class Visit> void Cells::each_remembered(Visit const& visit) const {
  std::size_t const each = remembered_each();
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    auto const& block = blocks_[b];
    for (Index cell = 0; cell < block.cells(); ++cell)
      for (int q = 0; q < block.points; ++q) {
        auto const [first, stride] = block.remembered(cell / Pack::lanes, cell % Pack::lanes, q, each);
        auto const point = mesh_points_[b] + std::ptrdiff_t{block.number[ix(cell)]} * block.points + q;
        for (std::size_t i = 0; i < each; ++i)
          visit(static_cast<Eigen::Index>(first + i * stride),
                static_cast<Eigen::Index>(static_cast<std::size_t>(point) * each + i));
      }
  }
}

Vector Cells::by_cell(std::span<double const> memory) const {
  Vector result = Vector::Zero(points_ * static_cast<Eigen::Index>(remembered_each()));
  each_remembered([&](Eigen::Index own, Eigen::Index of_mesh) {
    result[of_mesh] = memory[static_cast<std::size_t>(own)];
  });
  return result;
}

Vector Cells::from_cells(std::span<double const> by_cell) const {
  Vector result = Vector::Zero(memory_size());
  each_remembered([&](Eigen::Index own, Eigen::Index of_mesh) {
    result[own] = by_cell[static_cast<std::size_t>(of_mesh)];
  });
  return result;
}

/// Of all cells, which others share.
NodalStress Cells::stress_of_whole(std::span<double const> u, std::span<double const> memory) const {
  Cells const whole(*body_, kinematics_);
  if (memory.empty())
    return whole.stress(u);
  Vector const own = whole.from_cells(memory);
  return whole.stress(u, {own.data(), static_cast<std::size_t>(own.size())});
}

NetworkSteps Cells::network_steps(material::Material const& law, double dt) const {
  auto const moduli = material::moduli(law);
  NetworkSteps steps;
  steps.shear.reserve(body_->relaxing.size());
  steps.volume.reserve(body_->relaxing.size());
  for (auto const& term : body_->relaxing) {
    if (term.in_shear())
      steps.shear.emplace_back(term.stiffness(moduli.shear()), term.time, dt);
    if (term.in_volume())
      steps.volume.emplace_back(term.bulk_stiffness(moduli.bulk()), term.time, dt);
  }
  return steps;
}

namespace {

using Steps = std::span<material::NetworkStep const>;

/// What is left of all moduli at the step's end, Pa.
double modulus_left(Steps steps) {
  double sum = 0;
  for (auto const& step : steps)
    sum += step.left();
  return sum;
}

/// Sum of modulus times weight of what the networks follow, at the step's start, Pa.
double modulus_before(Steps steps) {
  double sum = 0;
  for (auto const& step : steps)
    sum += step.modulus * step.before;
  return sum;
}

/// P or n of a point from the numbers that its networks remember, [terms and what they follow, components].
void sum_up(Steps steps, double metric, std::span<Pack const> numbers, std::span<Pack> sums) {
  std::size_t const components = sums.size();
  for (std::size_t i = 0; i < components; ++i) {
    Pack sum = metric * numbers[steps.size() * components + i];
    for (std::size_t k = 0; k < steps.size(); ++k)
      sum += steps[k].modulus * steps[k].keep * numbers[k * components + i];
    sums[i] = sum;
  }
}

/// P and n of the cells of a block, from what they remember.
void find_sums(PreparedBlock const& block, NetworkSteps const& steps, std::span<double const> memory,
               BlockNetworks& own) {
  std::size_t const points = block.volumes.size(), components = own.pulls.size() / points,
                    of_shear = steps.of_shear(components), in_volume = own.pressing.size() / points;
  std::vector<Pack> remembered(steps.each(components));
  std::span<Pack const> const numbers(remembered);
  double const metric = modulus_before(steps.shear), volume = modulus_before(steps.volume);
  std::size_t at = 0;
  for (Index g = 0; g < block.groups(); ++g)
    for (int q = 0; q < block.points; ++q, ++at) {
      recall(block, memory, {g, q, remembered.size(), 0}, remembered);
      sum_up(steps.shear, metric, numbers.first(of_shear),
             std::span(own.pulls).subspan(at * components, components));
      sum_up(steps.volume, volume, numbers.subspan(of_shear),
             std::span(own.pressing).subspan(at * in_volume, in_volume));
    }
}

} // namespace

Networks Cells::networks(std::span<double const> memory, double dt) const {
  Networks all;
  find_networks(memory, dt, all);
  return all;
}

void Cells::find_networks(std::span<double const> memory, double dt, Networks& all) const {
  all.resize(blocks_.size());
  auto const components = ix(stress_components(kinematics_));
  core::each(static_cast<Index>(blocks_.size()), [&](Index i) {
    auto const& block = blocks_[ix(i)];
    auto& own = all[ix(i)];
    auto const steps = network_steps(*block.law, dt);
    auto const points = block.volumes.size();
    own.modulus = modulus_left(steps.shear);
    own.bulk_modulus = modulus_left(steps.volume);
    own.pulls.resize(steps.shear.empty() ? 0 : points * components);
    own.pressing.resize(steps.volume.empty() ? 0 : points);
    if (!memory.empty())
      return find_sums(block, steps, memory, own);
    std::ranges::fill(own.pulls, Pack(0));
    std::ranges::fill(own.pressing, Pack(0));
  });
}

material::NetworkEnergy<double> Cells::relax(std::span<double const> u, double dt,
                                             std::span<double const> before, std::span<double> after) const {
  std::vector<material::NetworkEnergy<double>> parts(ix(whole_));
  core::each(whole_, [&](Index i) {
    auto const& block = blocks_[ix(i)];
    auto const steps = network_steps(*block.law, dt);
    parts[ix(i)] = block.passes->relax({block, *body_, u}, {steps, before, after});
  });
  material::NetworkEnergy<double> sum;
  for (auto const& part : parts) {
    sum.stored += part.stored;
    sum.dissipated += part.dissipated;
  }
  return sum;
}

} // namespace stiction::solid
