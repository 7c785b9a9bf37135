// How long a run tries: the limits of a schedule on what is lost on one step, and on the whole run.
#pragma once
#include <functional>
#include <string>

#include "scene/description/parts.hpp"

namespace stiction::scene {

/// What a stepper has done so far and what it may do for once, in operations: a factorization, or what takes
/// as much.
struct Work {
  std::function<double()> so_far, once;
};

/// Counts what failed attempts lose until the run has come a nominal step further.
class Patience {
public:
  Patience(SchedulePart const& limits, Work work);

  /// A stage with steps of that size begins, s.
  void begin(double nominal) { nominal_ = nominal; }
  /// Before an attempt.
  void begin_attempt();
  /// The attempt failed. Why the run must end, or nothing.
  [[nodiscard]] std::string lost();
  /// Has the present attempt, which may yet succeed, taken so much that it is as good as lost?
  [[nodiscard]] bool spent() const;
  /// The attempt was accepted and led to t.
  void reached(double t);
  /// Why a run of so many seconds must end, or nothing.
  [[nodiscard]] std::string late(double seconds) const;
  /// Hands over all that attempts change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    auto& [limits, work, nominal, since, before, lost, cuts] = *this;
    archive(nominal, since, lost, cuts);
  }

private:
  [[nodiscard]] double most() const;

  SchedulePart const* limits_;
  Work work_;
  double nominal_ = 0, since_ = 0; ///< s
  double before_ = 0, lost_ = 0;   ///< operations
  int cuts_ = 0;
};

} // namespace stiction::scene
