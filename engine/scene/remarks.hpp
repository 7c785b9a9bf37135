// What a run has to say about its own answers: where theory promises no single one, and energy made or lost
// by the time scheme.
#pragma once
#include "contact/uniqueness.hpp"
#include "dynamics/contact_stage.hpp"
#include "scene/build.hpp"

namespace stiction::scene {

/// Looks at steps; keeps one remark of each kind, of the step that was first, and counts the rest.
class Remarks {
public:
  explicit Remarks(Scene const& scene) : scene_(&scene) {}
  /// A step to time t, accepted, or without an answer to its contact problem: then all points are looked at.
  void look(dynamics::ContactStage const& contact, double t, contact::Look look);
  /// The account of energy after an accepted step.
  void weigh(dynamics::Ledger const& ledger);
  /// In the order in which they are made; empty where nothing is in doubt.
  [[nodiscard]] std::vector<std::string> texts() const;

private:
  struct Remark {
    std::string text;
    long steps = 0;
  };
  Scene const* scene_;
  Remark friction_, softening_;
  long steps_ = 0;
  double turned_over_ = 0;     ///< largest energy or work so far, J
  double stabilised_ = 0;      ///< dissipated by the stabilisation of quasi-statics, J
  double made_ = 0, lost_ = 0; ///< by the time scheme: the most so far, and in the end, J
};

} // namespace stiction::scene
