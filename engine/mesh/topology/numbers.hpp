// Lists of numbers that a schema cannot check by itself, and lengths as the mesher is asked for them.
#pragma once
#include <string>

#include "core/error.hpp"
#include "core/schema.hpp"

namespace stiction::mesh {

/// That a structured mesh may have, in the plane and in space.
constexpr double most_cells_2d = 4e6;
constexpr double most_cells_3d = 2e6;

/// A list given under `path` that must hold `count` numbers of `unit`, each in `range`.
struct GivenNumbers {
  std::string path;
  core::Numbers const& values;
  std::string unit;
  core::Range range;
  std::size_t count = 2;
};

/// Adds a complaint and returns false when the length or a number is wrong.
bool check_numbers(core::Complaints& complaints, GivenNumbers const& given);

/// length / unit, the rounding of its last bit taken away: by it the mesher may count one cell more or less.
[[nodiscard]] double over(double length, double unit);
[[nodiscard]] core::Numbers over(core::Numbers lengths, double unit);

} // namespace stiction::mesh
