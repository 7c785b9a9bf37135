// One description per parameter struct, from which reader, messages, help, manifest and attributes are made.
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stiction::core {

/// Admissible interval of a number, ends included unless open.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  [[nodiscard]] bool contains(double value) const;              ///< false for NaN
  [[nodiscard]] std::string words(std::string_view unit) const; ///< "> 0 Pa", "in [0, 0.5) 1"
};
inline constexpr Range any_number{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
inline constexpr Range non_negative{0, std::numeric_limits<double>::infinity(), false, false};
inline constexpr Range unit_interval{0, 1, false, false};

using Numbers = std::vector<double>;
using Value = std::variant<bool, double, std::string, Numbers>;

enum class Need { required, optional };

/// One named parameter of a struct, type-erased: `set` and `get` act on a pointer to that struct.
struct Parameter {
  /// `nested` is another table of the script, made by a constructor of category `unit`; its reader fills it.
  /// `file` is a text that names one, from the study's folder on.
  enum class Kind { flag, number, integer, choice, text, file, numbers, nested };
  std::string name;
  Kind kind = Kind::number;
  std::string unit; ///< "" or "1" for a pure number
  Range range;
  Need need = Need::required;
  std::string meaning;
  std::vector<std::string> choices;
  std::function<void(void*, Value const&)> set;
  std::function<Value(void const*)> get;
  std::function<bool(void const*)> acts = {}; ///< does it do anything beside the others? none: always
  std::string where = {};                     ///< the same in words: "mix = \"linear\""
};

/// The description of one struct: its script name, what it is, where it comes from, its parameters.
struct Schema {
  std::string name; ///< script name, e.g. "blatz_ko"
  std::string meaning;
  std::string source; ///< equation or reference, may be empty
  std::vector<Parameter> parameters;
  std::function<Value(std::size_t)> fallback; ///< default of parameter i, from a default-made struct
  [[nodiscard]] Parameter const* find(std::string_view parameter) const;
  /// Parameters that are not as by default and do nothing beside the others.
  [[nodiscard]] std::vector<Parameter const*> idle(void const* object) const;
};

/// Consecutive values of an enumeration from `first` on, by their names.
template<class E> struct Choices {
  E first;
  std::vector<std::string> names;
};

/// Builds the Schema of T: `Describe<T>{"name", "meaning", "source"}.number("density", &T::rho, ...)...`.
template<class T> class Describe {
public:
  Describe(std::string name, std::string meaning, std::string source = "") {
    schema_.name = std::move(name);
    schema_.meaning = std::move(meaning);
    schema_.source = std::move(source);
  }
  // NOLINTNEXTLINE(readability-function-size): a number has that many traits
  Describe& number(std::string name, double T::*member, std::string unit, Range range, Need need,
                   std::string meaning) {
    return add({std::move(name),
                Parameter::Kind::number,
                std::move(unit),
                range,
                need,
                std::move(meaning),
                {},
                [member](void* p, Value const& v) { static_cast<T*>(p)->*member = std::get<double>(v); },
                [member](void const* p) { return Value{static_cast<T const*>(p)->*member}; }});
  }
  Describe& integer(std::string name, int T::*member, Range range, Need need, std::string meaning) {
    return add(
        {std::move(name),
         Parameter::Kind::integer,
         "1",
         range,
         need,
         std::move(meaning),
         {},
         [member](void* p, Value const& v) {
           static_cast<T*>(p)->*member = static_cast<int>(std::get<double>(v));
         },
         [member](void const* p) { return Value{static_cast<double>(static_cast<T const*>(p)->*member)}; }});
  }
  Describe& flag(std::string name, bool T::*member, std::string meaning) {
    return add({std::move(name),
                Parameter::Kind::flag,
                "",
                any_number,
                Need::optional,
                std::move(meaning),
                {},
                [member](void* p, Value const& v) { static_cast<T*>(p)->*member = std::get<bool>(v); },
                [member](void const* p) { return Value{static_cast<T const*>(p)->*member}; }});
  }
  Describe& text(std::string name, std::string T::*member, Need need, std::string meaning,
                 Parameter::Kind kind = Parameter::Kind::text) {
    return add({std::move(name),
                kind,
                "",
                any_number,
                need,
                std::move(meaning),
                {},
                [member](void* p, Value const& v) { static_cast<T*>(p)->*member = std::get<std::string>(v); },
                [member](void const* p) { return Value{static_cast<T const*>(p)->*member}; }});
  }
  Describe& file(std::string name, std::string T::*member, Need need, std::string meaning) {
    return text(std::move(name), member, need, std::move(meaning), Parameter::Kind::file);
  }
  Describe& numbers(std::string name, Numbers T::*member, std::string unit, Need need, std::string meaning) {
    return add({std::move(name),
                Parameter::Kind::numbers,
                std::move(unit),
                any_number,
                need,
                std::move(meaning),
                {},
                [member](void* p, Value const& v) { static_cast<T*>(p)->*member = std::get<Numbers>(v); },
                [member](void const* p) { return Value{static_cast<T const*>(p)->*member}; }});
  }
  /// The parameter before does something only `where` ... `acts`.
  Describe& only(std::string where, bool (*acts)(T const&)) {
    auto& last = schema_.parameters.back();
    last.where = std::move(where);
    last.acts = [acts](void const* p) { return acts(*static_cast<T const*>(p)); };
    return *this;
  }
  /// A table that is read by its own schema; described here for help and for the check of keys.
  Describe& nested(std::string name, std::string category, Need need, std::string meaning) {
    return add({std::move(name),
                Parameter::Kind::nested,
                std::move(category),
                any_number,
                need,
                std::move(meaning),
                {},
                [](void*, Value const&) {},
                [](void const*) { return Value{std::string()}; }});
  }
  /// An enumeration of which some consecutive values may be chosen.
  template<class E>
  Describe& choice(std::string name, E T::*member, Choices<E> choices, Need need, std::string meaning) {
    auto const first = static_cast<std::size_t>(choices.first);
    auto set = [member, first, names = choices.names](void* p, Value const& v) {
      for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == std::get<std::string>(v))
          static_cast<T*>(p)->*member = static_cast<E>(first + i);
    };
    auto get = [member, first, names = choices.names](void const* p) {
      return Value{names.at(static_cast<std::size_t>(static_cast<T const*>(p)->*member) - first)};
    };
    return add({std::move(name), Parameter::Kind::choice, "", any_number, need, std::move(meaning),
                choices.names, set, get});
  }
  /// An enumeration whose values 0, 1, ... are called names[0], names[1], ...
  template<class E>
  Describe& choice(std::string name, E T::*member, std::vector<std::string> names, Need need,
                   std::string meaning) {
    return choice(std::move(name), member, Choices<E>{E{}, std::move(names)}, need, std::move(meaning));
  }
  [[nodiscard]] Schema build() {
    auto const parameters = schema_.parameters;
    schema_.fallback = [parameters](std::size_t i) {
      T const made{};
      return parameters.at(i).get(&made);
    };
    return schema_;
  }

private:
  Describe& add(Parameter parameter) {
    schema_.parameters.push_back(std::move(parameter));
    return *this;
  }
  Schema schema_;
};

/// The whole number that `value` is but for rounding, as quotients of quantities are; nothing otherwise.
[[nodiscard]] std::optional<double> whole_number(double value);

/// "12.5", "true", "\"contact\"", "{1, 2}" for messages and help.
[[nodiscard]] std::string to_string(Value const& value);

/// The word of `known` nearest to `word` by edit distance, or "" when none is near.
[[nodiscard]] std::string nearest(std::string_view word, std::vector<std::string> const& known);

} // namespace stiction::core
