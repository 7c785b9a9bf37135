// Contact in closed form: states in equilibrium, one after the other from the first touch on.
#pragma once
#include <limits>
#include <string_view>

namespace stiction::formula {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One state. What a formula does not give is `unknown`.
struct State {
  double depth = unknown; ///< of the counterpart beyond the first touch, m
  double force = 0;       ///< that presses, N (a line: N/m)
  double area = 0;        ///< that touches, m^2 (a line: m)
  double peak = unknown;  ///< largest pressure, 0 where all is drawn, Pa
};

/// What a formula gives beside force and area.
struct Gives {
  bool depth = true, peak = true;
};

/// What is given of a state.
enum class Drive { depth, force };

/// A family of states over s >= 0, which grows with the contact. s = 0: nothing touches, and the least more
/// depth or force, or a pull, makes it touch.
class Formula {
public:
  virtual ~Formula() = default;
  [[nodiscard]] virtual State at(double s) const = 0;
  [[nodiscard]] virtual Gives gives() const { return {}; }
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view source() const = 0;
};

} // namespace stiction::formula
