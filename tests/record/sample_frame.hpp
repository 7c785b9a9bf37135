// A frame of two bodies with every kind of array, large enough to need several compressed blocks.
#pragma once
#include "record/fields.hpp"

namespace stiction::test {

inline constexpr Index strip_columns = 6000;

inline mesh::Mesh strip() {
  mesh::Mesh mesh;
  mesh.nodes = Matrix(2 * (strip_columns + 1), 2);
  mesh::Block block{mesh::CellKind::quad4, {}};
  for (Index i = 0; i <= strip_columns; ++i)
    for (Index j = 0; j < 2; ++j)
      mesh.nodes.row(2 * i + j) << 1e-3 * i, 2e-3 * j;
  for (Index i = 0; i < strip_columns; ++i)
    block.nodes.insert(block.nodes.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  mesh.blocks.push_back(block);
  return mesh;
}

inline mesh::Mesh triangle() {
  mesh::Mesh mesh;
  mesh.nodes = Matrix(6, 2);
  mesh.nodes << 0, 0, 1, 0, 0, 1, 0.5, 0, 0.5, 0.5, 0, 0.5;
  mesh.blocks.push_back({mesh::CellKind::tri6, {0, 1, 2, 3, 4, 5}});
  return mesh;
}

/// Exact in single precision too.
inline double sample_value(std::size_t i) {
  return 0.25 * static_cast<double>(i) - 7;
}

inline record::FieldArray sample_array(std::string name, std::string unit, int components,
                                       std::size_t count) {
  record::FieldArray array{std::move(name), std::move(unit), components, {}};
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i)
    array.values.push_back(sample_value(i));
  return array;
}

inline record::FieldFrame sample_frame() {
  record::FieldFrame frame;
  frame.time = 0.125;
  record::add_body(frame, strip());
  record::add_body(frame, triangle());
  auto const points = static_cast<std::size_t>(frame.points.rows());
  frame.point_arrays = {sample_array("displacement", "m", 3, points), sample_array("beta", "1", 1, points)};
  frame.point_arrays[1].double_precision = true;
  frame.cell_arrays = {sample_array("stress", "N/m^2 & <\"Pa\">", 6, frame.cell_count())};
  return frame;
}

} // namespace stiction::test
