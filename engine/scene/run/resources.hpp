// What this process has taken from the machine.
#pragma once

namespace stiction::scene {

/// Processor time of this process so far, s.
[[nodiscard]] double cpu_seconds();
/// Of this program, bytes; getrusage would count what the process held before it became this program.
[[nodiscard]] double peak_memory();
/// Blocks up to this size, bytes, come and go at every step: their pages stay with the process, or the system
/// would clear them anew each time.
void keep_pages(int largest);

} // namespace stiction::scene
