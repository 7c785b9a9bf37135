// Unstructured grids as .vtu.
#include <fmt/format.h>

#include "record/fields.hpp"
#include "record/file.hpp"
#include "record/vtk_document.hpp"

namespace stiction::record {

namespace {

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
  document.add(ArrayHead{"Int64", "connectivity"}, bytes_of(connectivity));
  document.add(ArrayHead{"Int64", "offsets"}, bytes_of(offsets));
  document.add(ArrayHead{"UInt8", "types"}, bytes_of(types));
  document.close("Cells");
}

} // namespace

void write_vtu(std::filesystem::path const& path, FieldFrame const& frame) {
  auto const points = static_cast<std::size_t>(frame.points.rows());
  Document document("UnstructuredGrid", frame.time, "",
                    fmt::format(" NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", points, frame.cell_count()));
  document.open("PointData");
  for (auto const& array : frame.point_arrays)
    document.add(array, points);
  document.close("PointData");
  document.open("CellData");
  for (auto const& array : frame.cell_arrays)
    document.add(array, frame.cell_count());
  if (!frame.cell_body.empty())
    document.add(FieldArray{"body", "", 1, frame.cell_body, false}, frame.cell_count());
  document.close("CellData");
  document.open("Points");
  document.add(ArrayHead{"Float64", "points", 3, "m"},
               bytes_as<double>(frame.points.data(), static_cast<std::size_t>(frame.points.size())));
  document.close("Points");
  add_cells(document, frame);
  replace_file(path, document.text());
}

} // namespace stiction::record
