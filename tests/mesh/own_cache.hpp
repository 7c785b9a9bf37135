// A cache of meshes of one test's own, and whether there is a mesher to fill it.
#pragma once
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <optional>

#include "helpers.hpp"
#include "mesh/gmsh/mesher_process.hpp"

namespace stiction::mesh::test {

/// Sends the cache to a folder of this test.
class OwnCache {
public:
  OwnCache() { set(folder_.path().string()); }
  ~OwnCache() { restore(); }
  OwnCache(OwnCache const&) = delete;
  OwnCache& operator=(OwnCache const&) = delete;
  /// Writes a file into the folder; returns its path.
  [[nodiscard]] std::string write(std::string const& name, std::string const& text) const {
    std::string const path = folder_ / name;
    std::ofstream(path) << text;
    return path;
  }
  [[nodiscard]] std::string operator/(std::string const& name) const { return folder_ / name; }

private:
  void set(std::string const& value) {
    if (char const* before = std::getenv("XDG_CACHE_HOME"))
      before_ = before;
    setenv("XDG_CACHE_HOME", value.c_str(), 1);
  }
  void restore() {
    if (before_)
      setenv("XDG_CACHE_HOME", before_->c_str(), 1);
    else
      unsetenv("XDG_CACHE_HOME");
  }
  Folder folder_;
  std::optional<std::string> before_;
};

inline bool no_mesher() {
  if (!find_mesher().empty())
    return false;
  MESSAGE("the mesher was not built: nothing tested");
  return true;
}

} // namespace stiction::mesh::test
