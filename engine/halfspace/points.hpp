// The points of a half space as others are recorded, and what steps of bonds at them are off by.
#pragma once
#include "dynamics/adaptivity/pace.hpp"
#include "halfspace/model.hpp"

namespace stiction::halfspace {

[[nodiscard]] dynamics::ContactState contact_state(Model const& model, State const& state, Index point);

/// As dynamics::PointHistory wants them: of one pair.
struct GridPoints {
  using State = halfspace::State;
  using Kept = State;
  Model const* model;

  [[nodiscard]] static std::size_t pairs(State const&) { return 1; }
  [[nodiscard]] static std::size_t size(State const& state, std::size_t) { return state.status.size(); }
  [[nodiscard]] dynamics::ContactState at(State const& state, std::size_t, std::size_t point) const {
    return contact_state(*model, state, static_cast<Index>(point));
  }
  [[nodiscard]] static double beta(State const& state, std::size_t, std::size_t point) {
    return state.bond_of(static_cast<Index>(point)).beta;
  }
  [[nodiscard]] static Kept keep(State const& state) { return state; }
  [[nodiscard]] std::optional<interface::AdhesionLaw> const& adhesion(std::size_t) const {
    return model->law.adhesion;
  }
  static void set_beta(State& state, std::size_t, std::size_t point, double beta) {
    state.beta[static_cast<Index>(point)] = beta;
  }
  [[nodiscard]] static bool audited() { return false; }
};

using History = dynamics::PointHistory<GridPoints>;
using Pace = dynamics::Pace<History>;

/// Root mean square slope between neighbours that both touch, of the surfaces as they are at rest.
[[nodiscard]] double slope_in_contact(Model const& model, State const& state);
/// Does an outermost point of a free surface touch, or is it pulled by a hundredth of the adhesion's
/// strength?
[[nodiscard]] bool reaches_rim(Model const& model, State const& state);

[[nodiscard]] Pace pace_of(dynamics::Accuracy const& accuracy, Model const& model);

} // namespace stiction::halfspace

extern template class stiction::dynamics::PointHistory<stiction::halfspace::GridPoints>;
