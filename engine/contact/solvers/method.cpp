// Counts of methods in words.
#include "contact/solvers/method.hpp"

#include <fmt/format.h>
#include <iterator>

#include "contact/solvers/solver.hpp"

namespace stiction::contact {

std::string words(Methods const& counts) {
  std::string text;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k] > 0)
      fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "" : " ", method_names[k],
                     counts[k]);
  return text;
}

std::unique_ptr<Solver> make_solver(SolverChoice const& choice) {
  return std::visit([](auto const& settings) { return settings.make(); }, choice);
}

} // namespace stiction::contact
