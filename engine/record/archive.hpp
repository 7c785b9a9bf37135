// Values as bytes and back: one description of a struct, by which it is both written and read.
#pragma once
#include <Eigen/Core>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "record/checkpoint_file.hpp"

namespace stiction::record {

/// Writes what it is called with behind each other, in the memory's own order of bytes. A struct has a member
/// `visit(archive)`, or a function `visit(archive, value)` beside it, which calls the archive with all that
/// it consists of.
class ByteWriter {
public:
  static constexpr bool reads = false;
  template<class... Values> void operator()(Values&... values);
  void raw(void const* data, std::size_t count) { bytes_.append(static_cast<char const*>(data), count); }
  [[nodiscard]] std::string const& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// Reads them again, into values of the same types. Throws Unfit where there are fewer bytes.
class ByteReader {
public:
  static constexpr bool reads = true;
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  template<class... Values> void operator()(Values&... values);
  void raw(void* data, std::size_t count) {
    if (count > bytes_.size())
      throw Unfit("it ends too soon");
    if (count > 0)
      std::memcpy(data, bytes_.data(), count);
    bytes_.remove_prefix(count);
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

private:
  std::string_view bytes_;
};

namespace archive {

template<class Archive, class T>
requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void handle(Archive& archive, T& value) {
  archive.raw(&value, sizeof value);
}

/// A count that cannot be that of so many bytes is refused before memory is asked for.
template<class Archive> std::size_t count(Archive& archive, std::size_t present) {
  archive(present);
  if constexpr (Archive::reads)
    if (present > archive.left())
      throw Unfit("it ends too soon");
  return present;
}

template<class Archive, class T, int Rows, int Columns, int Options, int MostRows, int MostColumns>
void handle(Archive& archive, Eigen::Matrix<T, Rows, Columns, Options, MostRows, MostColumns>& value) {
  auto rows = value.rows(), columns = value.cols();
  archive(rows, columns);
  if constexpr (Archive::reads) {
    bool const possible =
        rows >= 0 && columns >= 0 &&
        static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) <= archive.left();
    if (!possible || (Rows != Eigen::Dynamic && rows != Rows) ||
        (Columns != Eigen::Dynamic && columns != Columns))
      throw Unfit("a matrix in it has another size");
    value.resize(rows, columns);
  }
  archive.raw(value.data(), static_cast<std::size_t>(value.size()) * sizeof(T));
}

template<class Archive> void handle(Archive& archive, std::string& text) {
  text.resize(count(archive, text.size()));
  archive.raw(text.data(), text.size());
}

template<class Archive, class T> void handle(Archive& archive, std::vector<T>& values) {
  values.resize(count(archive, values.size()));
  for (auto& value : values)
    archive(value);
}

template<class Archive> void handle(Archive& archive, std::vector<bool>& values) {
  values.resize(count(archive, values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    char flag = values[i] ? 1 : 0;
    archive(flag);
    values[i] = flag != 0;
  }
}

template<class Archive, class T, std::size_t N> void handle(Archive& archive, std::array<T, N>& values) {
  for (auto& value : values)
    archive(value);
}

template<class Archive, class Key, class T> void handle(Archive& archive, std::map<Key, T>& values) {
  std::vector<Key> keys;
  keys.reserve(values.size());
  for (auto const& [key, value] : values)
    keys.push_back(key);
  archive(keys);
  if constexpr (Archive::reads)
    values.clear();
  for (auto const& key : keys)
    archive(values[key]);
}

template<class Archive, class T> void handle(Archive& archive, std::optional<T>& value) {
  bool there = value.has_value();
  archive(there);
  if constexpr (Archive::reads)
    there ? void(value.emplace()) : value.reset();
  if (there)
    archive(*value);
}

/// What it points to, of its own to whoever reads it.
template<class Archive, class T> void handle(Archive& archive, std::shared_ptr<T const>& value) {
  bool there = value != nullptr;
  archive(there);
  auto held = there && !Archive::reads ? *value : T{};
  if (there)
    archive(held);
  if constexpr (Archive::reads)
    value = there ? std::make_shared<T const>(std::move(held)) : nullptr;
}

template<class Archive, class T> void handle(Archive& archive, T& value) {
  if constexpr (requires { value.visit(archive); })
    value.visit(archive);
  else
    visit(archive, value);
}

} // namespace archive

template<class... Values> void ByteWriter::operator()(Values&... values) {
  (archive::handle(*this, values), ...);
}
template<class... Values> void ByteReader::operator()(Values&... values) {
  (archive::handle(*this, values), ...);
}

} // namespace stiction::record
