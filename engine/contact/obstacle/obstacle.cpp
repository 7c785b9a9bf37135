// What concerns obstacles of every shape.
#include "contact/obstacle/obstacle.hpp"

namespace stiction::contact {

std::string unfit(Obstacle const& obstacle, int dim, bool axisymmetric) {
  return std::visit([&](auto const& shape) { return unfit(shape, dim, axisymmetric); }, obstacle);
}

void prepare(Obstacle& obstacle) {
  if (auto* line = std::get_if<RigidPolyline>(&obstacle))
    prepare(*line);
  if (auto* surface = std::get_if<RigidSurface>(&obstacle))
    prepare(*surface);
}

} // namespace stiction::contact
