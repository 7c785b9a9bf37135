// Height maps from files: text, NumPy's arrays, HDF5.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace stiction::halfspace {

/// What a file says; heights in its own unit.
struct HeightFile {
  Index nx = 0, ny = 0;
  std::vector<double> heights;              ///< [ny, nx], rows along x
  std::string unit;                         ///< of the heights; empty where the file does not say
  std::optional<double> length_x, length_y; ///< m
};

/// Reads, by what it begins with: an .npy file (f4 or f8, in C or Fortran order, of one or two dimensions); a
/// data set of an HDF5 file (its attribute `unit` or `units`; `dataset` may be left out where there is but
/// one of two dimensions); else text: rows of numbers between blanks, tabs, commas or semicolons. Lines of
/// other words or after # may name Width, Height (or x-length, y-length) with their units and Value units (or
/// z-unit), as Gwyddion and SurfaceTopography write them. Throws InputError, its complaints at `file` or
/// `dataset`, where the file is missing, not readable, too large (8192 x 8192), not a rectangle or has holes.
[[nodiscard]] HeightFile read_heights(std::string const& path, std::string const& dataset = "");

/// "µm" as files write it to a factor in m; nothing where it is no length.
[[nodiscard]] std::optional<double> length_unit(std::string word);

namespace detail { // height_hdf5.cpp; files of both share these
[[noreturn]] void refuse_heights(std::string const& path, std::string const& why, char const* key = "file");
void check_count(std::string const& path, double nx, double ny);
[[nodiscard]] HeightFile read_hdf5(std::string const& path, std::string const& dataset);
} // namespace detail

} // namespace stiction::halfspace
