// Files and folders for the Lua library: read, write whole, make, list, hash.
#include "bind/engine.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include "bind/push.hpp"
#include "bind/wrap.hpp"

namespace stiction::bind {

namespace {

namespace fs = std::filesystem;

/// Pushes nil and the reason, the way Lua reports what may well fail.
int refuse(lua_State* lua, std::string const& reason) {
  lua_pushnil(lua);
  push(lua, reason);
  return 2;
}

/// read_file(path) -> text, or nil and the reason
int read_file(lua_State* lua) {
  auto const path = text_at(lua, 1);
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path))
    return refuse(lua, fmt::format("cannot read {}", path));
  std::string text;
  for (std::array<char, 1 << 16> block; file.read(block.data(), block.size()) || file.gcount() > 0;)
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  push(lua, text);
  return 1;
}

/// first_line(path) -> the file's first line without its end, nil if there is no file to read
int first_line(lua_State* lua) {
  std::ifstream file(text_at(lua, 1), std::ios::binary);
  std::string line;
  if (!std::getline(file, line))
    return 0;
  push(lua, line);
  return 1;
}

/// write_file(path, text): the file is replaced as a whole or not at all. Fails with kind "run".
int write_file(lua_State* lua) {
  auto const path = text_at(lua, 1);
  auto const text = text_at(lua, 2);
  auto const draft = fmt::format("{}.{}.part", path, getpid());
  std::ofstream file(draft, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  std::error_code failed(file ? 0 : errno, std::generic_category());
  if (file)
    fs::rename(draft, path, failed);
  if (!file || failed) {
    std::error_code ignored;
    fs::remove(draft, ignored);
    throw core::RunError(fmt::format("cannot write {}: {}; make room, or choose another folder with --out",
                                     path, failed ? failed.message() : "is the folder writable?"));
  }
  return 0;
}

/// make_folder(path) -> true, or nil and the reason; the folder is tried by writing into it
int make_folder(lua_State* lua) {
  auto const path = text_at(lua, 1);
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed)
    return refuse(lua, fmt::format("cannot make the folder {}: {}", path, failed.message()));
  auto const trial = fs::path(path) / fmt::format(".trial.{}", getpid());
  if (!std::ofstream(trial))
    return refuse(lua, fmt::format("cannot write into the folder {}", path));
  fs::remove(trial, failed);
  push(lua, true);
  return 1;
}

/// kind_of_path(path) -> "file", "folder" or nil
int kind_of_path(lua_State* lua) {
  std::error_code failed;
  auto const status = fs::status(text_at(lua, 1), failed);
  if (!fs::exists(status))
    return 0;
  push(lua, fs::is_directory(status) ? "folder" : "file");
  return 1;
}

/// file_size(path) -> bytes, nil if there is no such file
int file_size(lua_State* lua) {
  std::error_code failed;
  auto const size = fs::file_size(text_at(lua, 1), failed);
  if (failed)
    return 0;
  push(lua, static_cast<long>(size));
  return 1;
}

/// modified(path) -> seconds, by the clock of its file system, when the file was last written; nil if there
/// is none
int modified(lua_State* lua) {
  struct stat status {};
  if (stat(text_at(lua, 1).c_str(), &status) != 0)
    return 0;
  push(lua, static_cast<double>(status.st_mtim.tv_sec) + 1e-9 * static_cast<double>(status.st_mtim.tv_nsec));
  return 1;
}

/// link_target(path) -> what a symbolic link says, nil if it is none
int link_target(lua_State* lua) {
  std::error_code failed;
  auto const target = fs::read_symlink(text_at(lua, 1), failed);
  if (failed)
    return 0;
  push(lua, target.string());
  return 1;
}

/// absolute(path) -> the path without links, "." and ".."
int absolute(lua_State* lua) {
  push(lua, fs::weakly_canonical(fs::absolute(text_at(lua, 1))).string());
  return 1;
}

/// relative(path, folder) -> the path as it stands from the folder on; both absolute
int relative(lua_State* lua) {
  push(lua, fs::path(text_at(lua, 1)).lexically_relative(text_at(lua, 2)).string());
  return 1;
}

/// rename(from, to): a file or folder; `to` must not be a folder that holds anything
int rename(lua_State* lua) {
  std::error_code failed;
  fs::rename(text_at(lua, 1), text_at(lua, 2), failed);
  if (failed)
    throw core::RunError(
        fmt::format("cannot rename {} to {}: {}", text_at(lua, 1), text_at(lua, 2), failed.message()));
  return 0;
}

/// link(from, to) -> true, or nil where `to` is there already: of several that try, one has it
int link_file(lua_State* lua) {
  std::error_code failed;
  fs::create_hard_link(text_at(lua, 1), text_at(lua, 2), failed);
  if (failed && failed != std::errc::file_exists)
    throw core::RunError(
        fmt::format("cannot link {} to {}: {}", text_at(lua, 1), text_at(lua, 2), failed.message()));
  if (failed)
    return 0;
  push(lua, true);
  return 1;
}

/// list(path, deep) -> sorted paths of the files (deep: in all subfolders; else: files and folders) below
/// path
int list(lua_State* lua) {
  auto const path = text_at(lua, 1);
  std::vector<std::string> names;
  std::error_code failed;
  if (lua_toboolean(lua, 2) != 0) {
    for (auto const& entry : fs::recursive_directory_iterator(path, failed))
      if (entry.is_regular_file())
        names.push_back(entry.path().string());
  } else {
    for (auto const& entry : fs::directory_iterator(path, failed))
      names.push_back(entry.path().string());
  }
  std::sort(names.begin(), names.end());
  push(lua, names);
  return 1;
}

/// remove(path): a file, or a folder with all it holds
int remove(lua_State* lua) {
  std::error_code failed;
  fs::remove_all(text_at(lua, 1), failed);
  if (failed)
    throw core::RunError(fmt::format("cannot remove {}: {}", text_at(lua, 1), failed.message()));
  return 0;
}

/// hash(text) -> 16 hexadecimal digits (FNV-1a, 64 bits): tells contents apart, keeps no secrets
int hash(lua_State* lua) {
  std::uint64_t sum = 14695981039346656037U;
  for (char const c : text_at(lua, 1))
    sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211U;
  push(lua, fmt::format("{:016x}", sum));
  return 1;
}

/// program() -> path of this executable, also where another one has been installed in its place meanwhile
int program(lua_State* lua) {
  auto const path = fs::read_symlink("/proc/self/exe");
  std::error_code missing;
  push(lua, fs::exists(path, missing) ? path.string() : "/proc/self/exe");
  return 1;
}

/// The build id among these notes, as hexadecimal digits; "" if there is none.
std::string id_among(unsigned char const* at, unsigned char const* end) {
  auto const padded = [](ElfW(Word) size) { return (size + 3U) & ~3U; };
  while (at < end) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    auto const* const words = at + sizeof note + padded(note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4)
      return fmt::format("{:02x}", fmt::join(words, words + note.n_descsz, ""));
    at = words + padded(note.n_descsz);
  }
  return "";
}

/// What the linker noted of all that it wrote.
std::string build_id(dl_phdr_info const& loaded) {
  std::string id;
  for (int k = 0; k < loaded.dlpi_phnum && id.empty(); ++k) {
    auto const& part = loaded.dlpi_phdr[k];
    auto const* const at = // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader tells addresses as numbers
        reinterpret_cast<unsigned char const*>(loaded.dlpi_addr + part.p_vaddr);
    if (part.p_type == PT_NOTE)
      id = id_among(at, at + part.p_memsz);
  }
  return id;
}

/// build_id() -> text that no other program has, as the linker wrote it; nil if it wrote none
int own_build_id(lua_State* lua) {
  std::string id;
  auto const take = [](dl_phdr_info* loaded, std::size_t, void* text) {
    *static_cast<std::string*>(text) = build_id(*loaded);
    return 1; // the program itself comes first
  };
  dl_iterate_phdr(take, &id);
  if (id.empty())
    return 0;
  push(lua, id);
  return 1;
}

/// program_folder() -> the folder that this executable was started from
int program_folder(lua_State* lua) {
  push(lua, fs::read_symlink("/proc/self/exe").parent_path().string());
  return 1;
}

} // namespace

void add_file_functions(lua_State* lua) {
  add<read_file>(lua, "read_file");
  add<first_line>(lua, "first_line");
  add<write_file>(lua, "write_file");
  add<make_folder>(lua, "make_folder");
  add<kind_of_path>(lua, "kind_of_path");
  add<file_size>(lua, "file_size");
  add<modified>(lua, "modified");
  add<link_target>(lua, "link_target");
  add<absolute>(lua, "absolute");
  add<relative>(lua, "relative");
  add<rename>(lua, "rename");
  add<link_file>(lua, "link");
  add<list>(lua, "list");
  add<remove>(lua, "remove");
  add<hash>(lua, "hash");
  add<program>(lua, "program");
  add<own_build_id>(lua, "build_id");
  add<program_folder>(lua, "program_folder");
}

} // namespace stiction::bind
