// The .vtu format: an XML head, then all arrays behind each other as zlib blocks ("appended raw").
#include <fmt/format.h>
#include <span>
#include <zlib.h>

#include "core/error.hpp"
#include "record/fields.hpp"
#include "record/file.hpp"

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

template<class Number> std::string bytes_of(std::span<double const> values) {
  std::vector<Number> const numbers(values.begin(), values.end());
  return {reinterpret_cast<char const*>(numbers.data()), numbers.size() * sizeof(Number)};
}

template<class Number> std::string bytes_of(std::vector<Number> const& numbers) {
  return {reinterpret_cast<char const*>(numbers.data()), numbers.size() * sizeof(Number)};
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

struct ArrayHead {
  std::string_view type, name;
  int components = 1;
  std::string_view unit = "";
};

/// Collects the document's head and its appended data.
class Document {
public:
  explicit Document(FieldFrame const& frame) {
    head_ = fmt::format("<?xml version=\"1.0\"?>\n"
                        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                        "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
                        "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
                        "format=\"ascii\">{}</DataArray></FieldData>\n"
                        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                        frame.time, frame.points.rows(), frame.cell_count());
  }
  void open(std::string_view element) { head_ += fmt::format("<{}>\n", element); }
  void close(std::string_view element) { head_ += fmt::format("</{}>\n", element); }
  void add(ArrayHead const& array, std::string const& raw) {
    head_ += fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                         "offset=\"{}\">",
                         array.type, escaped(array.name), array.components, data_.size());
    if (!array.unit.empty())
      head_ +=
          fmt::format("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{}</InformationKey>",
                      escaped(array.unit));
    head_ += "</DataArray>\n";
    data_ += compress_array(raw);
  }
  [[nodiscard]] std::string text() const {
    return head_ + "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_" + data_ +
           "\n</AppendedData>\n</VTKFile>\n";
  }

private:
  std::string head_, data_;
};

void add_field(Document& document, FieldArray const& array, std::size_t count) {
  core::expect(array.values.size() == count * static_cast<std::size_t>(array.components),
               "a field array as long as the frame has points or cells");
  ArrayHead const head{array.double_precision ? "Float64" : "Float32", array.name, array.components,
                       array.unit};
  document.add(head, array.double_precision ? bytes_of<double>(array.values) : bytes_of<float>(array.values));
}

void add_cells(Document& document, FieldFrame const& frame) {
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  for (auto const& block : frame.blocks) {
    auto const& info = mesh::info(block.kind);
    connectivity.insert(connectivity.end(), block.nodes.begin(), block.nodes.end());
    for (std::size_t cell = 0; cell < block.nodes.size() / static_cast<std::size_t>(info.nodes); ++cell) {
      offsets.push_back((offsets.empty() ? 0 : offsets.back()) + info.nodes);
      types.push_back(static_cast<std::uint8_t>(info.vtk_type));
    }
  }
  document.open("Cells");
  document.add({"Int64", "connectivity"}, bytes_of(connectivity));
  document.add({"Int64", "offsets"}, bytes_of(offsets));
  document.add({"UInt8", "types"}, bytes_of(types));
  document.close("Cells");
}

} // namespace

void write_vtu(std::filesystem::path const& path, FieldFrame const& frame) {
  auto const points = static_cast<std::size_t>(frame.points.rows());
  Document document(frame);
  document.open("PointData");
  for (auto const& array : frame.point_arrays)
    add_field(document, array, points);
  document.close("PointData");
  document.open("CellData");
  for (auto const& array : frame.cell_arrays)
    add_field(document, array, frame.cell_count());
  if (!frame.cell_body.empty())
    add_field(document, {"body", "", 1, frame.cell_body, false}, frame.cell_count());
  document.close("CellData");
  document.open("Points");
  document.add({"Float64", "points", 3, "m"},
               bytes_of<double>({frame.points.data(), static_cast<std::size_t>(frame.points.size())}));
  document.close("Points");
  add_cells(document, frame);
  replace_file(path, document.text());
}

} // namespace stiction::record
