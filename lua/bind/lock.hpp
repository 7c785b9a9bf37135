// Locks on output folders, held by this process and the children it starts, gone with the last of them.
#pragma once
#include <string>
#include <vector>

namespace stiction::bind {

/// Descriptors of the locks held now: a child inherits them, so that a killed parent's folder stays locked
/// until its cases have closed their files.
[[nodiscard]] std::vector<int> const& held_locks();

} // namespace stiction::bind
