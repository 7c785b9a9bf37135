// What concerns obstacles of every shape.
#include "contact/obstacle/obstacle.hpp"

namespace stiction::contact {

std::string unfit(Obstacle const& obstacle, int dim, bool axisymmetric) {
  return std::visit([&](auto const& shape) { return unfit(shape, dim, axisymmetric); }, obstacle);
}

void prepare(Obstacle& obstacle) {
  std::visit(
      [](auto& shape) {
        if constexpr (requires { prepare(shape); })
          prepare(shape);
      },
      obstacle);
}

} // namespace stiction::contact
