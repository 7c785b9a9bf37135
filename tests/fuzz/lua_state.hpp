// A Lua state of ours with limits on time and memory, so that a loop without end is no finding.
#pragma once
#include <string>
#include <string_view>

namespace stiction::fuzz {

/// Runs `chunk`, text of ours that may require the library, with `words` as its arguments, within the limits.
/// Errors that tell the user something are fine. Throws core::Bug for those that do not: of kind "bug" or
/// "run", or raised by Lua inside our own library.
void run_lua(char const* chunk, std::string_view word);

} // namespace stiction::fuzz
