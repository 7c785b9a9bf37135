// The manifest of a run: what was asked, with which program, as JSON.
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/input.hpp"
#include "core/schema.hpp"

namespace stiction::record {

/// Flags, texts and numbers as such, lists as arrays; JSON has no infinities, they become "inf", "-inf",
/// "nan".
[[nodiscard]] nlohmann::json to_json(core::Value const& value);

/// A script's tree of values. A quantity with a dimension becomes {"value", "unit"} in SI; a table made by a
/// constructor carries "kind", the constructor's tag.
[[nodiscard]] nlohmann::json to_json(core::Input const& input);

/// Every parameter of `object` by name: {"value", "unit", "meaning"}; nested tables are left to their own
/// schema. `object` must be of the struct that `schema` describes.
[[nodiscard]] nlohmann::json describe(void const* object, core::Schema const& schema);

/// Program version, commit, compiler and flags, libraries, processor.
[[nodiscard]] nlohmann::json build_identity();

/// What decides last digits beside the program: the processor, and for which one OpenBLAS computes on it, as
/// OPENBLAS_CORETYPE may say.
[[nodiscard]] std::string const& processor();

/// What the run is made on: {"processor", "cores", "system"}.
[[nodiscard]] nlohmann::json host_facts();

/// The present time as ISO 8601 in UTC: "2026-01-31T12:00:00Z".
[[nodiscard]] std::string utc_now();

/// Writes the manifest indented, keys sorted, whole or not at all. Throws core::RunError.
void write_manifest(std::filesystem::path const& path, nlohmann::json const& manifest);

} // namespace stiction::record
