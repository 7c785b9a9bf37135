// Everything a script can make, by category, each with its schema: the source of help and of constructors.
#pragma once
#include <string>
#include <vector>

#include "core/schema.hpp"

namespace stiction::scene {

/// E.g. name "material", kinds blatz_ko, neo_hookean, ...; scripts write material.blatz_ko{...}.
struct Category {
  std::string name;
  std::string meaning;
  std::vector<core::Schema> kinds;
};
[[nodiscard]] std::vector<Category> const& catalog();

/// In place of a category: a table of the script's own names that no constructor makes.
inline constexpr char const* plain_table = "table";

} // namespace stiction::scene
