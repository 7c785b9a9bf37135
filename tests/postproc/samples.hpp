// Small result files to draw from: histories, a mesh with fields, its index of steps.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace samples {

/// A history with /time (s), /crown/beta (1), /crown/traction [rows, 2] (Pa), /crown/pressure (MPa) and
/// /crown/broken (a NaN at row 5); the dataset's growth is set by mu.
void write_series(std::filesystem::path const& file, double mu);

/// A block on a half-disc in quads, with point data displacement, von_mises, beta and cell data density.
void write_grid(std::filesystem::path const& file, double descent);

/// One quad8 of unit size (m) whose lower side bulges down by half; point data beta = 1.
void write_curved(std::filesystem::path const& file);

/// A quarter of a block, 8 mm by 8 mm by 5 mm high from the origin on, of tet4, tet10, hex8 or hex20, dented
/// at the middle of its top; point data displacement, von_mises, beta and cell data layer (its z in m), at 1
/// ms.
void write_solid(std::filesystem::path const& file, std::string const& kind);

/// An index of two steps of write_grid, at 0 s and 1 ms: fields.pvd and fields/.
void write_steps(std::filesystem::path const& folder);

/// A text file.
void write_text(std::filesystem::path const& file, std::string const& text);

} // namespace samples
