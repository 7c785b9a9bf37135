// What a script wrote, as a tree of plain values that knows where each table came from.
#pragma once
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "core/unit.hpp"

namespace stiction::core {

struct Input;
using List = std::vector<Input>;
using Table = std::map<std::string, Input, std::less<>>; // sorted: the order never depends on hashing

/// One value of a script. A table made by a constructor carries its tag, e.g. "material.blatz_ko".
struct Input {
  std::variant<std::monostate, bool, Quantity, std::string, List, Table> value;
  std::string place; ///< "study.lua:12", where the enclosing constructor was called
  std::string tag;   ///< "" for a plain table

  [[nodiscard]] Table const* table() const { return std::get_if<Table>(&value); }
  [[nodiscard]] List const* list() const { return std::get_if<List>(&value); }
  [[nodiscard]] std::string const* text() const { return std::get_if<std::string>(&value); }
  [[nodiscard]] Quantity const* quantity() const { return std::get_if<Quantity>(&value); }
  [[nodiscard]] bool const* flag() const { return std::get_if<bool>(&value); }
};

/// "a number", "a table", ... for messages.
[[nodiscard]] char const* kind_of(Input const& input);

} // namespace stiction::core
