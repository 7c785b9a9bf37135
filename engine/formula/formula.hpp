// Contact in closed form: states in equilibrium, one after the other from the first touch on.
#pragma once
#include <functional>
#include <limits>
#include <string_view>

namespace stiction::formula {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One state. What a formula does not give is `unknown`.
struct State {
  double depth = unknown;  ///< of the counterpart beyond the first touch, m
  double force = 0;        ///< that presses, N (a line: N/m)
  double area = 0;         ///< that touches, m^2 (a line: m)
  double peak = unknown;   ///< pressure of the middle, below 0 where it is drawn, Pa
  double strain = unknown; ///< energy of the bodies, J (a line: J/m)
  double bond = 0;         ///< energy of what adheres, 0 apart, J (a line: J/m)
};

/// What happens at a place of the surface.
struct Local {
  bool touches = false;
  double pressure = 0; ///< between what touches, with the pull of what adheres, Pa
  double pull = 0;     ///< of what adheres and does not touch, Pa
  double sink = 0;     ///< of the surface under all that acts, m; of lines beyond that of the middle
};

/// Over the distance from the axis, or along waves from a crest, m.
using Profile = std::function<Local(double)>;

/// What a formula gives beside force, area and profiles.
struct Gives {
  bool depth = true, peak = true;
  std::string_view no_energy = ""; ///< why not, if it gives none
};

/// What is given of a state.
enum class Drive { depth, force };

/// A family of states over s >= 0, which grows with the contact. s = 0: nothing touches, and the least more
/// depth or force, or a pull, makes it touch.
class Formula {
public:
  virtual ~Formula() = default;
  [[nodiscard]] virtual State at(double s) const = 0;
  [[nodiscard]] virtual Profile profile(double s) const = 0;
  [[nodiscard]] virtual Gives gives() const { return {}; }
  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view source() const = 0;
};

} // namespace stiction::formula
