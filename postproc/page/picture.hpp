// A finished picture: pixels in memory, put together and written.
#pragma once
#include <filesystem>
#include <string>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace stiction::postproc {

/// RGB, 8 bits, row 0 at the bottom.
using Picture = vtkSmartPointer<vtkImageData>;

[[nodiscard]] int width_of(Picture const& picture);
[[nodiscard]] int height_of(Picture const& picture);

/// White.
[[nodiscard]] Picture blank(int width, int height);
/// Copies a picture into a larger one; it must lie within.
void paste(Picture const& from, Picture const& to, int left, int bottom);

/// Writes atomically: the file appears whole or not at all. Throws core::RunError when it cannot be written.
void write_whole(std::string const& bytes, std::filesystem::path const& file);
/// The same for a picture as PNG that states its resolution.
void write_png(Picture const& picture, std::filesystem::path const& file, int dpi);

} // namespace stiction::postproc
