// What is said of a scene that cannot be built.
#pragma once
#include "core/error.hpp"
#include "scene/build/build.hpp"

namespace stiction::test {

/// One message a complaint; none of a sound scene.
inline std::vector<std::string> complaints(core::Input const& table) {
  std::vector<std::string> all;
  try {
    static_cast<void>(scene::build(table));
  } catch (core::InputError const& error) {
    for (auto const& complaint : error.complaints())
      all.push_back(complaint.message());
  }
  return all;
}

} // namespace stiction::test
