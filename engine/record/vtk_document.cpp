// Arrays as zlib blocks, as VTK's XML readers take them.
#include "record/vtk_document.hpp"

#include <fmt/format.h>
#include <span>
#include <zlib.h>

#include "core/error.hpp"

namespace stiction::record {

namespace {

constexpr std::size_t block_size = std::size_t{1} << 16; ///< bytes compressed at once; VTK reads any

void append_bytes(std::string& bytes, std::span<std::uint64_t const> numbers) {
  bytes.append(reinterpret_cast<char const*>(numbers.data()), numbers.size_bytes());
}

/// VTK's compressed array: number of blocks, size of a block, size of the last if partial, compressed sizes,
/// then the blocks.
std::string compress_array(std::string_view raw) {
  std::vector<std::uint64_t> head{(raw.size() + block_size - 1) / block_size, block_size,
                                  raw.size() % block_size};
  std::string blocks;
  for (std::size_t first = 0; first < raw.size(); first += block_size) {
    auto const part = raw.substr(first, block_size);
    uLongf size = compressBound(part.size());
    std::string packed(size, '\0');
    int const status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                                 reinterpret_cast<Bytef const*>(part.data()), part.size(), Z_BEST_SPEED);
    core::expect(status == Z_OK, "zlib to compress a block");
    blocks.append(packed, 0, size);
    head.push_back(size);
  }
  std::string bytes;
  append_bytes(bytes, head);
  return bytes + blocks;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (char const c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

} // namespace

Document::Document(std::string kind, double time, std::string_view of_grid, std::string_view of_piece)
    : kind_(std::move(kind)) {
  head_ = fmt::format("<?xml version=\"1.0\"?>\n"
                      "<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
                      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{0}{2}>\n"
                      "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                      "format=\"ascii\">{1}</DataArray></FieldData>\n"
                      "<Piece{3}>\n",
                      kind_, time, of_grid, of_piece);
}

void Document::open(std::string_view element) {
  head_ += fmt::format("<{}>\n", element);
}

void Document::close(std::string_view element) {
  head_ += fmt::format("</{}>\n", element);
}

void Document::add(ArrayHead const& array, std::string const& raw) {
  head_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                       "offset=\"{}\">",
                       array.type, escaped(array.name), array.components, data_.size());
  if (!array.unit.empty())
    head_ += fmt::format("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                         escaped(array.unit));
  head_ += "</DataArray>\n";
  data_ += compress_array(raw);
}

void Document::add(FieldArray const& array, std::size_t count) {
  core::expect(array.values.size() == count * static_cast<std::size_t>(array.components),
               "a field array as long as the frame has points or cells");
  ArrayHead const head{array.double_precision ? "Float64" : "Float32", array.name, array.components,
                       array.unit};
  add(head, array.double_precision ? bytes_as<double>(array.values.data(), array.values.size())
                                   : bytes_as<float>(array.values.data(), array.values.size()));
}

std::string Document::text() const {
  return fmt::format("{}</Piece>\n</{}>\n<AppendedData encoding=\"raw\">\n_{}\n</AppendedData>\n</VTKFile>\n",
                     head_, kind_, data_);
}

} // namespace stiction::record
