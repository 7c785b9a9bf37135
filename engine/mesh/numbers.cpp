// Wording of complaints about lists of numbers.
#include "mesh/numbers.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace stiction::mesh {

bool check_numbers(core::Complaints& complaints, GivenNumbers const& given) {
  bool const length = given.values.size() == given.count;
  bool const values = std::all_of(given.values.begin(), given.values.end(),
                                  [&](double value) { return given.range.contains(value); });
  if (length && values)
    return true;
  std::string const unit = given.unit == "1" ? "" : " " + given.unit;
  complaints.push_back({"", given.path,
                        fmt::format("is {}{}; {} numbers are wanted, each {}", core::to_string(given.values),
                                    unit, given.count, given.range.words(given.unit))});
  return false;
}

} // namespace stiction::mesh
