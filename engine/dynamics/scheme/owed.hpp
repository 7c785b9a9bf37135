// What a time scheme owes.
#pragma once
#include "core/owed.hpp"
#include "dynamics/scheme/weights.hpp"

namespace stiction::dynamics::owed {

template<class T>
concept Weighted = requires(T const& scheme) {
  { scheme.weights() } -> std::same_as<StepWeights>;
};

/// It may have besides `void set_duration(double)`, the run's, s, and what every part may that is read by a
/// schema (core/reader.hpp).
template<class T>
concept Scheme = core::Described<T> && Weighted<T>;

template<class T> struct OfScheme {
  static_assert(
      core::Described<T>,
      "a time scheme lacks `static core::Schema const& schema()`: its name, meaning and parameters");
  static_assert(Weighted<T>, "a time scheme lacks `StepWeights weights() const`: the coefficients of its "
                             "balance of forces and of its rates");
  static constexpr bool given = Scheme<T>;
};

} // namespace stiction::dynamics::owed
