// Stands between HDF5 and the kernel: kills this process at a chosen call, or lets the disk be full.
#pragma once

namespace stiction::test {

/// Of the calls of this process that change a file by position or length (pwrite, ftruncate,
/// posix_fallocate). At call number `kill_at` the process dies by SIGKILL; from call `full_from` on there is
/// "no space left on device" for calls that would lengthen a file.
struct Interception {
  long calls = 0;
  long kill_at = -1;
  long full_from = -1;
};
Interception& interception();

} // namespace stiction::test
