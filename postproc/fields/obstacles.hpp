// Rigid obstacles behind a plane mesh: grey areas with their outline.
#pragma once
#include <vector>

#include <vtkRenderer.h>

#include "fields/view.hpp"

namespace stiction::postproc {

/// An obstacle at one time, in m.
struct Outline {
  std::vector<Point> points;
  bool closed = true; ///< the first point follows the last
  bool filled = true;
};

/// The obstacles of a field at `time`, with their images across its mirrors; half-planes as far as they
/// matter to `view`. Throws what pose_at throws.
[[nodiscard]] std::vector<Outline> outlines_at(FieldSpec const& field, std::optional<double> time,
                                               Extent const& view);

/// Widens a view by what of the obstacles lies near: within a tenth of its size.
void include_near(Extent& view, std::vector<Outline> const& outlines);

/// Adds areas and lines, `lift` away from the eye, `scale` pixels for one of 300 dots per inch.
void add_obstacles(vtkRenderer& renderer, std::vector<Outline> const& outlines, double lift, double scale);

} // namespace stiction::postproc
