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

double slope_in_contact(Model const& model, State const& state) {
  auto const& grid = model.grid;
  auto const square = [&](Index step, Index end, double spacing) {
    double sum = 0;
    Index both = 0;
    for (Index i = 0; i < grid.size(); ++i) {
      Index const at = step == 1 ? i % grid.nx : i / grid.nx, next = i + step;
      if (at + 1 == end || state.status_of(i) == interface::Status::open ||
          state.status_of(next) == interface::Status::open)
        continue;
      double const slope = (model.heights[next] - model.heights[i]) / spacing;
      sum += slope * slope;
      ++both;
    }
    return both > 0 ? sum / static_cast<double>(both) : 0;
  };
  return std::sqrt(square(1, grid.nx, grid.dx()) + (grid.line ? 0 : square(grid.nx, grid.ny, grid.dy())));
}

bool reaches_rim(Model const& model, State const& state) {
  auto const& grid = model.grid;
  if (grid.periodic)
    return false;
  int const D = model.components();
  double const felt =
      model.law.adhesion ? 0.01 * interface::scales(*model.law.adhesion).strength * grid.area() : 0;
  auto const bears = [&](Index i) {
    return state.status_of(i) != interface::Status::open ||
           (felt > 0 && std::abs(state.force[D * i] - state.dry[D * i]) > felt);
  };
  Index const rows = grid.ny, columns = grid.nx;
  for (Index row = 0; row < rows; ++row) {
    bool const whole = rows > 1 && (row == 0 || row == rows - 1);
    for (Index column = 0; column < columns; column += whole ? 1 : std::max<Index>(columns - 1, 1))
      if (bears(row * columns + column))
        return true;
  }
  return false;
}

Pace pace_of(dynamics::Accuracy const& accuracy, Model const& model) {
  using dynamics::StepSizes;
  return {History(GridPoints{&model}),
          StepSizes(accuracy, StepSizes::Kind::any, model.law.adhesion.has_value() || accuracy.events > 0)};
}

} // namespace stiction::halfspace
