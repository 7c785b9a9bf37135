// Which build of the program this is; the values are baked in by build_identity.cmake at every build.
#pragma once
#include <string_view>

namespace stiction::core {

struct BuildIdentity {
  std::string_view version; ///< of the project, "0.2.0"
  std::string_view commit; ///< 12 digits, "-dirty" behind them when files were changed; "unknown" without git
  std::string_view compiler;   ///< "GNU 12.2.0"
  std::string_view flags;      ///< what the compiler was told beyond includes and definitions
  std::string_view build_type; ///< "Release"
};
[[nodiscard]] BuildIdentity const& build_identity();

} // namespace stiction::core
