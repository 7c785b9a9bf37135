// Uses the first and a late layer of the installed engine, headers and libraries.
#include <core/error.hpp>
#include <core/unit.hpp>
#include <cstdlib>
#include <iostream>
#include <record/series.hpp>

int main() {
  auto const unit = stiction::core::parse_unit("N/mm^2");
  if (!unit || unit->value < 0.999e6 || unit->value > 1.001e6)
    return EXIT_FAILURE;
  try {
    (void)stiction::record::read_series("no such file");
  } catch (stiction::core::InputError const& error) {
    std::cout << "1 N/mm^2 = " << unit->value << " Pa; " << error.what() << '\n';
    return EXIT_SUCCESS;
  }
  return EXIT_FAILURE;
}
