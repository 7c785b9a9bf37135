// Running the figure program on a spec, and looking at the picture it made.
#pragma once
#include <array>
#include <filesystem>
#include <string>

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace harness {

inline std::filesystem::path const work = WORK;

struct Result {
  int code = -1;
  std::string messages;
};

[[nodiscard]] std::string content(std::filesystem::path const& file);
Result run(std::string const& arguments);

/// Draws a spec whose list of figures is given, into the folder `name` of `work`.
Result draw(std::string const& name, std::string const& figures, std::string const& options = "");

using Colour = std::array<int, 3>;

class Image {
public:
  explicit Image(std::filesystem::path const& file);
  [[nodiscard]] int width() const { return pixels_->GetDimensions()[0]; }
  [[nodiscard]] int height() const { return pixels_->GetDimensions()[1]; }
  /// Row 0 is the lowest.
  [[nodiscard]] Colour at(int x, int y) const;
  [[nodiscard]] std::size_t colours() const;
  /// How many pixels have a colour within a part of the picture given in fractions of it.
  [[nodiscard]] int count(Colour colour, std::array<double, 4> part = {0, 1, 0, 1}) const;
  [[nodiscard]] bool white_rim() const;
  static constexpr Colour white{255, 255, 255};

private:
  vtkSmartPointer<vtkImageData> pixels_;
};

} // namespace harness
