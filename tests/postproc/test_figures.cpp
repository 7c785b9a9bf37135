// Runs stiction-figures on samples; checks exit codes, messages, and that the ink is where the data say.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <fmt/format.h>

#include "harness.hpp"
#include "samples.hpp"

namespace {

using namespace harness;
namespace fs = std::filesystem;

constexpr Colour blue{0, 114, 178}, vermilion{213, 94, 0}, green{0, 158, 115};
constexpr int single_column = 1004, double_column = 2067;

std::string const beta_lines = R"({"name":"beta","kind":"lines","x":{"label":"time","unit":"ms"},
  "y":{"label":"bond intensity β","unit":"1"},
  "marks":[{"x":1,"label":"sliding starts"}],
  "curves":[{"label":"μ = 0","file":"case0/series.h5","x":"/time","y":"/crown/beta"},
            {"label":"μ = 0.4","file":"case4/series.h5","x":"/time","y":"/crown/beta"},
            {"label":"μ = 0.8","file":"case8/series.h5","x":"/time","y":"/crown/beta","style":"dash"},
            {"label":"reference","x":[0.5,1,2,3],"y":[0.1,0.2,0.25,0.21],"style":"points"}]})";

std::string const von_mises = R"({"name":"mises","kind":"field","file":"case0/fields.pvd","time":"last",
  "array":"von_mises","unit":"MPa","label":"von Mises stress σ","deformed":true,"mesh":true,
  "title":"μ = 0.4, end of descent","scale_bar":{"length":2,"unit":"mm"}})";

/// One curve of the first sample with everything else ordinary.
std::string simple_lines(std::string const& curve, std::string const& y_unit) {
  return fmt::format(R"({{"name":"it","kind":"lines","x":{{"label":"time","unit":"ms"}},
    "y":{{"label":"beta","unit":"{}"}},"curves":[{{"label":"c","x":"/time",{}}}]}})",
                     y_unit, curve);
}

struct Samples {
  Samples() {
    fs::remove_all(work);
    samples::write_series(work / "case0/series.h5", 0);
    samples::write_series(work / "case4/series.h5", 0.4);
    samples::write_series(work / "case8/series.h5", 0.8);
    samples::write_steps(work / "case0");
  }
};
Samples const made;

} // namespace

TEST_CASE("lines have the width of a column and ink of every curve") {
  auto const result = draw("lines", beta_lines);
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "lines/beta.png");
  CHECK(image.width() == single_column);
  CHECK(image.height() > 600);
  CHECK(image.white_rim());
  CHECK(image.colours() > 30);
  for (auto const& colour : {blue, vermilion, green})
    CHECK(image.count(colour) > 500);
}

TEST_CASE("a curve lies where its numbers say") {
  auto const result = draw("place", R"({"name":"flat","kind":"lines","height":60,"legend":"none",
    "x":{"label":"x","unit":"1","range":[0,1]},"y":{"label":"y","unit":"1","range":[0,1]},
    "curves":[{"x":[0,1],"y":[0.75,0.75]}]})");
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "place/flat.png");
  CHECK(image.height() == 709);
  CHECK(image.count(blue, {0.2, 0.98, 0, 0.6}) == 0);
  CHECK(image.count(blue, {0.2, 0.9, 0.7, 0.85}) > 2000);
  CHECK(image.count(blue, {0.2, 0.98, 0.85, 1}) == 0);
}

TEST_CASE("shift, sign and component act in SI before the axis unit") {
  auto const result = draw("shift", R"({"name":"it","kind":"lines","legend":"none",
    "x":{"label":"time","unit":"ms","range":[-1,3]},"y":{"label":"pressure","unit":"MPa","range":[0,4]},
    "curves":[{"file":"case0/series.h5","x":"/time","x_shift":1e-3,"y":"/crown/traction","component":0,"y_sign":-1}]})");
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "shift/it.png"); // the diagonal
  CHECK(image.count(blue, {0.15, 0.4, 0.15, 0.5}) > 500);
  CHECK(image.count(blue, {0.7, 0.98, 0.7, 0.98}) > 500);
  CHECK(image.count(blue, {0.15, 0.5, 0.6, 0.98}) == 0);
}

TEST_CASE("logarithmic axes show a power law as a straight line") {
  auto const result = draw("log", R"({"name":"it","kind":"lines","legend":"none",
    "x":{"label":"dt","unit":"us","log":true,"range":[0.1,1000]},
    "y":{"label":"energy error","unit":"1","log":true,"range":[1e-9,1e-1]},
    "curves":[{"x":[0.1,1,10,100,1000],"y":[1e-9,1e-7,1e-5,1e-3,1e-1]},
              {"x":[0.1,1,10,100,1000],"y":[1e-9,1e-7,1e-5,1e-3,1e-1],"style":"points"}]})");
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "log/it.png");
  CHECK(image.count(vermilion, {0.5, 0.62, 0.5, 0.62}) > 50); // the middle point
  CHECK(image.count(blue, {0.2, 0.5, 0.65, 0.98}) == 0);
}

TEST_CASE("fields are drawn deformed with mesh and colour bar") {
  auto const result = draw("field", von_mises);
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "field/mises.png");
  CHECK(image.width() == single_column);
  CHECK(image.white_rim());
  CHECK(image.colours() > 500);
  CHECK(image.count({68, 1, 84}) > 1000);                  // the lowest colour: far from the contact
  CHECK(image.count({253, 231, 37}, {0, 1, 0, 0.4}) > 20); // the end of the bar
}

TEST_CASE("cell data, a window and a fixed range") {
  auto const result = draw("cells", R"({"name":"it","kind":"field","file":"case0/fields.pvd","time":4e-4,
    "array":"density","unit":"kg/m^3","label":"density","window":[-3,3,3,7],"window_unit":"mm","range":[1010,1050],
    "mesh":true,"width":"double"})");
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "cells/it.png");
  CHECK(image.width() == double_column);
  CHECK(image.count({68, 1, 84}) > 5000);
  CHECK(image.count({253, 231, 37}) > 5000);
}

TEST_CASE("second-order cells are drawn curved, a field of one value still has a colour") {
  samples::write_curved(work / "curved.vtu");
  auto const result = draw("curved", R"({"name":"it","kind":"field","file":"curved.vtu","array":"beta",
    "range":[0,1],"window":[0,1,-0.5,0]})");
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "curved/it.png"); // only the bulge: 2/3 of the window
  CHECK(image.count({253, 231, 37}, {0.4, 0.6, 0.5, 0.9}) > 10000);
  CHECK(image.count({253, 231, 37}, {0.02, 0.1, 0.3, 0.7}) == 0);
}

TEST_CASE("panels carry letters and all parts, pictures repeat bit by bit") {
  std::string const panel = R"({"name":"panel","kind":"panel","columns":2,"figures":[)" + beta_lines + "," +
                            von_mises + "," + beta_lines + "]}";
  REQUIRE(draw("panel", panel).code == 0);
  auto const first = content(work / "panel/panel.png");
  Image const image(work / "panel/panel.png");
  CHECK(std::abs(image.width() - double_column) <= 2);
  CHECK(image.count(blue, {0, 0.5, 0.5, 1}) > 500);
  CHECK(image.count(blue, {0, 0.5, 0, 0.5}) > 500);
  CHECK(image.count({68, 1, 84}, {0.5, 1, 0.5, 1}) > 1000);
  REQUIRE(draw("panel", panel).code == 0);
  CHECK(content(work / "panel/panel.png") == first);
}

TEST_CASE("fields of a panel share one range of colours where that is asked for") {
  auto const panel = [](std::string const& more) {
    auto early = von_mises;
    early.replace(early.find("\"last\""), 6, "0");
    return R"({"name":"it","kind":"panel","columns":2,"figures":[)" + von_mises + "," + early + "]" + more +
           "}";
  };
  REQUIRE(draw("own_ranges", panel("")).code == 0);
  REQUIRE(draw("one_range", panel(R"(,"common_range":true)")).code == 0);
  Image const own(work / "own_ranges/it.png"), common(work / "one_range/it.png");
  REQUIRE(own.width() == common.width());
  REQUIRE(own.height() == common.height());
  auto const differing = [&](int from, int to) {
    int count = 0;
    for (int x = from; x < to; ++x)
      for (int y = 0; y < own.height(); ++y)
        count += own.at(x, y) != common.at(x, y) ? 1 : 0;
    return count;
  };
  // The late one has the largest values; the least of the early one is a thousandth of its own least.
  CHECK(differing(0, own.width() / 2 - 20) < 10);
  CHECK(differing(own.width() / 2 + 20, own.width()) > 10000);
}

TEST_CASE("a panel has its title above its parts and shares its height among their rows") {
  auto const panel = [](std::string const& more) {
    return R"({"name":"it","kind":"panel","columns":1,"figures":[)" + von_mises + "," + von_mises + "]" +
           more + "}";
  };
  REQUIRE(draw("untitled", panel("")).code == 0);
  REQUIRE(draw("titled", panel(R"(,"title":"The title of all parts")")).code == 0);
  REQUIRE(draw("tall", panel(R"(,"title":"The title of all parts","height":200)")).code == 0);
  Image const without(work / "untitled/it.png"), with(work / "titled/it.png"), tall(work / "tall/it.png");
  int const strip = with.height() - without.height();
  CHECK(strip > 30);
  CHECK(with.white_rim());
  double const top = 1 - static_cast<double>(strip) / with.height();
  CHECK(with.count({38, 38, 38}, {0, 0.5, top, 1}) > 100); // ink of the words
  CHECK(std::abs(tall.height() - 200 / 25.4 * 300) <= 2);
  CHECK(draw("map_height", R"({"name":"it","kind":"map","height":90,"columns":[{"label":"a"}],
    "kinds":[{"letter":"x","label":"y"}],"rows":[{"group":"g","label":"r","cells":"x"}]})")
            .code == 2);
}

TEST_CASE("a map of many columns is wider, so that its rows keep their labels") {
  auto const map = [](int columns) {
    std::string heads, cells;
    for (int i = 0; i < columns; ++i) {
      heads += std::string(i > 0 ? "," : "") + R"({"label":"a"})";
      cells += "x";
    }
    return R"({"name":"it","kind":"map","columns":[)" + heads +
           R"(],"kinds":[{"letter":"x","label":"y"}],"rows":[{"group":"g","label":"a row","cells":")" +
           cells + R"("}]})";
  };
  auto const draws = [&](std::string const& name, int columns) {
    auto const drawn = draw(name, map(columns));
    REQUIRE_MESSAGE(drawn.code == 0, drawn.messages);
    return Image(work / name / "it.png");
  };
  Image const few = draws("few", 5), many = draws("many", 60);
  CHECK(few.width() < many.width());
  auto const labels = [](Image const& image) { // grey in the first tenth of an inch
    return image.count({110, 110, 110}, {0, 0.05, 60.0 / image.width(), 0.95});
  };
  CHECK(labels(many) > 0);
}

TEST_CASE("kinds of a map without colours each have their own") {
  auto const drawn = draw("kinds", R"({"name":"it","kind":"map","columns":[{"label":"a"},{"label":"b"}],
    "kinds":[{"letter":"x","label":"one"},{"letter":"y","label":"two"}],
    "rows":[{"group":"g","label":"r","cells":"xy"}]})");
  REQUIRE_MESSAGE(drawn.code == 0, drawn.messages);
  Image const image(work / "kinds/it.png");
  CHECK(image.count({0, 114, 178}) > 100);
  CHECK(image.count({213, 94, 0}) > 100);
}

TEST_CASE("a wrong spec ends with 2 and says where") {
  auto const unit = draw("unit", simple_lines(R"("file":"case0/series.h5","y":"/crown/beta")", "MPa"));
  CHECK(unit.code == 2);
  CHECK(unit.messages.find("/crown/beta") != std::string::npos);
  CHECK(unit.messages.find("MPa") != std::string::npos);
  CHECK_FALSE(fs::exists(work / "unit/it.png"));
  auto const field = draw("field_unit", R"({"name":"it","kind":"field","file":"case0/fields.pvd",
    "array":"von_mises","unit":"mm"})");
  CHECK(field.code == 2);
  CHECK(field.messages.find("von_mises") != std::string::npos);
  auto const word = draw("word", simple_lines(R"("file":"case0/series.h5","y":"/crown/beta")", "furlong"));
  CHECK(word.code == 2);
  CHECK(word.messages.find("furlong") != std::string::npos);
  auto const key = draw("key", simple_lines(R"("file":"case0/series.h5","y":"/crown/beta","color":1)", "1"));
  CHECK(key.code == 2);
  CHECK(key.messages.find("did you mean \"colour\"") != std::string::npos);
  CHECK(draw("syntax", "{").code == 2);
  CHECK(draw("only", beta_lines, "--only nothing").code == 2);
  CHECK(run("").code == 2);
  CHECK(run("--help").code == 0);
}

TEST_CASE("what the files cannot give ends with 1 and its name, and leaves no picture") {
  auto const missing = draw("missing", simple_lines(R"("file":"nowhere/series.h5","y":"/crown/beta")", "1"));
  CHECK(missing.code == 1);
  CHECK(missing.messages.find("nowhere/series.h5") != std::string::npos);
  auto const dataset = draw("dataset", simple_lines(R"("file":"case0/series.h5","y":"/crown/gamma")", "1"));
  CHECK(dataset.code == 1);
  CHECK(dataset.messages.find("/crown/gamma") != std::string::npos);
  auto const broken =
      draw("broken", simple_lines(R"("file":"case0/series.h5","y":"/crown/broken")", "1") + "," + beta_lines);
  CHECK(broken.code == 1);
  CHECK(broken.messages.find("value 6 is nan") != std::string::npos);
  CHECK_FALSE(fs::exists(work / "broken/it.png"));
  CHECK(fs::exists(work / "broken/beta.png")); // the others are drawn all the same
  auto const array =
      draw("array", R"({"name":"it","kind":"field","file":"case0/fields.pvd","array":"misses"})");
  CHECK(array.code == 1);
  CHECK(array.messages.find("von_mises") != std::string::npos);
  samples::write_text(work / "torn.vtu", "<VTKFile type=\"UnstructuredGrid\"><Unstr");
  auto const torn = draw("torn", R"({"name":"it","kind":"field","file":"torn.vtu","array":"beta"})");
  CHECK(torn.code == 1);
  CHECK(torn.messages.find("torn.vtu") != std::string::npos);
}
