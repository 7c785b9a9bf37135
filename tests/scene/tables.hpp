// Tables as a script would hand them over, written in C++.
#pragma once
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input.hpp"

namespace stiction::test {

using core::Input;

inline Input value(double number, std::string_view unit = "1") {
  auto quantity = core::parse_unit(unit);
  if (!quantity)
    throw std::logic_error("unknown unit " + std::string(unit));
  quantity->value *= number;
  return {*quantity, "", ""};
}
inline Input values(std::vector<double> const& numbers, std::string_view unit = "1") {
  core::List list;
  for (double const number : numbers)
    list.push_back(value(number, unit));
  return {std::move(list), "", ""};
}
inline Input text(std::string word) {
  return {std::move(word), "", ""};
}
inline Input flag(bool on) {
  return {on, "", ""};
}
inline Input list(core::List elements) {
  return {std::move(elements), "", ""};
}
/// What the constructor `tag` makes of these entries, "study.lua:7" being its place.
inline Input make(std::string tag, core::Table entries = {}) {
  return {std::move(entries), "study.lua:7", std::move(tag)};
}

/// The entry at "bodies.foot.density", made if missing; "motions[2].x" counts list elements from one.
inline Input& at(Input& root, std::string_view path) {
  Input* here = &root;
  while (!path.empty()) {
    auto const end = path.find('.');
    std::string_view key = path.substr(0, end);
    path = end == std::string_view::npos ? std::string_view{} : path.substr(end + 1);
    std::size_t element = 0;
    if (auto const bracket = key.find('['); bracket != std::string_view::npos) {
      element = std::stoul(std::string(key.substr(bracket + 1)));
      key = key.substr(0, bracket);
    }
    if (here->table() == nullptr)
      here->value = core::Table{};
    here = &std::get<core::Table>(here->value)[std::string(key)];
    if (element > 0)
      here = &std::get<core::List>(here->value).at(element - 1);
  }
  return *here;
}
/// Takes the entry away.
inline void remove(Input& root, std::string_view path) {
  auto const dot = path.rfind('.');
  Input& owner = dot == std::string_view::npos ? root : at(root, path.substr(0, dot));
  std::get<core::Table>(owner.value).erase(std::string(path.substr(dot + 1)));
}

} // namespace stiction::test
