// Regular grids as .vti.
#include <fmt/format.h>

#include "record/fields.hpp"
#include "record/file.hpp"
#include "record/vtk_document.hpp"

namespace stiction::record {

void write_vti(std::filesystem::path const& path, GridFrame const& frame) {
  auto const extent = fmt::format("0 {} 0 {} 0 0", frame.nx - 1, frame.ny - 1);
  Document document("ImageData", frame.time,
                    fmt::format(" WholeExtent=\"{}\" Origin=\"{} {} 0\" Spacing=\"{} {} 1\"", extent, frame.x,
                                frame.y, frame.dx, frame.dy),
                    fmt::format(" Extent=\"{}\"", extent));
  document.open("PointData");
  for (auto const& array : frame.point_arrays)
    document.add(array, ix(frame.nx) * ix(frame.ny));
  document.close("PointData");
  replace_file(path, document.text());
}

} // namespace stiction::record
