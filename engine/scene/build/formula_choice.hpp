// Which closed formula answers a half space under a height map, or why none does.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "formula/formula.hpp"
#include "formula/mindlin.hpp"
#include "halfspace/model.hpp"
#include "halfspace/shapes.hpp"

namespace stiction::scene {

/// A formula that fits, and why.
struct FormulaChoice {
  std::unique_ptr<formula::Formula> normal;
  std::optional<formula::Mindlin> along; ///< none: nothing acts along the surface
  formula::Drive drive = formula::Drive::depth;
  std::function<double(double, double)> distance; ///< of x, y from the axis or the middle, along waves, m
  double grip = 0;                                ///< of the law's adhesion where surfaces touch, Pa
  bool moved = false;                             ///< along the surface under friction
  std::string fits;                               ///< why it does
  std::string neglects;                           ///< what of the scene it leaves out; empty: nothing
};

/// The formula, or in words what keeps the scene from having one.
[[nodiscard]] std::variant<FormulaChoice, std::string> choose_formula(halfspace::Model const& model,
                                                                      halfspace::Shape const& surface);

/// Does it not stay where it starts?
[[nodiscard]] bool changes(dynamics::Path const& path);

} // namespace stiction::scene
