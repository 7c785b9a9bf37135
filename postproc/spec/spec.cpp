// SPEC.json through the same reader that checks scripts, so that messages look alike.
#include "spec/spec.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "core/reader.hpp"
#include "spec/solid_spec.hpp"

namespace stiction::postproc {

namespace {

using core::Need;
using core::Reader;
using nlohmann::json;

core::Input to_input(json const& value, std::string const& place) {
  core::Input input;
  input.place = place;
  if (value.is_boolean())
    input.value = value.get<bool>();
  else if (value.is_number())
    input.value = core::Quantity{value.get<double>(), {}};
  else if (value.is_string())
    input.value = value.get<std::string>();
  else if (value.is_array()) {
    core::List list;
    for (auto const& element : value)
      list.push_back(to_input(element, place));
    input.value = std::move(list);
  } else if (value.is_object()) {
    core::Table table;
    for (auto const& [key, element] : value.items())
      table.emplace(key, to_input(element, place));
    input.value = std::move(table);
  }
  return input;
}

std::string choice(Reader& reader, std::string_view key, std::vector<std::string> const& choices,
                   std::string fallback) {
  std::string const word = reader.text(key, Need::optional);
  if (word.empty())
    return fallback;
  if (std::find(choices.begin(), choices.end(), word) == choices.end())
    reader.complain_at(key, fmt::format("is \"{}\"; it must be one of {}", word, fmt::join(choices, ", ")));
  return word;
}

Unit unit_at(Reader& reader, std::string_view key, std::string_view fallback) {
  Unit unit;
  unit.word = reader.has(key) ? reader.text(key) : (reader.at(key, Need::optional), std::string(fallback));
  if (auto const si = core::parse_unit(unit.word))
    unit.si = *si;
  else
    reader.complain_at(key, fmt::format("is \"{}\", which is no unit; known words are {}", unit.word,
                                        fmt::join(core::unit_words(), " ")));
  return unit;
}

Interval interval_at(Reader& reader, std::string_view key) {
  auto const ends = reader.numbers(key, "1", Need::optional);
  if (!reader.has(key))
    return {};
  if (ends.size() == 2 && ends[0] < ends[1])
    return std::pair{ends[0], ends[1]};
  reader.complain_at(key, "wants two numbers [low, high] with low < high");
  return {};
}

AxisSpec read_axis(Reader reader) {
  AxisSpec axis;
  axis.label = reader.text("label");
  axis.unit = unit_at(reader, "unit", "1");
  axis.log = reader.flag_or("log", false);
  axis.range = interval_at(reader, "range");
  if (axis.log && axis.range && axis.range->first <= 0)
    reader.complain_at("range",
                       fmt::format("starts at {:g}; a logarithmic axis wants > 0", axis.range->first));
  reader.finish();
  return axis;
}

CoordinateSpec read_coordinate(Reader& reader, std::string const& key) {
  CoordinateSpec coordinate;
  auto const& given = reader.at(key);
  if (given.list() != nullptr)
    coordinate.numbers = reader.numbers(key, "1");
  else if (reader.has(key))
    coordinate.dataset = reader.text(key);
  coordinate.shift = reader.number_or(key + "_shift", "1", core::any_number, 0);
  coordinate.sign = reader.number_or(key + "_sign", "1", core::any_number, 1);
  return coordinate;
}

std::optional<std::size_t> index_at(Reader& reader, std::string_view key) {
  double const value = reader.number_or(key, "1", core::non_negative, 0);
  if (!reader.has(key))
    return {};
  if (value != std::floor(value) || value > 1e6)
    reader.complain_at(key, fmt::format("is {:g}; a whole number from 0 is wanted", value));
  return static_cast<std::size_t>(std::min(value, 1e6));
}

std::optional<Dash> dash_at(Reader& reader) {
  static std::vector<std::string> const words{"solid", "dash", "dot", "dashdot", "points"};
  std::string const word = choice(reader, "style", words, "");
  auto const found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    return {};
  return static_cast<Dash>(found - words.begin());
}

/// Errors of the points of a curve that is given by `count` numbers.
std::vector<double> errors_at(Reader& reader, std::string const& key, std::size_t count) {
  auto errors = reader.numbers(key, "1", Need::optional);
  if (!reader.has(key))
    return {};
  if (errors.size() != count)
    reader.complain_at(key,
                       fmt::format("has {} numbers but the curve has {} given points", errors.size(), count));
  for (double const error : errors)
    if (!(error >= 0) || !std::isfinite(error))
      reader.complain_at(key, fmt::format("has {:g}; an error is 0 or more", error));
  return errors;
}

/// Texts beside the points of a curve that is given by `count` numbers.
std::vector<std::string> names_at(Reader& reader, std::size_t count) {
  auto const& given = reader.at("names", Need::optional);
  std::vector<std::string> names;
  if (!reader.has("names"))
    return names;
  for (auto const& element : given.list() == nullptr ? core::List{} : *given.list())
    if (auto const* word = element.text())
      names.push_back(*word);
  if (names.size() != count)
    reader.complain_at("names",
                       fmt::format("has {} texts but the curve has {} given points", names.size(), count));
  return names;
}

CurveSpec read_curve(Reader reader, std::filesystem::path const& folder) {
  CurveSpec curve;
  curve.label = reader.text("label", Need::optional);
  curve.x = read_coordinate(reader, "x");
  curve.y = read_coordinate(reader, "y");
  bool const from_file = !curve.x.dataset.empty() || !curve.y.dataset.empty();
  curve.file = folder / reader.text("file", from_file ? Need::required : Need::optional);
  curve.component = index_at(reader, "component").value_or(0);
  curve.colour = index_at(reader, "colour");
  curve.dash = dash_at(reader);
  bool const numbers = curve.x.dataset.empty() && curve.y.dataset.empty();
  if (numbers && curve.x.numbers.size() != curve.y.numbers.size())
    reader.complain_at(
        "y", fmt::format("has {} numbers but x has {}", curve.y.numbers.size(), curve.x.numbers.size()));
  curve.x_error = errors_at(reader, "x_error", numbers ? curve.x.numbers.size() : 0);
  curve.y_error = errors_at(reader, "error", numbers ? curve.x.numbers.size() : 0);
  curve.names = names_at(reader, numbers ? curve.x.numbers.size() : 0);
  curve.at_most = reader.numbers("at_most", "1", Need::optional);
  if (reader.has("at_most") && (!numbers || curve.at_most.size() != curve.x.numbers.size()))
    reader.complain_at("at_most", "wants 0 or 1 for each given point of the curve");
  reader.finish();
  return curve;
}

LinesSpec read_lines(Reader& reader, std::filesystem::path const& folder) {
  LinesSpec lines;
  lines.x = read_axis(reader.child("x"));
  lines.y = read_axis(reader.child("y"));
  lines.legend =
      choice(reader, "legend", {"top right", "top left", "bottom right", "bottom left", "below", "none"}, "");
  lines.sequential = choice(reader, "colours", {"distinct", "sequential"}, "distinct") == "sequential";
  for (auto& curve : reader.children("curves"))
    lines.curves.push_back(read_curve(curve, folder));
  if (lines.curves.empty())
    reader.complain_at("curves", "has no curve; at least one is wanted");
  for (auto& mark : reader.children("marks", Need::optional)) {
    lines.marks.push_back({mark.number("x", "1", core::any_number), mark.text("label", Need::optional)});
    mark.finish();
  }
  return lines;
}

std::optional<double> time_at(Reader& reader) {
  auto const& given = reader.at("time", Need::optional);
  if (!reader.has("time") || (given.text() != nullptr && *given.text() == "last"))
    return {};
  if (given.quantity() == nullptr)
    reader.complain_at("time", "wants a number in seconds or \"last\"");
  return given.quantity() == nullptr ? 0 : given.quantity()->value;
}

/// The factor of the unit that lengths of the mesh are given in.
double length_unit_at(Reader& reader) {
  auto const unit = unit_at(reader, "window_unit", "m");
  if (unit.si.dimension != core::Dimension{1, 0, 0})
    reader.complain_at("window_unit", fmt::format("is {}; a length is wanted", unit.word));
  return unit.si.value;
}

std::vector<double> window_at(Reader& reader, double metres) {
  auto window = reader.numbers("window", "1", Need::optional);
  bool const good = window.size() == 4 && window[0] < window[1] && window[2] < window[3];
  if (reader.has("window") && !good)
    reader.complain_at("window", "wants four numbers [xmin, xmax, ymin, ymax], each min < max");
  for (auto& edge : window)
    edge *= metres;
  return window;
}

std::optional<ScaleBarSpec> scale_bar_at(Reader& reader) {
  auto bar = reader.child("scale_bar", Need::optional);
  if (!reader.has("scale_bar"))
    return {};
  ScaleBarSpec result{bar.number("length", "1", core::positive), unit_at(bar, "unit", "m")};
  if (result.unit.si.dimension != core::Dimension{1, 0, 0})
    bar.complain_at("unit", fmt::format("is {}; a length is wanted", result.unit.word));
  bar.finish();
  return result;
}

std::optional<FilmSpec> film_at(Reader& reader) {
  auto film = reader.child("film", Need::optional);
  if (!reader.has("film"))
    return {};
  if (reader.has("time"))
    reader.complain_at("time", "is not for a film, which shows all times; leave it out");
  double const frames = film.number_or("frames", "1", {0, 1e5}, 0),
               rate = film.number_or("rate", "1", {1, 60}, 10);
  for (auto const& [key, value] : {std::pair{"frames", frames}, std::pair{"rate", rate}})
    if (value != std::floor(value))
      film.complain_at(key, fmt::format("is {:g}; a whole number is wanted", value));
  film.finish();
  return FilmSpec{static_cast<int>(frames), static_cast<int>(rate)};
}

FieldSpec read_field(Reader& reader, std::filesystem::path const& folder) {
  FieldSpec field;
  field.file = folder / reader.text("file");
  field.time = time_at(reader);
  field.array = reader.text("array");
  if (auto const component = index_at(reader, "component"))
    field.component = static_cast<int>(*component);
  field.label = reader.text("label", Need::optional);
  if (field.label.empty())
    field.label = field.array;
  field.unit = unit_at(reader, "unit", "1");
  field.deformed = reader.flag_or("deformed", false);
  field.mesh = reader.flag_or("mesh", false);
  field.show_time = reader.flag_or("show_time", true);
  field.range = interval_at(reader, "range");
  double const metres = length_unit_at(reader);
  field.window = window_at(reader, metres);
  read_solid(reader, metres, field);
  field.scale_bar = scale_bar_at(reader);
  field.film = film_at(reader);
  return field;
}

MapRow read_row(Reader& reader, MapSpec const& map) {
  MapRow row{reader.text("group"), reader.text("label"), reader.text("cells")};
  if (row.cells.size() != map.columns.size())
    reader.complain_at("cells",
                       fmt::format("has {} letters for {} columns", row.cells.size(), map.columns.size()));
  reader.finish();
  return row;
}

MapSpec read_map(Reader& reader) {
  MapSpec map;
  map.blocks = static_cast<int>(reader.number_or("blocks", "1", {1, 6}, 1));
  for (auto& column : reader.children("columns")) {
    map.columns.push_back(column.text("label"));
    column.finish();
  }
  for (auto& kind : reader.children("kinds")) {
    map.kinds.push_back(
        {kind.text("letter"), kind.text("label"), index_at(kind, "colour").value_or(map.kinds.size())});
    if (map.kinds.back().letter.size() != 1)
      kind.complain_at("letter", "wants one letter");
    kind.finish();
  }
  for (auto& row : reader.children("rows"))
    map.rows.push_back(read_row(row, map));
  return map;
}

void read_content(Reader& reader, FigureSpec& figure, std::filesystem::path const& folder);

/// What files are made.
void read_output(Reader& reader, FigureSpec& figure) {
  double const dpi = reader.number_or("dpi", "1", {100, 600}, figure.dpi);
  if (dpi != std::floor(dpi))
    reader.complain_at("dpi", fmt::format("is {:g}; a whole number is wanted", dpi));
  figure.dpi = static_cast<int>(dpi);
  figure.svg = reader.flag_or("svg", false);
  figure.pdf = reader.flag_or("pdf", false);
}

/// A film is one file by itself.
void check_film(Reader& reader, FigureSpec const& figure, bool in_panel) {
  auto const* field = std::get_if<FieldSpec>(&figure.content);
  if (field == nullptr || !field->film)
    return;
  if (in_panel)
    reader.complain_at("film", "is not for a part of a panel; make it a figure of its own");
  if (figure.svg || figure.pdf)
    reader.complain_at("film", "is written as Ogg/Theora alone; leave out svg and pdf");
}

FigureSpec read_figure(Reader reader, std::filesystem::path const& folder, bool in_panel) {
  FigureSpec figure;
  figure.name = reader.text("name", in_panel ? Need::optional : Need::required);
  bool const is_file_name = figure.name.find_first_of("/\\") == std::string::npos && figure.name[0] != '.';
  if (!is_file_name)
    reader.complain_at("name",
                       fmt::format("is \"{}\"; a plain file name is wanted, without folders", figure.name));
  figure.title = reader.text("title", Need::optional);
  std::string const kind = reader.text("kind");
  if (in_panel && kind == "panel")
    reader.complain_at("kind", "is \"panel\" within a panel; a panel holds lines and fields");
  std::string const usual = kind == "panel" || kind == "map" ? "double" : "single";
  bool const wide = choice(reader, "width", {"single", "double"}, usual) == "double";
  figure.width = static_cast<int>(std::lround(millimetres(wide ? 175 : 85)));
  figure.height = millimetres(reader.number_or("height", "1", {20, 240}, 0));
  if (kind == "map" && reader.has("height"))
    reader.complain_at("height", "is not for a map, whose rows decide; leave it out");
  if (!in_panel)
    read_output(reader, figure);
  read_content(reader, figure, folder);
  check_film(reader, figure, in_panel);
  reader.finish();
  return figure;
}

PanelSpec read_panel(Reader& reader, std::filesystem::path const& folder) {
  PanelSpec panel;
  panel.columns = static_cast<int>(reader.number_or("columns", "1", {1, 6}, 2));
  panel.common_range = reader.flag_or("common_range", false);
  for (auto& figure : reader.children("figures"))
    panel.figures.push_back(read_figure(figure, folder, true));
  if (panel.figures.empty())
    reader.complain_at("figures", "has no figure; at least one is wanted");
  return panel;
}

void read_content(Reader& reader, FigureSpec& figure, std::filesystem::path const& folder) {
  std::string const kind = choice(reader, "kind", {"lines", "field", "map", "panel"}, "");
  if (kind == "lines")
    figure.content = read_lines(reader, folder);
  else if (kind == "field")
    figure.content = read_field(reader, folder);
  else if (kind == "map")
    figure.content = read_map(reader);
  else if (kind == "panel")
    figure.content = read_panel(reader, folder);
}

json parse_json(std::filesystem::path const& file) {
  std::ifstream stream(file);
  if (!stream)
    throw core::InputError(fmt::format("{}: cannot be read; give the path of a SPEC.json", file.string()));
  try {
    return json::parse(stream);
  } catch (json::parse_error const& error) {
    throw core::InputError(fmt::format("{}: is not JSON: {}", file.string(), error.what()));
  }
}

} // namespace

std::vector<FigureSpec> read_spec(std::filesystem::path const& file) {
  auto const input = to_input(parse_json(file), file.string());
  core::Complaints complaints;
  Reader reader(input, "", complaints);
  std::vector<FigureSpec> figures;
  std::set<std::string> names;
  for (auto& figure : reader.children("figures")) {
    figures.push_back(read_figure(figure, file.parent_path(), false));
    if (!names.insert(figures.back().name).second)
      figure.complain_at("name", fmt::format("\"{}\" is used twice; names must differ", figures.back().name));
  }
  reader.finish();
  if (figures.empty() && complaints.empty())
    reader.complain_at("figures", "is empty; at least one figure is wanted");
  if (!complaints.empty())
    throw core::InputError(std::move(complaints));
  return figures;
}

} // namespace stiction::postproc
