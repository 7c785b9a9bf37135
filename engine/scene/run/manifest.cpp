// Walks the scene as it was written by the schemas of its parts, and adds what only the built scene knows.
#include "scene/run/manifest.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/bulk/bulk_choice.hpp"
#include "mesh/topology/quality.hpp"
#include "record/manifest.hpp"

namespace stiction::scene {

namespace {

using nlohmann::json;

Category const& category_of(std::string const& name) {
  auto const found =
      std::ranges::find_if(catalog(), [&](Category const& category) { return category.name == name; });
  core::expect(found != catalog().end(), "every nested part is of a category of the catalog");
  return *found;
}

/// By the last word of the constructor's tag; a table without one is of the only kind there is.
core::Schema const& schema_of(core::Input const& part, Category const& category) {
  auto const name = part.tag.substr(part.tag.rfind('.') + 1);
  auto const found =
      std::ranges::find_if(category.kinds, [&](core::Schema const& kind) { return kind.name == name; });
  return found == category.kinds.end() ? category.kinds.front() : *found;
}

/// Quantities become their SI numbers; the unit stands beside.
json plain(core::Input const& value) {
  if (auto const* quantity = value.quantity())
    return record::to_json(core::Value{quantity->value});
  if (auto const* list = value.list()) {
    auto array = json::array();
    for (auto const& element : *list)
      array.push_back(plain(element));
    return array;
  }
  return record::to_json(value);
}

/// One part, a list of them, or a table of them by name.
json describe_nested(core::Input const& input, Category const& category) {
  if (auto const* list = input.list()) {
    auto array = json::array();
    for (auto const& part : *list)
      array.push_back(describe_part(part, category));
    return array;
  }
  auto const* table = input.table();
  bool const named =
      table != nullptr && input.tag.empty() &&
      std::ranges::all_of(*table, [](auto const& entry) { return entry.second.table() != nullptr; });
  if (!named)
    return describe_part(input, category);
  auto object = json::object();
  for (auto const& [name, part] : *table)
    object[name] = describe_part(part, category);
  return object;
}

} // namespace

json describe_part(core::Input const& part, Category const& category) {
  static core::Table const nothing;
  auto const& schema = schema_of(part, category);
  auto const& table = part.table() != nullptr ? *part.table() : nothing;
  json result{{"is", schema.name}};
  for (std::size_t i = 0; i < schema.parameters.size(); ++i) {
    auto const& parameter = schema.parameters[i];
    auto const found = table.find(parameter.name);
    bool const given = found != table.end();
    if (parameter.kind == core::Parameter::Kind::nested && !given)
      result[parameter.name] = nullptr;
    else if (parameter.kind == core::Parameter::Kind::nested)
      result[parameter.name] = parameter.unit == plain_table
                                   ? record::to_json(found->second)
                                   : describe_nested(found->second, category_of(parameter.unit));
    else
      result[parameter.name] = {{"value", given ? plain(found->second) : record::to_json(schema.fallback(i))},
                                {"unit", parameter.unit},
                                {"meaning", parameter.meaning},
                                {"given", given}};
  }
  return result;
}

namespace {

/// What the program took where the script says nothing, or leaves it to other parameters.
template<class Part> void take(json& described, Part const& part) {
  if (described.is_null())
    described = {{"is", part.schema().name}};
  auto const taken = record::describe(&part, part.schema());
  for (auto const& [name, entry] : taken.items()) {
    bool const known = described.contains(name);
    described[name]["value"] = entry["value"];
    described[name]["unit"] = entry["unit"];
    described[name]["meaning"] = entry["meaning"];
    if (!known)
      described[name]["given"] = false;
  }
}
template<class... Parts> void take(json& described, std::variant<Parts...> const& choice) {
  std::visit([&](auto const& part) { take(described, part); }, choice);
}

json quality_of(mesh::Mesh const& mesh) {
  auto const quality = mesh::quality(mesh);
  return {{"nodes", quality.nodes},
          {"cells", quality.cells},
          {"min_scaled_jacobian", quality.min_jacobian},
          {"median_scaled_jacobian", quality.median_jacobian},
          {"min_angle_deg", quality.min_angle},
          {"max_angle_deg", quality.max_angle},
          {"max_aspect_ratio", quality.max_aspect},
          {"min_edge_m", quality.min_edge}};
}

template<class Choice> json describe(Choice const& choice) {
  return std::visit(
      [](auto const& part) {
        return json{{part.schema().name, record::describe(&part, part.schema())}};
      },
      choice);
}

/// Laws of the pairs.
void add_pairs(Scene const& scene, json& settings) {
  for (auto const& [name, pair] : scene.part.pairs) {
    auto& laws = settings["pairs"][name];
    laws["pair"] = record::describe(&pair, PairPart::schema());
    if (pair.law.friction)
      laws.update(describe(*pair.law.friction));
    if (pair.law.adhesion)
      laws.update(describe(*pair.law.adhesion));
  }
}

/// Of the heights as they are.
json moments_of(halfspace::Model const& model) {
  auto const moments = halfspace::moments(model.heights, model.grid);
  return {
      {"rms_height", {{"value", moments.height}, {"unit", "m"}, {"meaning", "about the mean"}}},
      {"rms_slope", {{"value", moments.slope}, {"unit", "1"}, {"meaning", "of the gradient"}}},
      {"rms_curvature", {{"value", moments.curvature}, {"unit", "1/m"}, {"meaning", "of the Laplacian"}}}};
}

json settings_of_half_space(Scene const& scene) {
  json settings;
  settings["scheme"] = describe(scene.part.scheme);
  settings["solver"] = describe(scene.part.solver);
  for (auto const& [name, body] : scene.part.half_spaces)
    settings["bodies"][name] = record::describe(&body, HalfSpacePart::schema());
  for (auto const& [name, map] : scene.part.height_maps) {
    settings["obstacles"][name] = record::describe(&map, HeightMapPart::schema());
    if (!std::holds_alternative<halfspace::Map>(map.surface)) // of which the heights would stand here
      settings["obstacles"][name]["surface"] = describe(map.surface);
  }
  if (scene.half_space->grid.periodic)
    settings["heights"] = moments_of(*scene.half_space);
  add_pairs(scene, settings);
  settings["unknowns"] = scene.formula ? 0 : scene.half_space->components() * scene.half_space->grid.size();
  if (scene.formula)
    settings["formula"] = {{"name", scene.formula->normal->name()},
                           {"source", scene.formula->normal->source()},
                           {"fits", scene.formula->fits},
                           {"neglects", scene.formula->neglects}};
  return settings;
}

/// What follows from the heights of a rigid map.
json facts_of(contact::RigidHeights const& map) {
  json facts = json::object();
  if (double const radius = contact::sharpest_peak(map); std::isfinite(radius))
    facts["peak_radius"] = {{"value", radius}, {"unit", "m"}, {"meaning", "smallest of its peaks"}};
  if (map.points.size() == 1)
    facts["profile"] = {{"value", contact::profile(map)},
                        {"unit", "m"},
                        {"meaning", "points of its surface at the start, x and y in turn"}};
  return facts;
}

/// With the heights that the nodes have.
json relief_of(ReliefPart const& part, Relief const& made) {
  auto relief = record::describe(&part, ReliefPart::schema());
  if (!std::holds_alternative<halfspace::Map>(part.surface))
    relief["surface"] = describe(part.surface);
  relief["least"] = {{"value", made.least}, {"unit", "m"}, {"meaning", "height at its nodes"}};
  relief["most"] = {{"value", made.most}, {"unit", "m"}, {"meaning", "height at its nodes"}};
  relief["spacing"] = {{"value", made.spacing}, {"unit", "m"}, {"meaning", "largest, of its nodes"}};
  return relief;
}

json settings_of(Scene const& scene) {
  if (scene.half_space)
    return settings_of_half_space(scene);
  json settings;
  settings["scheme"] = describe(scene.part.scheme);
  settings["solver"] = describe(scene.part.solver);
  settings["control"] = record::describe(&scene.part.control, scene.part.control.schema());
  settings["control"]["bulk_taken"] = dynamics::by_multigrid(*scene.model) ? "multigrid" : "direct";
  if (scene.model->share)
    settings["ranks"] = scene.model->share->ranks->count();
  if (auto const& accuracy = scene.part.schedule.accuracy; accuracy)
    settings["accuracy"] = record::describe(&*accuracy, accuracy->schema());
  for (auto const& [name, body] : scene.part.bodies) {
    if (body.laws_by_set.empty())
      settings["bodies"][name] = describe(body.material);
    for (auto const& [set, law] : body.laws_by_set)
      settings["bodies"][name][set] = describe(law);
    if (body.remesh)
      settings["bodies"][name]["remesh"] = record::describe(&*body.remesh, RemeshPart::schema());
  }
  for (auto const& [name, made] : scene.reliefs)
    settings["bodies"][name]["relief"] = relief_of(*scene.part.bodies.at(name).relief, made);
  for (auto const& rigid : scene.model->rigids)
    if (auto const* map = std::get_if<contact::RigidHeights>(&rigid.shape))
      settings["obstacles"][rigid.name] = facts_of(*map);
  add_pairs(scene, settings);
  for (auto const& body : scene.model->bodies)
    settings["meshes"][body->name] = quality_of(body->mesh);
  settings["unknowns"] = scene.model->dofs();
  return settings;
}

} // namespace

json describe_parts(core::Input const& scene, ScenePart const& part) {
  auto parts = describe_part(scene, category_of("scene"));
  take(parts["scheme"], part.scheme);
  take(parts["solver"], part.solver);
  take(parts["control"], part.control);
  take(parts["output"], part.output);
  for (auto const& [name, pair] : part.pairs) {
    if (pair.law.friction)
      take(parts["pairs"][name]["friction"], *pair.law.friction);
    if (pair.law.adhesion)
      take(parts["pairs"][name]["adhesion"], *pair.law.adhesion);
  }
  return parts;
}

json manifest_of(core::Input const& input, Scene const& scene, RunOptions const& options) {
  auto manifest = options.manifest_json.empty() ? json::object() : json::parse(options.manifest_json);
  manifest["case"] = options.case_id;
  manifest["scene"] = record::to_json(input);
  manifest["build"] = record::build_identity();
  manifest["host"] = record::host_facts();
  manifest["host"]["threads"] = options.threads;
  manifest["settings"] = settings_of(scene);
  manifest["parts"] = describe_parts(input, scene.part);
  return manifest;
}

nlohmann::json manifest_of(core::Input const& asked, Scene const& scene, RunOptions const& options,
                           Story const& story, std::vector<Warning> const& warnings) {
  auto manifest = manifest_of(asked, scene, options);
  manifest["started"] = story.started;
  if (!story.continued.empty())
    manifest["continued"] = story.continuations();
  auto& told = manifest["warnings"] = nlohmann::json::array();
  for (auto const& warning : warnings)
    told.push_back({{"text", warning.text}, {"change", warning.change}});
  return manifest;
}

} // namespace stiction::scene
