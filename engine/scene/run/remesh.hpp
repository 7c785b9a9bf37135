// Whether the meshes of a run were fine enough, and which sizes would have been.
#pragma once
#include <map>

#include "dynamics/step/stepper.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

/// By the name of a body where its cells lie and how large they are to be: x, y, size of each, m.
using CellSizes = std::map<std::string, std::vector<double>>;

/// The same scene with meshes of these sizes.
[[nodiscard]] core::Input with_sizes(core::Input input, CellSizes const& sizes);

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
  /// The sizes noted, of each body that asks for a remesh.
  [[nodiscard]] CellSizes sizes() const;
  /// Hands over all that is noted on the way, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    for (auto& [body, part, error, coarsest, size, now, centres] : bodies_)
      archive(error, coarsest, size);
  }

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
