// A temporary folder that vanishes with its owner.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>

namespace stiction::test {

class Folder {
public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stiction-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] std::filesystem::path const& path() const { return path_; }
  std::filesystem::path operator/(std::string const& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

} // namespace stiction::test
