// A file for readers that want a path, in memory where the system has such a folder.
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

namespace stiction::fuzz {

/// One folder a process, gone at its end.
inline std::filesystem::path const& scratch_folder() {
  struct Folder {
    std::filesystem::path path;
    Folder() {
      bool const memory = std::filesystem::is_directory("/dev/shm");
      path = (memory ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path()) /
             ("stiction-fuzz-" + std::to_string(getpid()));
      std::filesystem::create_directories(path);
    }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static Folder const folder;
  return folder.path;
}

/// Writes the bytes there; the file's path.
inline std::string scratch_file(std::string const& name, std::string_view bytes) {
  auto const path = scratch_folder() / name;
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path.string();
}

} // namespace stiction::fuzz
