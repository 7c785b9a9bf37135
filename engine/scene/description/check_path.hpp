// Values along times, as scripts give them.
#pragma once
#include "core/reader.hpp"

namespace stiction::scene {

/// Complains unless both lists are of one length and the times ascend.
void check_path(core::Reader& reader, core::Numbers const& times, core::Numbers const& values,
                char const* key);

} // namespace stiction::scene
