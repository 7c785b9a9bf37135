// Writing whole files through POSIX calls, whose reasons of failure are known.
#include "record/file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace stiction::record {

namespace {

/// 0, or the errno of the first call that failed.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    ssize_t const written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

int write_file(std::filesystem::path const& path, std::string_view bytes, int how = O_TRUNC) {
  constexpr int mode = 0666; // less the user's umask
  int const descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | how | O_CLOEXEC, mode);
  if (descriptor < 0)
    return errno;
  int const failed = write_all(descriptor, bytes);
  int const closed = ::close(descriptor) == 0 ? 0 : errno; // network file systems report here
  return failed != 0 ? failed : closed;
}

core::RunError unusable_folder(std::filesystem::path const& folder, std::string const& reason) {
  return core::RunError(fmt::format("output folder '{}' is not writable: {}; choose another with --out",
                                    folder.string(), reason));
}

} // namespace

std::filesystem::path part_name(std::filesystem::path const& path) {
  return path.string() + ".part";
}

core::RunError unwritable(std::filesystem::path const& path, std::string const& reason) {
  return core::RunError(fmt::format(
      "cannot write '{}': {}; what was written before stays readable, make room or choose another "
      "folder with --out",
      path.string(), reason));
}

void replace_file(std::filesystem::path const& path, std::string_view bytes) {
  auto const part = part_name(path);
  int failed = write_file(part, bytes);
  if (failed == 0 && std::rename(part.c_str(), path.c_str()) != 0)
    failed = errno;
  if (failed == 0)
    return;
  ::unlink(part.c_str());
  throw unwritable(path, std::strerror(failed));
}

void append_file(std::filesystem::path const& path, std::string_view bytes) {
  if (int const failed = write_file(path, bytes, O_APPEND); failed != 0)
    throw unwritable(path, std::strerror(failed));
}

void prepare_output(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw unusable_folder(folder, error.message());
  auto const probe = folder / ".stiction-write-test";
  int const failed = write_file(probe, "x");
  ::unlink(probe.c_str());
  if (failed != 0)
    throw unusable_folder(folder, std::strerror(failed));
}

} // namespace stiction::record
