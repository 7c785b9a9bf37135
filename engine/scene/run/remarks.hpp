// What a run has to say about its own answers: where theory promises no single one, and energy made or lost
// by the time scheme.
#pragma once
#include <limits>

#include "contact/problem/uniqueness.hpp"
#include "dynamics/step/stepper.hpp"
#include "scene/build/build.hpp"
#include "scene/run/dug_in.hpp"

namespace stiction::scene {

/// Looks at steps; keeps one remark of each kind, of the step that was first, and counts the rest.
class Remarks {
public:
  explicit Remarks(Scene const& scene)
      : scene_(&scene), nearest_(scene.pairs.size(), std::numeric_limits<double>::infinity()) {}
  /// An accepted step to time t. lost: the part of the energy that it turned over which its scheme lost, as
  /// bodies at rest do that snap.
  void examine(dynamics::ContactSystem const& contact, double t, double lost);
  /// A step to time t without an answer to its contact problem.
  void examine_unanswered(dynamics::ContactSystem const& contact, double t);
  /// The account of energy before and after an accepted step; rounded: what its works are rounded by, J.
  void weigh(dynamics::Ledger const& old, dynamics::Ledger const& ledger, double rounded);
  /// How well an accepted step meets the balance of forces.
  void balance(dynamics::Outcome const& outcome);
  /// Whether anything of a pair has touched or adhered by an accepted state, and how near it came.
  void seek_met(dynamics::State const& state);
  /// Points of an accepted state that lie in the side of their counterpart.
  void seek_beneath(dynamics::State const& state);
  /// Bonds that a step takes from points that leave their counterpart past its border.
  void seek_let_go(dynamics::State const& old, dynamics::State const& next);
  /// Nodes of a primary that lie within the body of its secondary by a good part of a facet.
  void seek_dug_in(dynamics::State const& state);
  /// Bodies of a law for small strains that are strained or turned by more at a stage's end.
  void seek_large_strain(dynamics::State const& state);
  /// residual: the largest that rounding kept the contact solver at.
  void rounded(double residual) { contact_ = residual; }
  /// In the order in which they are made; empty where nothing is in doubt.
  [[nodiscard]] std::vector<std::string> texts() const;
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    auto& [scene, friction, softening, weakening, beneath, let_go, strained, dug_in, digs, dug_part, steps,
           force, unmet, contact, weighed, surface, turned_over, spent, stabilised, made, lost, torn,
           torn_free, nearest] = *this;
    archive(friction, softening, weakening, beneath, let_go, strained, dug_in, dug_part, steps, force, unmet,
            contact, weighed, surface, turned_over, spent, stabilised, made, lost, torn, torn_free, nearest);
  }

private:
  void note(dynamics::ContactSystem const& contact, double t, contact::Doubts const& found);
  void add_rounded(std::vector<std::string>& all) const;
  void add_unmet(std::vector<std::string>& all) const;
  [[nodiscard]] std::string losing_less() const;
  struct Remark {
    std::string text;
    long steps = 0;
    template<class Archive> void visit(Archive& archive) { archive(text, steps); }
  };
  Scene const* scene_;
  Remark friction_, softening_, weakening_, beneath_, let_go_;
  std::string strained_, dug_in_;
  std::vector<DigSearch> digs_; ///< [pairs], once asked for
  double dug_part_ = 0;         ///< depth of that, over the size of a facet
  long steps_ = 0;
  double force_ = 0, unmet_ = 0; ///< largest nodal force; largest imbalance beyond the tolerance, N
  double contact_ = 0;           ///< residual, of its yardstick
  bool weighed_ = false;
  double surface_ = 0;              ///< energy of the surfaces before the first step, J
  double turned_over_ = 0;          ///< largest energy or work so far, J
  double spent_ = 0;                ///< without inertia: lost by bonds or friction, J
  double stabilised_ = 0;           ///< dissipated by the stabilisation of quasi-statics, J
  double made_ = 0, lost_ = 0;      ///< by the time scheme: the most so far, and in the end, J
  double torn_ = 0, torn_free_ = 0; ///< taken by bonds that open; of that made by the time scheme, J
  std::vector<double> nearest_;     ///< smallest gap of each pair, m; infinite: none seen, -infinite: it met
};

/// Part of the energy that a step turned over which its scheme lost, 1.
[[nodiscard]] double lost_part(dynamics::Ledger const& old, dynamics::Ledger const& next);

/// What a run without inertia does that `accuracy` does not see, where it decides over the steps; or empty.
[[nodiscard]] std::string unseen_by_accuracy(Scene const& scene);

} // namespace stiction::scene
