// A finished picture: pixels in memory, put together and written as PNG.
#pragma once
#include <filesystem>
#include <vector>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace stiction::postproc {

/// RGB, 8 bits, row 0 at the bottom.
using Picture = vtkSmartPointer<vtkImageData>;

[[nodiscard]] int width_of(Picture const& picture);
[[nodiscard]] int height_of(Picture const& picture);

/// Pictures of one width in rows of `columns`, `gap` pixels apart, tops aligned, on white.
[[nodiscard]] Picture tile(std::vector<Picture> const& pictures, int columns, int gap);

/// Writes atomically: the file appears whole or not at all. Throws core::RunError when it cannot be written.
void write_png(Picture const& picture, std::filesystem::path const& file);

} // namespace stiction::postproc
