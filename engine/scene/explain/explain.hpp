// What a scene models, what it will cost and which numbers decide it: known before a step is run.
#pragma once
#include <limits>

#include "scene/build/build.hpp"

namespace stiction::scene {

/// A name with words, and, where it is a number, its value in SI and what it means.
struct Line {
  std::string name;
  std::string words; ///< for people: "0.25 mm"
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string unit; ///< of `value`; "1" is a pure number, "B" are bytes
  std::string meaning;
};
struct Section {
  std::string title;
  std::vector<Line> lines;
};
/// What will go wrong or cost too much, and the change of the script that mends it.
struct Warning {
  std::string text;
  std::string change;
};
struct Explanation {
  std::vector<Section> sections;
  std::vector<Warning> warnings;
};

/// Takes no step, and factors nothing that is not small.
[[nodiscard]] Explanation explain(Scene const& scene);
/// Throws InputError with every complaint about the table.
[[nodiscard]] Explanation explain(core::Input const& input);

} // namespace stiction::scene
