// The networks of bodies that relax, from step to step.
#include <algorithm>

#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::dynamics {

std::shared_ptr<Memory const> BulkSystem::memory_at_rest() const {
  if (!relaxing_)
    return nullptr;
  Memory memory;
  memory.reserve(model_->cells.size());
  for (auto const& cells : model_->cells)
    memory.push_back(Vector::Zero(cells.memory_size()));
  return std::make_shared<Memory const>(std::move(memory));
}

std::vector<solid::Networks> BulkSystem::networks_of(Memory const* memory, double dt) const {
  std::vector<solid::Networks> all(model_->cells.size());
  for (std::size_t body = 0; body < all.size(); ++body)
    if (model_->cells[body].relaxing())
      all[body] = model_->cells[body].networks(memory_of(memory, body), dt);
  return all;
}

void BulkSystem::remember_from(std::shared_ptr<Memory const> memory, double dt) {
  if (!relaxing_)
    return;
  networks_.resize(model_->cells.size());
  for (std::size_t body = 0; body < networks_.size(); ++body)
    if (model_->cells[body].relaxing())
      model_->cells[body].find_networks(memory_of(memory.get(), body), dt, networks_[body]);
  memory_ = std::move(memory);
  relax_dt_ = dt;
}

/// One that nobody wants any more, or a new one: pages that a process is given anew cost more than the
/// networks do.
std::shared_ptr<Memory> BulkSystem::memory_to_fill() {
  constexpr std::size_t at_most = 4;
  auto const unwanted = std::ranges::find_if(filled_, [](auto const& one) { return one.use_count() == 1; });
  if (unwanted != filled_.end())
    return *unwanted;
  if (filled_.size() == at_most)
    filled_.erase(filled_.begin());
  auto made = std::make_shared<Memory>();
  made->reserve(model_->cells.size());
  for (auto const& cells : model_->cells)
    made->emplace_back(cells.memory_size());
  return filled_.emplace_back(std::move(made));
}

/// Each rank has filled its own cells, and left the others' at zero.
std::shared_ptr<Memory const> BulkSystem::relax(Vector const& u, material::NetworkEnergy<double>& energy) {
  auto after = memory_to_fill();
  energy = {};
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const& cells = model_->cells[body];
    auto& own = (*after)[body];
    if (!cells.relaxing())
      continue;
    if (model_->share)
      own.setZero();
    auto const first = ix(dim_ * model_->first_node[body]),
               count = ix(dim_ * model_->first_node[body + 1]) - first;
    std::span<double> const to(own.data(), static_cast<std::size_t>(own.size()));
    auto const part = cells.relax({u.data() + first, count}, relax_dt_, memory_of(memory_.get(), body), to);
    energy.stored += part.stored;
    energy.dissipated += part.dissipated;
    if (model_->share)
      model_->share->ranks->sum(to);
  }
  if (model_->share) {
    energy.stored = model_->share->ranks->sum(energy.stored);
    energy.dissipated = model_->share->ranks->sum(energy.dissipated);
  }
  return after;
}

} // namespace stiction::dynamics
