// Links in vectors and in the matrix. A follower's entries are summed beside the matrix, as those of an
// unknown are, and go to its masters' entries when all cells have added theirs.
#include "dynamics/bulk/links.hpp"

#include <algorithm>

#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

namespace {
constexpr Index first_number = -2; ///< of followers; -1 is a driven degree of freedom
} // namespace

Links::Links(Model const& model) : links_(&model.links) {
  if (empty())
    return;
  follows_.assign(ix(model.dofs()), false);
  for (auto const& link : *links_)
    follows_[ix(link.dof)] = true;
}

void Links::follow(Vector& u) const {
  for (auto const& link : *links_) {
    u[link.dof] = 0;
    for (auto const& [master, weight] : link.masters)
      u[link.dof] += weight * u[master];
  }
}

void Links::gather(Vector& force) const {
  for (auto const& link : *links_) {
    for (auto const& [master, weight] : link.masters)
      force[master] += weight * force[link.dof];
    force[link.dof] = 0;
  }
}

void Links::number(Indices& unknown_of) const {
  for (std::size_t k = 0; k < links_->size(); ++k)
    unknown_of[ix((*links_)[k].dof)] = first_number - static_cast<Index>(k);
}

void Links::expand(Indices const& unknown_of, Indices& clique) const {
  for (std::size_t k = 0, own = clique.size(); k < own && !empty(); ++k)
    if (clique[k] <= first_number)
      for (auto const& [unknown, weight] : parts(clique[k], unknown_of))
        clique.push_back(unknown);
}

Index Links::carrier(Index number, Indices const& unknown_of) const {
  if (number > first_number)
    return -1;
  auto const& masters = (*links_)[ix(first_number - number)].masters;
  return masters.size() == 1 && masters[0].second == 1 ? std::max(-1, unknown_of[ix(masters[0].first)]) : -1;
}

/// Masters that are driven move as they are told: no matrix has them.
Links::Parts Links::parts(Index number, Indices const& unknown_of) const {
  if (number >= 0)
    return {{number, 1}};
  Parts all;
  if (number <= first_number)
    for (auto const& [master, weight] : (*links_)[ix(first_number - number)].masters)
      if (unknown_of[ix(master)] >= 0)
        all.emplace_back(unknown_of[ix(master)], weight);
  return all;
}

void Links::add_slots(std::span<Index const> numbers) {
  if (empty() || std::ranges::none_of(numbers, [](Index n) { return n <= first_number; }))
    return;
  for (Index const a : numbers)
    for (Index const b : numbers)
      if (a >= b && b <= first_number && a != -1)
        slots_.emplace(std::pair{a, b}, static_cast<Index>(slots_.size()));
}

Index Links::slot(linear::Pattern const& pattern, Index i, Index j) const {
  auto const found = slots_.find({std::max(i, j), std::min(i, j)});
  return found == slots_.end() ? -1 : pattern.entries() + found->second;
}

void Links::settle(linear::Pattern const& pattern, Indices const& unknown_of) {
  for (auto const& [numbers, slot] : slots_)
    each_entry(pattern, unknown_of, numbers, [&, at = slot](Index entry, double part) {
      folds_.push_back({pattern.entries() + at, entry, part});
    });
}

void Links::fold(std::span<double> values) const {
  for (auto const& fold : folds_)
    values[ix(fold.entry)] += fold.part * values[ix(fold.slot)];
}

} // namespace stiction::dynamics
