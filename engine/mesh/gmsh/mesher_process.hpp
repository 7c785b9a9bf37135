// Runs the mesher, a program of its own, because gmsh is heavy to start and a fault in it ends its process.
#pragma once
#include <filesystem>
#include <string>

namespace stiction::mesh {

/// What became of the mesher's process.
struct MesherOutcome {
  int exit_code = 0;   ///< meaningful when signal is 0
  int signal = 0;      ///< that killed it, or 0
  std::string message; ///< what it printed
};

/// $STICTION_MESHER, the program beside the running one, or the one of the build; empty when there is none.
[[nodiscard]] std::filesystem::path find_mesher();

/// Runs `mesher REQUEST OUTPUT` to its end; `log` receives what it prints. Throws RunError when it cannot
/// start.
[[nodiscard]] MesherOutcome run_mesher(std::filesystem::path const& mesher,
                                       std::filesystem::path const& request,
                                       std::filesystem::path const& output);

} // namespace stiction::mesh
