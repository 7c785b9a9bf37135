// Feeds every file of a folder to a target, without libFuzzer: a crash or an exception is a failure.
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "fuzz/targets.hpp"

namespace {

namespace fuzz = stiction::fuzz;

std::map<std::string, void (*)(std::string_view)> const targets{
    {"stl", fuzz::stl},         {"msh", fuzz::msh},         {"mesh_file", fuzz::mesh_file},
    {"heights", fuzz::heights}, {"problem", fuzz::problem}, {"series", fuzz::series},
    {"result", fuzz::result},   {"script", fuzz::script}};

/// How many files there were; the name of each is printed first, so that a crash tells which it was.
int replay(std::string const& target, std::filesystem::path const& folder) {
  int count = 0;
  for (auto const& entry : std::filesystem::directory_iterator(folder)) {
    fmt::print("{}\n", entry.path().string());
    std::fflush(stdout);
    std::ifstream file(entry.path(), std::ios::binary);
    std::string const bytes(std::istreambuf_iterator<char>(file), {});
    targets.at(target)(bytes);
    ++count;
  }
  return count;
}

} // namespace

int main(int count, char** words) {
  if (count != 3 || !targets.contains(words[1])) {
    fmt::print(stderr, "usage: stiction_seeds TARGET FOLDER\n");
    return 2;
  }
  int const files = replay(words[1], words[2]);
  fmt::print("{} seeds held\n", files);
  return files > 0 ? 0 : 1;
}
