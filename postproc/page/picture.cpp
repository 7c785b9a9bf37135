// Tiling by rows of pixels, and PNG through memory so that a full disk is noticed.
#include "page/picture.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "core/error.hpp"

namespace stiction::postproc {

int width_of(Picture const& picture) {
  return picture->GetDimensions()[0];
}
int height_of(Picture const& picture) {
  return picture->GetDimensions()[1];
}

namespace {

Picture blank(int width, int height) {
  auto picture = Picture::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixels = static_cast<unsigned char*>(picture->GetScalarPointer());
  std::fill_n(pixels, 3 * static_cast<std::ptrdiff_t>(width) * height, static_cast<unsigned char>(255));
  return picture;
}

void paste(Picture const& from, Picture const& to, int left, int bottom) {
  for (int row = 0; row < height_of(from); ++row) {
    auto const* source = static_cast<unsigned char const*>(from->GetScalarPointer(0, row, 0));
    auto* target = static_cast<unsigned char*>(to->GetScalarPointer(left, bottom + row, 0));
    std::copy_n(source, 3 * width_of(from), target);
  }
}

} // namespace

Picture tile(std::vector<Picture> const& pictures, int columns, int gap) {
  auto const count = static_cast<int>(pictures.size());
  int const rows = (count + columns - 1) / columns, used = std::min(columns, count);
  std::vector<int> heights(static_cast<std::size_t>(rows), 0);
  for (int i = 0; i < count; ++i) {
    auto& height = heights[static_cast<std::size_t>(i / columns)];
    height = std::max(height, height_of(pictures[static_cast<std::size_t>(i)]));
  }
  int const width = width_of(pictures.front());
  int total = gap * (rows - 1);
  for (int const height : heights)
    total += height;
  auto result = blank(used * width + (used - 1) * gap, total);
  int top = total;
  for (int i = 0; i < count; ++i) {
    auto const& picture = pictures[static_cast<std::size_t>(i)];
    paste(picture, result, (i % columns) * (width + gap), top - height_of(picture));
    if (i % columns == columns - 1)
      top -= heights[static_cast<std::size_t>(i / columns)] + gap;
  }
  return result;
}

void write_png(Picture const& picture, std::filesystem::path const& file) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  auto* bytes = writer->GetResult();
  auto const part = std::filesystem::path(file).concat(".part");
  std::ofstream out(part, std::ios::binary);
  out.write(reinterpret_cast<char const*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  out.close();
  std::error_code problem;
  if (out)
    std::filesystem::rename(part, file, problem);
  if (out && !problem)
    return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw core::RunError(
      fmt::format("cannot write {}: is the folder writable and the disk not full?", file.string()));
}

} // namespace stiction::postproc
