// Pasting by rows of pixels, and PNG through memory so that a full disk is noticed.
#include "page/picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <zlib.h>

#include "core/error.hpp"

namespace stiction::postproc {

int width_of(Picture const& picture) {
  return picture->GetDimensions()[0];
}
int height_of(Picture const& picture) {
  return picture->GetDimensions()[1];
}

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

namespace {

/// Bytes of a whole number, the first the largest.
std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xffU);
  return bytes;
}

/// PNG's chunk that states the pixels per metre of both axes.
std::string resolution_chunk(int dpi) {
  auto const per_metre = static_cast<std::uint32_t>(std::lround(dpi / 0.0254));
  std::string const body = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  auto const sum =
      crc32(0, reinterpret_cast<unsigned char const*>(body.data()), static_cast<unsigned>(body.size()));
  return big_endian(9) + body + big_endian(static_cast<std::uint32_t>(sum));
}

} // namespace

void write_whole(std::string const& bytes, std::filesystem::path const& file) {
  auto const part = std::filesystem::path(file).concat(".part");
  std::ofstream out(part, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
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

void write_png(Picture const& picture, std::filesystem::path const& file, int dpi) {
  constexpr std::size_t head = 8 + 25; // PNG's signature and its first chunk
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  auto* result = writer->GetResult();
  std::string bytes(reinterpret_cast<char const*>(result->GetPointer(0)),
                    static_cast<std::size_t>(result->GetNumberOfValues()));
  write_whole(bytes.insert(head, resolution_chunk(dpi)), file);
}

} // namespace stiction::postproc
