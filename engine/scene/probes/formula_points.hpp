// What a formula says of the points of the grid that its scene has.
#pragma once
#include "halfspace/model.hpp"
#include "scene/probes/formula_probes.hpp"

namespace stiction::scene {

/// The points at one moment. Adhesion of no range (JKR) is none at any point: the pressure next to the rim
/// falls below 0 by it.
class FormulaPoints {
public:
  /// The scene must outlive it.
  FormulaPoints(Scene const& scene, FormulaState const& now);
  [[nodiscard]] dynamics::ContactState at(Index point) const;
  /// Along (n, x, y), n into the half space, m: of a line beyond that of the middle.
  [[nodiscard]] contact::Vec3 displacement(Index point) const;

private:
  [[nodiscard]] formula::Local local(Index point) const;
  Scene const* scene_;
  formula::Profile profile_;
  double depth_; ///< m
};

} // namespace stiction::scene
