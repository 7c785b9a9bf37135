// Replays a saved contact problem against its solvers.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace stiction::scene {

/// One solver's answer, judged.
struct SolverAnswer {
  std::string solver;
  bool converged = false;
  std::string method; ///< that gave the answer
  long iterations = 0;
  double work = 0;                   ///< in products W p
  double residual = 0, relative = 0; ///< Pa; over the largest traction
  std::optional<double> cone_error;  ///< contact/problem/cone_error.hpp
  double seconds = 0;
  Vector force, displacement; ///< [components contacts], N and m
};

/// What came of it, as numbers and as a few lines of text.
struct SolveReport {
  std::string text;
  bool converged = false; ///< every solver
  Index contacts = 0;
  int components = 0;
  Vector free; ///< displacement without force, [components contacts], m
  std::vector<SolverAnswer> answers;
  std::vector<std::string> doubts; ///< where theory promises no single answer
};

/// `solver` is a kind of the catalog's category "solver" or "all". Throws InputError for an unknown solver or
/// a bad file.
[[nodiscard]] SolveReport solve_file(std::filesystem::path const& path, std::string const& solver,
                                     double tolerance);

} // namespace stiction::scene
