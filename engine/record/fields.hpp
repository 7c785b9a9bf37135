// Fields over a mesh or a grid as VTK files: one .vtu or .vti a moment, and a .pvd that lists them by time.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::record {

/// Values of all points or of all cells, point after point.
struct FieldArray {
  std::string name;
  std::string unit;           ///< stored as VTK's UNITS_LABEL
  int components = 1;         ///< 1, 3 (vector) or 6 (symmetric tensor, VTK's order XX YY ZZ XY YZ XZ)
  std::vector<double> values; ///< [points or cells, components]
  bool double_precision = false;
};

/// What is drawn of one moment. Cells count through `blocks` in their order.
struct FieldFrame {
  double time = 0;                 ///< s
  Matrix points = Matrix(0, 3);    ///< [points, 3], m, undeformed
  std::vector<mesh::Block> blocks; ///< nodes are rows of `points`
  std::vector<FieldArray> point_arrays, cell_arrays;
  std::vector<double> cell_body; ///< [cells], number of the body; written as cell array "body"

  [[nodiscard]] std::size_t cell_count() const;
};

/// Appends the points and cells of a mesh as the next body. Its points follow those already there.
void add_body(FieldFrame& frame, mesh::Mesh const& mesh);

/// Writes one frame as a zlib-compressed binary .vtu that appears whole or not at all. Array sizes that do
/// not fit the frame are a core::Bug; a file that cannot be written is a core::RunError.
void write_vtu(std::filesystem::path const& path, FieldFrame const& frame);

/// What is drawn of the points of a regular grid, along x first.
struct GridFrame {
  double time = 0;       ///< s
  Index nx = 1, ny = 1;  ///< points
  double x = 0, y = 0;   ///< of the first, m
  double dx = 1, dy = 1; ///< m
  std::vector<FieldArray> point_arrays;
};

/// Writes one frame as .vti, as `write_vtu` does.
void write_vti(std::filesystem::path const& path, GridFrame const& frame);

/// How many frames there are, and what the .pvd says of them.
struct FieldMark {
  std::size_t count = 0;
  std::string entries;
  template<class Archive> void visit(Archive& archive) { archive(count, entries); }
};

/// The frames of one case: fields/000000.vtu, ... (.vti of grids) and fields.pvd, complete after every write.
/// Frames of an earlier run in the same folder but those of `from`, to be gone on from, are removed first.
/// Throws Unfit if one of these is missing.
class FieldSeries {
public:
  explicit FieldSeries(std::filesystem::path case_folder, FieldMark from = {});
  void write(FieldFrame const& frame);
  void write(GridFrame const& frame);
  [[nodiscard]] std::size_t frames() const { return done_.count; }
  [[nodiscard]] FieldMark const& mark() const { return done_; }

private:
  void write_list() const;
  template<class Write> void write_next(double time, char const* extension, Write const& write);

  std::filesystem::path folder_;
  FieldMark done_;
};

} // namespace stiction::record
