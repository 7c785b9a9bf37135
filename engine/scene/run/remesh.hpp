// Whether the meshes of a run were fine enough, and which sizes would have been.
#pragma once
#include "dynamics/step/stepper.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

/// Looks at the bodies that ask for a remesh, at every end of a stage.
class MeshControl {
public:
  MeshControl(Scene const& scene, dynamics::State const& start);

  /// Notes the errors of this moment and the sizes that would bring them to the target.
  void examine(dynamics::State const& state);
  /// Does any body ask for it?
  [[nodiscard]] bool wanted() const { return !bodies_.empty(); }
  [[nodiscard]] bool fine_enough() const;
  /// Meshes at most.
  [[nodiscard]] int passes() const;
  /// Largest relative error of the stress of any body at any moment.
  [[nodiscard]] double error() const;
  /// What the last mesh leaves undone, and the remedy, a text for each body; empty if it is fine enough.
  [[nodiscard]] std::vector<std::string> doubts() const;
  /// The same scene with meshes of the sizes noted.
  [[nodiscard]] core::Input finer(core::Input input) const;

private:
  struct Seen {
    std::size_t body = 0;
    RemeshPart part;
    double error = 0, coarsest = 0; ///< largest relative error; of bonded cells, over what they should be
    std::vector<double> size, now;  ///< [cells] wanted and present, m
    Matrix centres;                 ///< [cells, 2], m
  };
  void note_errors(Seen& seen, dynamics::State const& state) const;
  void note_bonds(Seen& seen, dynamics::State const& state) const;

  Scene const* scene_;
  std::vector<Seen> bodies_;
  std::vector<double> cohesive_; ///< [pairs] cohesive length, m; infinite without adhesion
};

} // namespace stiction::scene
