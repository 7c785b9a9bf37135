// A VTK file being made: an XML head, then all arrays behind each other as zlib blocks ("appended raw").
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "record/fields.hpp"

namespace stiction::record {

struct ArrayHead {
  std::string_view type, name;
  int components = 1;
  std::string_view unit = "";
};

template<class Number> std::string bytes_of(std::vector<Number> const& numbers) {
  return {reinterpret_cast<char const*>(numbers.data()), numbers.size() * sizeof(Number)};
}
/// As Number.
template<class Number> std::string bytes_as(double const* values, std::size_t count) {
  return bytes_of(std::vector<Number>(values, values + count));
}

/// Collects the document's head and its appended data.
class Document {
public:
  /// kind: VTK's name of the data; of_grid, of_piece: attributes of these elements, with a space before each.
  Document(std::string kind, double time, std::string_view of_grid, std::string_view of_piece);
  void open(std::string_view element);
  void close(std::string_view element);
  void add(ArrayHead const& array, std::string const& raw);
  /// Values of `count` points or cells; another size is a core::Bug.
  void add(FieldArray const& array, std::size_t count);
  [[nodiscard]] std::string text() const;

private:
  std::string kind_, head_, data_;
};

} // namespace stiction::record
