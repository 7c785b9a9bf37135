// Meshes made by the mesher, kept by the content of their request so that each is made once.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// 32 hexadecimal digits that depend on every byte (two FNV-1a sums; not proof against malice).
[[nodiscard]] std::string content_hash(std::string_view bytes);

/// $XDG_CACHE_HOME/stiction/meshes or ~/.cache/stiction/meshes, else a folder below the temporary one.
[[nodiscard]] std::filesystem::path cache_folder();

/// The mesh that answers `request` (JSON), from the cache or made now; `what` names it in messages.
/// Throws InputError with the mesher's words when it refuses or crashes, or when no mesher was built.
[[nodiscard]] Mesh mesh_for_request(std::string const& request, std::string const& what);

} // namespace stiction::mesh
