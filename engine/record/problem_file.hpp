// Contact problems as HDF5 files, to be replayed against any solver.
#pragma once
#include <filesystem>

#include "contact/problem/problem.hpp"

namespace stiction::record {

/// Writes W, the free displacement, and per point area, mu and bond. Throws core::RunError.
void save_problem(std::filesystem::path const& path, contact::Problem const& problem);

/// Reads such a file, or one with a packed symmetric W ("W_upper_packed", "q", "mu", 3 components per
/// contact). Throws core::InputError for a file that is neither, truncated, or holds numbers that are not
/// finite.
[[nodiscard]] contact::Problem load_problem(std::filesystem::path const& path);

} // namespace stiction::record
