// Wording of complaints about lists of numbers; quotients of lengths.
#include "mesh/topology/numbers.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace stiction::mesh {

bool check_numbers(core::Complaints& complaints, GivenNumbers const& given) {
  bool const length = given.values.size() == given.count;
  bool const values = std::all_of(given.values.begin(), given.values.end(),
                                  [&](double value) { return given.range.contains(value); });
  if (length && values)
    return true;
  std::string const range = given.range.words(given.unit);
  std::string const wanted = given.count == 1
                                 ? "it must be " + range
                                 : fmt::format("{} numbers are wanted, each {}", given.count, range);
  auto const shown = given.count == 1 && length ? core::Value(given.values[0]) : core::Value(given.values);
  complaints.push_back({"", given.path,
                        fmt::format("is {}{}; {}", core::to_string(shown),
                                    given.unit == "1" ? "" : " " + given.unit, wanted)});
  return false;
}

double over(double length, double unit) {
  return std::stod(fmt::format("{:.15g}", length / unit));
}

core::Numbers over(core::Numbers lengths, double unit) {
  for (double& length : lengths)
    length = over(length, unit);
  return lengths;
}

} // namespace stiction::mesh
