// Replaces calls of the C library for the whole test executable; shared libraries resolve to these too.
#include "record/intercept.hpp"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace stiction::test {

Interception& interception() {
  static Interception state;
  return state;
}

namespace {

/// Not of files that live in memory.
bool lengthens(int descriptor, off_t end) {
  std::error_code error;
  auto const name = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), error);
  struct stat status {};
  return !name.string().starts_with("/memfd:") && fstat(descriptor, &status) == 0 && end > status.st_size;
}

/// Counts a call, dies if it is its turn, and says whether there is room for it.
bool admit(int descriptor, off_t end) {
  auto& state = interception();
  ++state.calls;
  if (state.calls == state.kill_at)
    kill(getpid(), SIGKILL);
  bool const full = state.full_from >= 0 && state.calls >= state.full_from;
  return !full || !lengthens(descriptor, end);
}

} // namespace

} // namespace stiction::test

extern "C" {

ssize_t pwrite(int descriptor, void const* data, size_t size, off_t offset) {
  if (stiction::test::admit(descriptor, offset + static_cast<off_t>(size)))
    return syscall(SYS_pwrite64, descriptor, data, size, offset);
  errno = ENOSPC;
  return -1;
}

int ftruncate(int descriptor, off_t size) noexcept {
  if (stiction::test::admit(descriptor, size))
    return static_cast<int>(syscall(SYS_ftruncate, descriptor, size));
  errno = ENOSPC;
  return -1;
}

int posix_fallocate(int descriptor, off_t offset, off_t size) {
  if (!stiction::test::admit(descriptor, offset + size))
    return ENOSPC;
  return syscall(SYS_fallocate, descriptor, 0, offset, size) == 0 ? 0 : errno;
}
}
