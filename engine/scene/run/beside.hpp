// Runs beside a case's own in which one parameter each is a little different: what derivatives are
// differences of.
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "dynamics/step/visit.hpp"
#include "scene/run/recorder.hpp"
#include "scene/run/run.hpp"

namespace stiction::scene {

/// Readies a scene for runs beside its own: its steps must not differ for what they leave undone. Nothing
/// where none are asked for. Throws InputError where it can have none.
void ready_for(std::vector<Shifted> const& asked, Scene& scene);

/// The scene that runs beside another one. Throws InputError where the two differ in more than numbers.
[[nodiscard]] Scene scene_beside(Shifted const& shifted, Scene const& scene);

/// Throws InputError where a scene can have no such runs beside its own.
void check_beside(core::Input const& input, std::vector<Shifted> const& asked);

/// Takes away what earlier runs of the case have left of such.
void remove_runs_beside(std::filesystem::path const& folder);

/// One such run. It makes the steps of the case's own stepper, each corrected with that one's factor, and
/// keeps histories in <case>/derivatives/<name>.
class Beside {
public:
  /// scene: of the case. Throws InputError where the other one differs from it in more than numbers. All must
  /// outlive it.
  Beside(Shifted const& shifted, Scene const& scene, dynamics::Stepper const& lead);
  /// anew: or from the mark that `visit` has read.
  void begin_files(std::filesystem::path const& folder, bool anew);
  /// The step of size dt that `lead` has just made, of all that have not ended.
  static void follow(std::span<std::unique_ptr<Beside> const> all, dynamics::Stepper& lead,
                     dynamics::Outcome const& made, double dt);
  void close();
  /// What it came to, for the case's result.
  [[nodiscard]] BesideResult const& result() const { return result_; }
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    if (!Archive::reads && recorder_)
      mark_ = recorder_->mark();
    archive(state_, mark_, result_.steps, result_.turned, result_.rough, result_.ended, result_.iterations,
            careful_);
  }

private:
  [[nodiscard]] bool looks() const;
  void take(dynamics::Outcome outcome, dynamics::Outcome const& made, double dt);

  Scene scene_;
  dynamics::Stepper stepper_;
  dynamics::State state_;
  std::optional<Recorder> recorder_;
  RecordMark mark_;
  bool careful_ = false; ///< one correction was not enough when it was last looked at
  BesideResult result_;
};

} // namespace stiction::scene
