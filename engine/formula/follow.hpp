// From state to state of a formula as a displacement or a force drives it: to the nearest that is stable.
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "formula/formula.hpp"

namespace stiction::formula {

/// Contact grows while the drive is more than its state bears, and shrinks while it is less: so it jumps
/// where what it bears turns round. Sizes s are kept, nothing else.
class Follower {
public:
  /// The formula must outlive it.
  Follower(Formula const& formula, Drive drive);
  /// The state under this depth, m, or force, N, from the state before; nothing where a pull is more than the
  /// contact bears.
  [[nodiscard]] std::optional<State> follow(double drive);
  /// Of the last state.
  [[nodiscard]] double size() const { return size_; }
  /// States of the formula that were asked for.
  [[nodiscard]] long evaluations() const { return evaluations_; }
  /// Sizes where what the states bear turns round.
  [[nodiscard]] std::vector<double> const& turns() const { return turns_; }

private:
  [[nodiscard]] double bears(double s) const;
  [[nodiscard]] double root(double low, double high, double drive) const;
  [[nodiscard]] double turn(double low, double high, double sign) const;
  void find_turns();
  void grow(double from, double drive);
  [[nodiscard]] bool shrink(double from, double drive);

  Formula const* formula_;
  Drive drive_;
  std::vector<double> turns_; ///< sizes where what is borne turns round
  double size_ = 0;
  mutable long evaluations_ = 0;
};

/// The state of the largest pull on the way to where nothing touches, from the size `from` on.
[[nodiscard]] State largest_pull(Formula const& formula,
                                 double from = std::numeric_limits<double>::infinity());

} // namespace stiction::formula
