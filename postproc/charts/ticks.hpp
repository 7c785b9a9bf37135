// Where an axis has its ticks and what they say.
#pragma once
#include <string>
#include <vector>

namespace stiction::postproc {

/// The interval of an axis, in its unit; both ends positive when logarithmic.
struct Scale {
  double low = 0, high = 1;
  bool log = false;
  /// 0 at low, 1 at high; beyond them outside [0, 1].
  [[nodiscard]] double fraction(double value) const;
};

struct Tick {
  double value = 0;
  std::string label; ///< empty for a minor tick
};

struct Ticks {
  std::vector<Tick> ticks;
  int power = 0; ///< labels are the values divided by 10^power
};

/// Ticks at 1, 2 or 5 times a power of ten, about `wanted` of them labelled; on a logarithmic axis at all
/// multiples of powers of ten, of which those are labelled that say how the axis runs.
[[nodiscard]] Ticks ticks_for(Scale const& scale, int wanted);

/// An interval that shows all of [low, high] with a margin of 4 %; it starts at 0 when the data nearly does.
[[nodiscard]] Scale padded_scale(double low, double high, bool log);

/// "0.05", "−3": fixed with `decimals` places.
[[nodiscard]] std::string printed_number(double value, int decimals);

} // namespace stiction::postproc
