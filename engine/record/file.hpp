// Files that appear whole or not at all.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace stiction::record {

/// The name under which `path` is written until it is complete.
[[nodiscard]] std::filesystem::path part_name(std::filesystem::path const& path);

/// "cannot write PATH: REASON; ..." as the error of a run.
[[nodiscard]] core::RunError unwritable(std::filesystem::path const& path, std::string const& reason);

/// Writes `bytes` to a temporary name, then renames: a kill leaves the old file or the new one, never a part.
/// Throws core::RunError with the system's reason; the part is removed then.
void replace_file(std::filesystem::path const& path, std::string_view bytes);

/// Adds `bytes` to the end of a file, which is made if missing. Throws core::RunError with the system's
/// reason.
void append_file(std::filesystem::path const& path, std::string_view bytes);

/// Makes `folder` (and its parents) and tries to write there. Throws core::RunError with the reason and the
/// remedy when that fails.
void prepare_output(std::filesystem::path const& folder);

} // namespace stiction::record
