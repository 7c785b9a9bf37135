// Values, inputs and schemas as JSON.
#include "record/manifest.hpp"

#include <cmath>

#include "record/file.hpp"

namespace stiction::record {

using nlohmann::json;

namespace {

json number(double value) {
  if (std::isnan(value))
    return "nan";
  if (std::isinf(value))
    return value > 0 ? "inf" : "-inf";
  return value;
}

struct ToJson {
  json operator()(std::monostate) const { return nullptr; }
  json operator()(bool value) const { return value; }
  json operator()(double value) const { return number(value); }
  json operator()(std::string const& value) const { return value; }
  json operator()(core::Numbers const& values) const {
    json array = json::array();
    for (double const value : values)
      array.push_back(number(value));
    return array;
  }
  json operator()(core::Quantity const& quantity) const {
    if (quantity.dimension == core::Dimension{})
      return number(quantity.value);
    return {{"value", number(quantity.value)}, {"unit", core::to_string(quantity.dimension)}};
  }
  json operator()(core::List const& list) const {
    json array = json::array();
    for (auto const& element : list)
      array.push_back(to_json(element));
    return array;
  }
  json operator()(core::Table const& table) const {
    json object = json::object();
    for (auto const& [key, element] : table)
      object[key] = to_json(element);
    return object;
  }
};

} // namespace

json to_json(core::Value const& value) {
  return std::visit(ToJson{}, value);
}

json to_json(core::Input const& input) {
  json result = std::visit(ToJson{}, input.value);
  if (!input.tag.empty() && result.is_object())
    result["kind"] = input.tag;
  return result;
}

json describe(void const* object, core::Schema const& schema) {
  json result = json::object();
  for (auto const& parameter : schema.parameters)
    if (parameter.kind != core::Parameter::Kind::nested)
      result[parameter.name] = {{"value", to_json(parameter.get(object))},
                                {"unit", parameter.unit},
                                {"meaning", parameter.meaning}};
  return result;
}

void write_manifest(std::filesystem::path const& path, json const& manifest) {
  // a file name in a foreign encoding must not end the run: its bytes are replaced
  replace_file(path, manifest.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

} // namespace stiction::record
