// The program is run as a user would: by its command line.
#include "harness.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/wait.h>

#include <vtkNew.h>
#include <vtkPNGReader.h>

#include "samples.hpp"

namespace harness {

namespace fs = std::filesystem;

std::string content(fs::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

Result run(std::string const& arguments) {
  auto const log = work / "log.txt";
  fs::create_directories(work);
  int const status = std::system(fmt::format("{} {} > {} 2>&1", FIGURES, arguments, log.string()).c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(log)};
}

Result draw(std::string const& name, std::string const& figures, std::string const& options) {
  auto const spec = work / (name + ".json");
  samples::write_text(spec, "{\"figures\":[" + figures + "]}");
  return run(fmt::format("{} --out {} {}", spec.string(), (work / name).string(), options));
}

Image::Image(fs::path const& file) {
  REQUIRE(fs::exists(file));
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  pixels_ = reader->GetOutput();
}

Colour Image::at(int x, int y) const {
  auto const* pixel = static_cast<unsigned char const*>(pixels_->GetScalarPointer(x, y, 0));
  return {pixel[0], pixel[1], pixel[2]};
}

std::size_t Image::colours() const {
  std::set<Colour> seen;
  for (int y = 0; y < height(); ++y)
    for (int x = 0; x < width(); ++x)
      seen.insert(at(x, y));
  return seen.size();
}

int Image::count(Colour colour, std::array<double, 4> part) const {
  int found = 0;
  for (int y = static_cast<int>(part[2] * height()); y < static_cast<int>(part[3] * height()); ++y)
    for (int x = static_cast<int>(part[0] * width()); x < static_cast<int>(part[1] * width()); ++x)
      found += at(x, y) == colour ? 1 : 0;
  return found;
}

bool Image::white_rim() const {
  for (int x = 0; x < width(); ++x)
    if (at(x, 0) != white || at(x, height() - 1) != white)
      return false;
  for (int y = 0; y < height(); ++y)
    if (at(0, y) != white || at(width() - 1, y) != white)
      return false;
  return true;
}

} // namespace harness
