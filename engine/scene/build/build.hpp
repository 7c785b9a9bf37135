// From a script's table to a model: names resolved, geometry made, every contradiction reported.
#pragma once
#include "core/input.hpp"
#include "halfspace/model.hpp"
#include "scene/build/formula_choice.hpp"
#include "scene/description/parts.hpp"

namespace stiction::scene {

constexpr double show_wave = 8; ///< nodes of a relief to its shortest wave, as points of half spaces

/// What a relief has made of a boundary.
struct Relief {
  double least = 0, most = 0; ///< heights at its nodes, m
  double spacing = 0;         ///< of its nodes, where they are farthest apart, m
  double finest = 0;          ///< that spacing shows all of its map, m; infinite: any
};

/// A model with the names that its script gave.
struct Scene {
  ScenePart part;
  std::vector<std::string> bodies;        ///< names, in the order of model.bodies
  std::vector<std::string> pairs;         ///< names, in the order of model.pairs
  std::map<std::string, Relief> reliefs;  ///< by body
  std::vector<double> moved;              ///< [constraints] how far a tie has moved a node that follows, m
  std::unique_ptr<dynamics::Model> model; ///< null where there is a half space in its place
  std::unique_ptr<halfspace::Model> half_space;
  std::optional<FormulaChoice> formula; ///< that answers in place of the half space's points

  /// A set "body.set" with model node numbers; nothing if there is none.
  [[nodiscard]] std::optional<Indices> nodes_of(std::string const& set) const;
  [[nodiscard]] Index pair_index(std::string const& name) const; ///< -1 if unknown
  [[nodiscard]] Index nearest(Indices const& nodes, Numbers const& point) const;
};

/// Why several ranks cannot share this scene, in words; "" if they can.
[[nodiscard]] std::string unfit_for_ranks(Scene const& scene);

/// ranks: those that share the case, or null. Throws InputError with every complaint.
[[nodiscard]] Scene build(core::Input const& input, linear::Ranks const* ranks = nullptr);

} // namespace stiction::scene
