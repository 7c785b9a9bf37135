// Head, checksum and the way to the disk of a checkpoint.
#include "record/checkpoint_file.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <unistd.h>
#include <zlib.h>

#include "core/error.hpp"
#include "record/file.hpp"

namespace stiction::record {

namespace {

constexpr std::string_view magic = "stiction checkpoint ";
constexpr int head_layout = 1; ///< of head and bytes; raised by whatever changes either

/// Magic and layout as text, so that any version can tell them; then a line each: program, scene, size and
/// checksum of the bytes.
std::string head_of(CheckpointOwner const& owner, std::string_view bytes) {
  return fmt::format("{}{}\n{}\n{}\n{} {:08x}\n", magic, head_layout, owner.program, owner.scene,
                     bytes.size(), checksum(bytes));
}

/// Takes a line off the front; nothing if there is none.
std::optional<std::string> take_line(std::string_view& text) {
  auto const end = text.find('\n');
  if (end == std::string_view::npos)
    return {};
  std::string line(text.substr(0, end));
  text.remove_prefix(end + 1);
  return line;
}

/// Until what was written to it survives a power cut; 0, or errno.
int settle(std::filesystem::path const& path, int how) {
  int const descriptor = ::open(path.c_str(), how | O_CLOEXEC);
  if (descriptor < 0)
    return errno;
  int const failed = ::fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno; // EINVAL: it cannot
  ::close(descriptor);
  return failed;
}

constexpr char const* damaged = "is damaged";

FoundCheckpoint open_bytes(std::string_view text, CheckpointOwner const& owner) {
  auto const first = take_line(text);
  if (!first || !first->starts_with(magic))
    return {"", damaged};
  if (*first != fmt::format("{}{}", magic, head_layout))
    return {"", "was written by another version of Stiction"};
  auto const program = take_line(text), scene = take_line(text), measure = take_line(text);
  if (!measure)
    return {"", damaged};
  if (*measure != fmt::format("{} {:08x}", text.size(), checksum(text)))
    return {"", damaged};
  if (*program != owner.program)
    return {"", "was written by another build of the program"};
  if (*scene != owner.scene)
    return {"", "is of another scene"};
  return {std::string(text), ""};
}

} // namespace

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<Bytef const*>(bytes.data()), bytes.size()));
}

void write_checkpoint(std::filesystem::path const& path, CheckpointOwner const& owner,
                      std::string_view bytes) {
  auto const part = part_name(path);
  replace_file(part, head_of(owner, bytes) + std::string(bytes)); // which has a part of its own
  int failed = settle(part, O_RDONLY);
  if (failed == 0 && std::rename(part.c_str(), path.c_str()) != 0)
    failed = errno;
  if (failed != 0) {
    ::unlink(part.c_str());
    throw unwritable(path, std::strerror(failed));
  }
  static_cast<void>(settle(path.parent_path(), O_RDONLY | O_DIRECTORY));
}

std::optional<FoundCheckpoint> read_checkpoint(std::filesystem::path const& path,
                                               CheckpointOwner const& owner) {
  std::error_code error;
  if (!std::filesystem::exists(path, error) && !error)
    return {};
  std::ifstream file(path, std::ios::binary);
  std::string const text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad())
    return FoundCheckpoint{"", "cannot be read"};
  return open_bytes(text, owner);
}

} // namespace stiction::record
