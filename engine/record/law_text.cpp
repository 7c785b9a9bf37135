// Laws to JSON and back by their schemas, so that a new law needs nothing here.
#include "record/law_text.hpp"

#include <fmt/format.h>

#include "record/manifest.hpp"

namespace stiction::record {

namespace {

using nlohmann::json;

template<class Laws> json to_list(Laws const& laws) {
  auto list = json::array();
  for (auto const& law : laws)
    std::visit(
        [&](auto const& kind) {
          json entry{{"kind", kind.schema().name}};
          for (auto const& parameter : kind.schema().parameters)
            entry[parameter.name] = to_json(parameter.get(&kind));
          list.push_back(std::move(entry));
        },
        law);
  return list;
}

/// False where the value is not of the parameter's kind or out of its range.
bool set(core::Parameter const& parameter, json const& value, void* law) {
  if (parameter.kind == core::Parameter::Kind::choice) {
    if (!value.is_string() || std::ranges::count(parameter.choices, value.get<std::string>()) == 0)
      return false;
    parameter.set(law, value.get<std::string>());
    return true;
  }
  if (parameter.kind != core::Parameter::Kind::number || !value.is_number() ||
      !parameter.range.contains(value.get<double>()))
    return false;
  parameter.set(law, value.get<double>());
  return true;
}

/// Fills `law` if it is of the entry's kind; "" or what is wrong.
template<class T, class Laws> bool read_kind(json const& entry, Laws& laws, std::string& why) {
  if (!entry.is_object() || !entry.contains("kind") || entry["kind"] != T::schema().name)
    return false;
  T law;
  auto const& schema = T::schema();
  for (auto const& [key, value] : entry.items())
    if (key != "kind" && schema.find(key) == nullptr)
      why = fmt::format("law {} has no {}", schema.name, key);
  for (auto const& parameter : schema.parameters)
    if (entry.contains(parameter.name)) {
      if (!set(parameter, entry[parameter.name], &law))
        why = fmt::format("{} of law {} is not admissible", parameter.name, schema.name);
    } else if (parameter.need == core::Need::required && why.empty()) {
      why = fmt::format("law {} lacks {}", schema.name, parameter.name);
    }
  if constexpr (requires { law.check(); })
    if (auto const complaints = law.check(); why.empty() && !complaints.empty())
      why = fmt::format("law {}: {} {}", schema.name, complaints.front().path, complaints.front().text);
  laws.push_back(law);
  return true;
}

template<class... T>
std::string read_list(json const& all, char const* key, std::vector<std::variant<T...>>& laws) {
  std::string why;
  if (!all.contains(key) || !all[key].is_array())
    return fmt::format("the laws name no {}", key);
  for (auto const& entry : all[key])
    if (!(read_kind<T>(entry, laws, why) || ...))
      why = fmt::format("a law among {} is of an unknown kind", key);
  return why;
}

} // namespace

std::string text_of_laws(contact::Problem const& problem) {
  return json{{"adhesions", to_list(problem.adhesions)}, {"frictions", to_list(problem.frictions)}}.dump();
}

std::string read_laws(std::string const& text, contact::Problem& problem) {
  auto const all = json::parse(text, nullptr, false);
  if (!all.is_object())
    return "the laws are no JSON object";
  auto const why = read_list(all, "adhesions", problem.adhesions);
  return why.empty() ? read_list(all, "frictions", problem.frictions) : why;
}

} // namespace stiction::record
