// What this process has taken from the machine.
#pragma once

namespace stiction::scene {

/// Processor time of this process so far, s.
[[nodiscard]] double cpu_seconds();
/// Of this program, bytes; getrusage would count what the process held before it became this program.
[[nodiscard]] double peak_memory();

} // namespace stiction::scene
