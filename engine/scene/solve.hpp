// Replays a saved contact problem against a solver.
#pragma once
#include <filesystem>
#include <string>

namespace stiction::scene {

/// What came of it, as a few lines of text.
struct SolveReport {
  std::string text;
  bool converged = false;
};

/// `solver` is a kind of the catalog's category "solver" or "all". Throws InputError for an unknown solver or
/// a bad file.
[[nodiscard]] SolveReport solve_file(std::filesystem::path const& path, std::string const& solver,
                                     double tolerance);

} // namespace stiction::scene
