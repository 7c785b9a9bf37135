// What is recorded of a contact point.
#pragma once
#include <vector>

#include "dynamics/model/state.hpp"

namespace stiction::scene {

/// One recorded quantity of a contact point.
struct PointQuantity {
  char const *name, *unit, *meaning; ///< no unit: that of areas
  double (*value)(dynamics::ContactState const&);
  bool space = false; ///< only in 3D
};

inline constexpr PointQuantity point_quantities[] = {
    {"gap", "m", "x_n; the radius of the search where nothing is near",
     [](dynamics::ContactState const& c) { return c.gap; }},
    {"slip", "m", "signed slip since the start", [](dynamics::ContactState const& c) { return c.path[0]; }},
    {"slip_2", "m", "slip since the start along t2",
     [](dynamics::ContactState const& c) { return c.path[1]; }, true},
    {"stretch", "m", "bond stretch x_t", [](dynamics::ContactState const& c) { return c.bond.stretch[0]; }},
    {"stretch_2", "m", "bond stretch along t2",
     [](dynamics::ContactState const& c) { return c.bond.stretch[1]; }, true},
    {"beta", "1", "bond intensity", [](dynamics::ContactState const& c) { return c.bond.beta; }},
    {"pressure", "Pa", "dry normal reaction rbar_n",
     [](dynamics::ContactState const& c) { return c.dry[0]; }},
    {"friction", "Pa", "dry tangential reaction rbar_t",
     [](dynamics::ContactState const& c) { return c.dry[1]; }},
    {"friction_2", "Pa", "dry tangential reaction along t2",
     [](dynamics::ContactState const& c) { return c.dry[2]; }, true},
    {"adhesion_n", "Pa", "normal adhesion rtilde_n",
     [](dynamics::ContactState const& c) { return c.adhesion[0]; }},
    {"adhesion_t", "Pa", "tangential adhesion rtilde_t",
     [](dynamics::ContactState const& c) { return c.adhesion[1]; }},
    {"adhesion_t2", "Pa", "tangential adhesion along t2",
     [](dynamics::ContactState const& c) { return c.adhesion[2]; }, true},
    {"status", "1", "0 open, 1 stick, 2 slip",
     [](dynamics::ContactState const& c) { return static_cast<double>(c.status); }},
    {"area", nullptr,
     "area in the reference that the tractions act on: traction times area is the point's force",
     [](dynamics::ContactState const& c) { return c.area; }},
};

/// Those of the scene's dimension.
[[nodiscard]] inline std::vector<PointQuantity> quantities(int dim) {
  std::vector<PointQuantity> chosen;
  for (auto const& quantity : point_quantities)
    if (dim == 3 || !quantity.space)
      chosen.push_back(quantity);
  return chosen;
}

} // namespace stiction::scene
