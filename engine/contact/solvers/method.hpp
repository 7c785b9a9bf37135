// What gave the answer of a contact problem.
#pragma once
#include <array>
#include <string>
#include <string_view>

namespace stiction::contact {

/// In about the order in which the newton solver tries them; none: nothing did.
enum class Method {
  none,
  sweeps,       ///< Gauss-Seidel with Anderson's mixing
  newton,       ///< also with plain sweeps between its steps
  proximal,     ///< with more compliance, less and less of it
  uphill,       ///< Newton from other starts, on two maps, also where nothing descends
  descent,      ///< of the potential, in displacements
  minimisation, ///< of the potential, in generalised displacements
  damping,      ///< bodies in a viscous medium, less and less of it
  gauss_seidel, ///< point after point
  uzawa,
  pivoting,   ///< Lemke's method
  enumeration ///< every status of every point
};

inline constexpr std::array<std::string_view, 12> method_names = {
    "none",         "sweeps",  "newton",       "proximal", "uphill",   "descent",
    "minimisation", "damping", "gauss_seidel", "uzawa",    "pivoting", "enumeration"};

[[nodiscard]] constexpr std::string_view name_of(Method method) {
  return method_names[static_cast<std::size_t>(method)];
}

/// How many problems each method has answered.
using Methods = std::array<long, method_names.size()>;

/// "sweeps 4 newton 1"; "" where there were no problems.
[[nodiscard]] std::string words(Methods const& counts);

} // namespace stiction::contact
