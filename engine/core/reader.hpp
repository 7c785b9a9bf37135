// Reads Input tables into structs by their Schema, collecting every complaint instead of stopping at the
// first.
#pragma once
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.hpp"
#include "core/input.hpp"
#include "core/schema.hpp"

namespace stiction::core {

/// Reads one Input table key by key; `finish` complains about keys nobody asked for.
class Reader {
public:
  Reader(Input const& input, std::string path, Complaints& complaints);

  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] std::string const& path() const { return path_; }
  [[nodiscard]] std::string const& tag() const { return input_->tag; }
  [[nodiscard]] Input const& input() const { return *input_; }

  /// The value at key, or an empty Input with a complaint when it is missing and required.
  Input const& at(std::string_view key, Need need = Need::required);
  Reader child(std::string_view key, Need need = Need::required);
  /// Elements of a list at key, each with path "key[i]".
  std::vector<Reader> children(std::string_view key, Need need = Need::required);

  double number(std::string_view key, std::string_view unit, Range range);
  double number_or(std::string_view key, std::string_view unit, Range range, double fallback);
  std::string text(std::string_view key, Need need = Need::required);
  bool flag_or(std::string_view key, bool fallback);
  Numbers numbers(std::string_view key, std::string_view unit, Need need = Need::required);

  /// Fills `target` from the keys that `schema` names.
  void fill(void* target, Schema const& schema);
  /// Fills a T by its schema; a T with nested tables reads them itself, in `void read_nested(Reader&)`, and
  /// one whose parameters must fit together says in `Complaints check() const` what does not (paths below its
  /// own).
  template<class T> T record() {
    T target{};
    auto const before = complaints_->size();
    fill(&target, T::schema());
    if constexpr (requires { target.check(); })
      if (complaints_->size() == before)
        complain_all(target.check());
    if constexpr (requires { target.read_nested(*this); })
      target.read_nested(*this);
    finish();
    return target;
  }
  /// Picks the alternative whose schema name is the last word of the tag ("material.blatz_ko").
  template<class Variant> Variant alternative() { return alternative_of(std::type_identity<Variant>{}); }

  void complain(std::string text) { complain_at("", std::move(text)); }
  void complain_at(std::string_view key, std::string text);
  void complain_all(Complaints const& complaints); ///< each at the key that is its path
  void finish();                                   ///< unknown keys, with what was perhaps meant

private:
  template<class... T> std::variant<T...> alternative_of(std::type_identity<std::variant<T...>>) {
    std::string const name = input_->tag.substr(input_->tag.rfind('.') + 1);
    std::variant<T...> result;
    bool found = false;
    ((T::schema().name == name ? (found = true, result = record<T>(), 0) : 0), ...);
    if (!found)
      complain_unknown_kind(name, {T::schema().name...});
    return result;
  }
  void complain_unknown_kind(std::string const& name, std::vector<std::string> const& known);
  bool parse(Parameter const& parameter, Input const& given, Value& value);
  bool parse_number(Parameter const& parameter, Input const& given, Value& value);
  bool parse_choice(Parameter const& parameter, Input const& given, Value& value);
  bool check_number(std::string_view key, Input const& given, std::string_view unit, Range range,
                    double& value);
  [[nodiscard]] std::string path_of(std::string_view key) const;

  Input const* input_;
  std::string path_;
  Complaints* complaints_;
  std::set<std::string, std::less<>> asked_;
};

} // namespace stiction::core
