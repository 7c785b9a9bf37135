// Components of the grid's vectors, point by point.
#include "halfspace/points.hpp"

template class stiction::dynamics::PointHistory<stiction::halfspace::GridPoints>;

namespace stiction::halfspace {

dynamics::ContactState contact_state(Model const& model, State const& state, Index point) {
  dynamics::ContactState at;
  int const D = model.components();
  at.gap = state.gap[point];
  at.area = model.grid.area();
  at.dry.head(D) = state.dry.segment(D * point, D) / at.area;
  at.adhesion.head(D) = state.force.segment(D * point, D) / at.area - at.dry.head(D);
  at.path.head(D - 1) = state.path.segment((D - 1) * point, D - 1);
  at.bond = state.bond_of(point);
  at.status = state.status_of(point);
  at.in_reach = true;
  return at;
}

Pace pace_of(dynamics::Accuracy const& accuracy, Model const& model) {
  using dynamics::StepSizes;
  return {History(GridPoints{&model}),
          StepSizes(accuracy, StepSizes::Kind::any, model.law.adhesion.has_value() || accuracy.events > 0)};
}

} // namespace stiction::halfspace
