// Looks a request up, or has the mesher answer it and files the answer.
#include "mesh/gmsh/mesh_cache.hpp"

#include <cstdlib>
#include <cstring>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <random>
#include <unistd.h>

#include "core/error.hpp"
#include "mesh/files/mesh_file.hpp"
#include "mesh/gmsh/mesher_process.hpp"

namespace stiction::mesh {

namespace fs = std::filesystem;

namespace {

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t sum) {
  for (char const byte : bytes)
    sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
  return sum;
}

bool writable(fs::path const& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  return !failed && access(folder.c_str(), W_OK | X_OK) == 0;
}

/// Nothing when there is no file, it is damaged, of another version, or answers another request.
std::optional<Mesh> recall(fs::path const& file, std::string const& request) {
  if (!fs::exists(file))
    return std::nullopt;
  try {
    auto found = read_mesh(file);
    if (found.request == request)
      return std::move(found.mesh);
  } catch (core::RunError const&) { // made anew below
  }
  return std::nullopt;
}

/// A file that is gone when its owner is.
struct Scratch {
  fs::path path;
  explicit Scratch(fs::path p) : path(std::move(p)) {}
  ~Scratch() {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Scratch(Scratch const&) = delete;
  Scratch& operator=(Scratch const&) = delete;
};

void refuse_unless_made(MesherOutcome const& outcome, std::string const& what) {
  if (outcome.signal != 0)
    throw core::InputError(fmt::format(
        "{}: the mesher crashed ({}); of a file, its cells may name nodes that "
        "are not there{}{}",
        what, strsignal(outcome.signal), outcome.message.empty() ? "" : "; gmsh says: ", outcome.message));
  if (outcome.exit_code != 0)
    throw core::InputError(fmt::format("{}: {}", what, outcome.message));
}

} // namespace

std::string content_hash(std::string_view bytes) {
  return fmt::format("{:016x}{:016x}", fnv1a(bytes, 14695981039346656037ULL),
                     fnv1a(bytes, 0x9e3779b97f4a7c15ULL));
}

fs::path cache_folder() {
  char const* cache = std::getenv("XDG_CACHE_HOME");
  char const* home = std::getenv("HOME");
  fs::path const base = cache != nullptr && *cache == '/' ? fs::path(cache)
                        : home != nullptr && *home == '/' ? fs::path(home) / ".cache"
                                                          : fs::path();
  if (!base.empty() && writable(base / "stiction" / "meshes"))
    return base / "stiction" / "meshes";
  fs::path const temporary = fs::temp_directory_path() / fmt::format("stiction-meshes-{}", getuid());
  if (!writable(temporary))
    throw core::RunError(fmt::format("no folder for meshes: {} is not writable", temporary.string()));
  return temporary;
}

Mesh mesh_for_request(std::string const& request, std::string const& what) {
  fs::path const folder = cache_folder();
  std::string const key = content_hash(request);
  fs::path const kept = folder / (key + ".h5");
  if (auto found = recall(kept, request))
    return std::move(*found);

  fs::path const mesher = find_mesher();
  if (mesher.empty())
    throw core::InputError(
        fmt::format("{}: needs the program stiction-mesher, which was not found; build with "
                    "libgmsh-dev installed or set STICTION_MESHER to its path",
                    what));
  // other machines may share the folder, and their processes the numbers
  auto const own = fmt::format("{}.{}.{:x}", key, getpid(), std::random_device()());
  Scratch const asked(folder / (own + ".json")), answer(folder / (own + ".tmp"));
  std::ofstream(asked.path) << request;
  refuse_unless_made(run_mesher(mesher, asked.path, answer.path), what);
  Mesh mesh = read_mesh(answer.path).mesh;
  std::error_code ignored; // a mesh that cannot be kept is still a mesh
  fs::rename(answer.path, kept, ignored);
  return mesh;
}

} // namespace stiction::mesh
