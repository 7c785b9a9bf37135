// A rigid sphere beside the mesh: a translucent ball round a solid, a circle in a plane picture.
#pragma once
#include <vtkRenderer.h>

#include "fields/view.hpp"

namespace stiction::postproc {

/// Where the centre is at `time` (s). Throws core::RunError when it moves and the time is not known.
[[nodiscard]] Vector centre_at(SphereSpec const& sphere, std::optional<double> time);

/// Adds the sphere of `field` at `centre`; its circle is drawn `lift` toward the eye, `scale`
/// pixels wide for one of 300 dots per inch.
void add_sphere(vtkRenderer& renderer, FieldSpec const& field, Vector const& centre, double lift,
                double scale);

} // namespace stiction::postproc
