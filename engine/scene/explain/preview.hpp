// What is known of a run before its first step: the columns of its histories, its end, its warnings.
#pragma once
#include "scene/explain/explain.hpp"

namespace stiction::scene {

struct ColumnName {
  std::string name; ///< "group/name"
  int width = 1;
};
struct Preview {
  std::vector<ColumnName> columns;
  double end = 0; ///< s
  std::vector<Warning> warnings;
  std::string unfit_for_ranks; ///< why several ranks cannot share the case, or ""
};

/// Builds the scene. Throws InputError with every complaint about the table.
[[nodiscard]] Preview preview(core::Input const& scene);

/// Those that explain shows.
[[nodiscard]] std::vector<Warning> warnings_of(Scene const& scene, dynamics::State const& start);
/// Of a scene with a half space.
[[nodiscard]] std::vector<Warning> warnings_of(Scene const& scene);

} // namespace stiction::scene
