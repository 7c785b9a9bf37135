// Values along times, as scripts give them.
#pragma once
#include "core/reader.hpp"

namespace stiction::scene {

/// Complains unless both lists are of one length, the times ascend, and a path that begins after the start of
/// the run begins with `rest`.
void check_path(core::Reader& reader, core::Numbers const& times, core::Numbers const& values,
                char const* key, double rest = 0);

/// The same of a part's displacements or forces x, y, z.
template<class Part> void check_paths(core::Reader& reader, Part const& part) {
  check_path(reader, part.times, part.x, "x");
  check_path(reader, part.times, part.y, "y");
  check_path(reader, part.times, part.z, "z");
}

} // namespace stiction::scene
