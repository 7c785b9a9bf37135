// The factors that steps leave to each other: telling them, having them back, making them anew.
#include <algorithm>
#include <utility>

#include "core/error.hpp"
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::dynamics {

namespace {

/// What a factor that does not depend on u is to go on with, of those wanted; none where it is not among
/// them.
linear::Carried const* carried_for(double dt, std::vector<FactorSource> const& wanted) {
  auto const found = std::ranges::find_if(wanted, [&](auto const& source) { return source.dt == dt; });
  return found != wanted.end() ? found->carried.get() : nullptr;
}

} // namespace

void BulkSystem::recall(std::vector<FactorSource> const& wanted, StepWeights const& weights) {
  if (linear_) {
    for (auto& one : kept_)
      one.factor->carry_on(carried_for(one.source.dt, wanted));
    return;
  }
  std::vector<Kept> had = std::exchange(kept_, {});
  std::ranges::move(std::exchange(parked_, {}), std::back_inserter(had));
  for (auto const& source : wanted) {
    auto const found = std::ranges::find_if(had, [&](Kept const& one) { return one.comes_from(source); });
    if (found == had.end()) {
      kept_.emplace_back().is_of(source, weights, relaxing_);
    } else {
      kept_.push_back(std::move(*found));
      had.erase(found);
    }
    kept_.back().wanted = true;
    kept_.back().source.carried = source.carried;
  }
  for (auto& one : had)
    spare_.push_back(std::move(one.factor));
  if (kept_.empty())
    kept_.emplace_back();
  for (auto& one : kept_) {
    if (one.factor == nullptr)
      one.factor = spare();
    one.factor->carry_on(one.source.carried.get());
  }
}

void BulkSystem::make_again(std::vector<FactorSource> const& wanted, StepWeights const& weights) {
  if (wanted.empty())
    return;
  for (auto& one : std::exchange(kept_, {}))
    spare_.push_back(std::move(one.factor));
  for (auto source = wanted.rbegin(); source != wanted.rend(); ++source) {
    Kept one;
    one.factor = spare();
    one.is_of(*source, weights, relaxing_);
    kept_.insert(kept_.begin(), std::move(one));
    Cost not_counted;
    core::expect(make(weights, not_counted), "a factor that has been to be made again");
    if (Dense known; source->carried && !source->carried->columns.empty())
      factor().compliance(source->carried->columns, known);
    static_cast<void>(factor().spent());
  }
}

std::vector<FactorSource> BulkSystem::sources() const {
  std::vector<FactorSource> all;
  for (auto const& one : kept_)
    if (one.source.u != nullptr && (!linear_ || one.factor->coupled() != nullptr)) {
      all.push_back(one.source);
      if (one.made)
        all.back().carried = one.factor->carried();
    }
  return all;
}

std::vector<FactorSource> BulkSystem::lasting() const {
  std::vector<FactorSource> all;
  for (auto const& one : kept_)
    if (linear_ && one.made) {
      all.push_back(one.source);
      all.back().carried = one.factor->carried();
    }
  return all;
}

std::optional<FactorSource> BulkSystem::held(FactorSource const& wanted) const {
  auto const is_it = [&](Kept const& one) { return one.made && one.comes_from(wanted); };
  for (auto const* among : {&kept_, &parked_})
    if (auto const found = std::ranges::find_if(*among, is_it); found != among->end()) {
      auto source = wanted;
      source.carried = found->factor->carried();
      return source;
    }
  return {};
}

} // namespace stiction::dynamics
