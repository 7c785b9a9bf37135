// Profiles over the distance from the axis, as states of contact points.
#include "scene/probes/formula_points.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::scene {

FormulaPoints::FormulaPoints(Scene const& scene, FormulaState const& now)
    : scene_(&scene), profile_(scene.formula->normal->profile(now.size)),
      depth_(std::isfinite(now.normal.depth) ? now.normal.depth : 0) {}

formula::Local FormulaPoints::local(Index point) const {
  auto const& grid = scene_->half_space->grid;
  return profile_(scene_->formula->distance(grid.x(point), grid.y(point)));
}

dynamics::ContactState FormulaPoints::at(Index point) const {
  auto const& model = *scene_->half_space;
  auto const here = local(point);
  dynamics::ContactState at;
  at.area = model.grid.area();
  at.in_reach = true;
  at.gap = here.touches ? 0 : std::max(0.0, model.heights[point] - depth_ + here.sink);
  if (here.touches) {
    at.status = model.law.tangential() ? interface::Status::stick : interface::Status::slip;
    at.dry[0] = here.pressure + scene_->formula->grip;
    at.adhesion[0] = 0 - scene_->formula->grip;
  } else
    at.adhesion[0] = 0 - here.pull;
  if (model.law.adhesion)
    at.bond = interface::initial_bond(*model.law.adhesion, at.gap);
  return at;
}

contact::Vec3 FormulaPoints::displacement(Index point) const {
  return {local(point).sink, 0, 0};
}

} // namespace stiction::scene
