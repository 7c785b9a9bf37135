// What a figure in print needs: a stated resolution, lines as SVG, plots of a panel in line.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <regex>

#include "harness.hpp"
#include "samples.hpp"

namespace {

using namespace harness;

constexpr Colour axis{38, 38, 38}, blue{0, 114, 178};

std::string lines(std::string const& name, std::string const& y, std::string const& more) {
  return fmt::format(
      R"({{"name":"{}","kind":"lines","legend":"none","x":{{"label":"x","unit":"1","range":[0,1]}},
    "y":{{"label":"y","unit":"1",{}}}{}}})",
      name, y, more);
}

std::string field(std::string const& more) {
  samples::write_steps(work / "paper");
  return R"({"name":"it","kind":"field","file":"paper/fields.pvd","array":"von_mises","unit":"MPa","mesh":true)" +
         more + "}";
}

/// Pixels per metre that a PNG states; 0: none.
int stated(std::filesystem::path const& file) {
  auto const bytes = content(file);
  auto const at = bytes.find("pHYs");
  if (at == std::string::npos || at > 60)
    return 0;
  int value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes[at + 4 + i]);
  return value;
}

/// Columns (or rows) that are ink over more than half of a part of the picture: sides of plots.
std::vector<int> sides(Image const& image, bool columns) {
  std::vector<int> found;
  int const across = columns ? image.width() : image.height(),
            along = columns ? image.height() : image.width();
  for (int i = 0; i < across; ++i) {
    int run = 0, longest = 0;
    for (int j = 0; j < along; ++j) {
      run = (columns ? image.at(i, j) : image.at(j, i)) == axis ? run + 1 : 0;
      longest = std::max(longest, run);
    }
    if (longest > 0.3 * along && (found.empty() || i > found.back() + 3))
      found.push_back(i);
  }
  return found;
}

} // namespace

TEST_CASE("a picture states its resolution, and a finer one shows the same larger") {
  std::string const curve = R"(,"curves":[{"x":[0,1],"y":[0.75,0.75]}])";
  REQUIRE(draw("coarse", lines("it", R"("range":[0,1])", curve)).code == 0);
  REQUIRE(draw("fine", lines("it", R"("range":[0,1])", curve + R"(,"dpi":600)")).code == 0);
  Image const coarse(work / "coarse/it.png"), fine(work / "fine/it.png");
  CHECK(stated(work / "coarse/it.png") == 11811);
  CHECK(stated(work / "fine/it.png") == 23622);
  CHECK(fine.width() == 2 * coarse.width());
  CHECK(fine.height() == 2 * coarse.height());
  CHECK(std::abs(fine.count(blue) - 4 * coarse.count(blue)) < 0.1 * fine.count(blue));
  REQUIRE(draw("fine_mesh", field(R"(,"dpi":600)")).code == 0);
  Image const mesh(work / "fine_mesh/it.png");
  CHECK(mesh.width() == 2 * coarse.width());
  CHECK(mesh.white_rim());
  CHECK(mesh.count({68, 1, 84}) > 4000);
  CHECK(draw("many", lines("it", R"("range":[0,1])", curve + R"(,"dpi":5000)")).code == 2);
}

TEST_CASE("SVG has the size in print, letters as paths, meshes as pictures, and repeats") {
  auto const panel = R"({"name":"it","kind":"panel","svg":true,"title":"β","figures":[)" + field("") + "," +
                     lines("part", R"("range":[0,1])", R"(,"curves":[{"x":[0,1],"y":[0,1]}])") + "]}";
  auto const result = draw("svg", panel);
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  auto const first = content(work / "svg/it.svg");
  CHECK(first.find("width=\"175.01mm\"") != std::string::npos);
  CHECK(first.find("<image") != std::string::npos);
  CHECK(first.find("xlink:href=\"data:image/png;base64,") != std::string::npos);
  CHECK(first.find("#0072b2") != std::string::npos);
  CHECK(first.find("<text") == std::string::npos);
  REQUIRE(draw("svg", panel).code == 0);
  CHECK(content(work / "svg/it.svg") == first);
  REQUIRE(draw("svg", lines("it", R"("range":[0,1])", R"(,"curves":[{"x":[0,1],"y":[0,1]}])")).code == 0);
  CHECK_FALSE(std::filesystem::exists(work / "svg/it.svg")); // of an earlier run
}

TEST_CASE("PDF has the size in print, letters as text in its own font, and repeats") {
  auto const panel =
      R"({"name":"it","kind":"panel","pdf":true,"title":"β of µ","figures":[)" + field("") + "," +
      lines("part", R"("range":[0,1e-3])", R"(,"curves":[{"label":"a label","x":[0,1],"y":[0,1e-3]}])") +
      "]}";
  auto const result = draw("pdf", panel);
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  auto const first = content(work / "pdf/it.pdf");
  CHECK(first.starts_with("%PDF-"));
  CHECK(first.find("/MediaBox [ 0 0 496.0") != std::string::npos); // 175 mm
  for (char const* part : {"/ToUnicode", "/FontFile2", "+DejaVuSans", "/Subtype /Image", "/Type0"})
    CHECK_MESSAGE(first.find(part) != std::string::npos, part);
  REQUIRE(draw("pdf", panel).code == 0);
  CHECK(content(work / "pdf/it.pdf") == first);
  if (std::system("command -v pdftotext >/dev/null") != 0) {
    MESSAGE("not read back: pdftotext is not installed (poppler-utils)");
    return;
  }
  auto const told = work / "pdf/it.txt", complaints = work / "pdf/said.txt";
  REQUIRE(std::system(fmt::format("pdftotext -layout {} {} 2>{}", (work / "pdf/it.pdf").string(),
                                  told.string(), complaints.string())
                          .c_str()) == 0);
  auto const text = content(told);
  for (char const* words : {"β of µ", "(a)", "von_mises [MPa]", "(b)", "y [10⁻³]", "0.8"})
    CHECK_MESSAGE(text.find(words) != std::string::npos, text);
  CHECK_MESSAGE(content(complaints).find("Syntax Error") == std::string::npos, content(complaints));
}

TEST_CASE("a curve that leaves its plot ends at the frame, in SVG too") {
  REQUIRE(draw("leaves",
               lines("it", R"("range":[0,1])", R"(,"svg":true,"curves":[{"x":[0,0.5,1],"y":[0.5,9,0.5]}])"))
              .code == 0);
  Image const image(work / "leaves/it.png");
  auto const top = sides(image, false).back(); // rows count from below
  CHECK(image.count(blue, {0, 1, 0, static_cast<double>(top) / image.height()}) > 500);
  CHECK(image.count(blue, {0, 1, static_cast<double>(top + 4) / image.height(), 1}) == 0);
  auto const text = content(work / "leaves/it.svg");
  std::regex const number(R"(,(-?[0-9.]+))");
  for (auto at = text.find("fill=\"#0072b2\""); at != std::string::npos;
       at = text.find("fill=\"#0072b2\"", at + 1)) {
    auto const path = text.substr(at, text.find("/>", at) - at);
    for (std::sregex_iterator match(path.begin(), path.end(), number), end; match != end; ++match)
      CHECK(std::stod((*match)[1]) > image.height() - top - 5);
  }
}

TEST_CASE("plots of a panel stand in line whatever their ticks, titles and legends take") {
  auto const wide = lines("a", R"("range":[0,1])", R"(,"curves":[{"x":[0,1],"y":[0,1]}])");
  auto const narrow = lines(
      "b", R"("range":[0,20000])",
      R"(,"title":"t","curves":[{"x":[0,1],"y":[0,20000],"label":"l"}],"marks":[{"x":0.5,"label":"m"}])");
  auto const result = draw("line", R"({"name":"it","kind":"panel","figures":[)" + wide + "," + narrow + "," +
                                       narrow + "," + wide + "]}");
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "line/it.png");
  auto const columns = sides(image, true), rows = sides(image, false);
  REQUIRE(columns.size() == 4); // left and right of two
  CHECK(std::abs((columns[1] - columns[0]) - (columns[3] - columns[2])) <= 1);
  REQUIRE(rows.size() == 4);
  CHECK(std::abs((rows[1] - rows[0]) - (rows[3] - rows[2])) <= 1);
}

namespace {

/// What the head of a film and its last page state.
struct Film {
  int width = 0, height = 0, rate = 0, frames = 0;
};

int big_endian(std::string const& bytes, std::size_t at, std::size_t count) {
  int value = 0;
  for (std::size_t i = at; i < at + count; ++i)
    value = 256 * value + static_cast<unsigned char>(bytes.at(i));
  return value;
}

Film film_of(std::filesystem::path const& file) {
  auto const bytes = content(file);
  auto const head = bytes.find("\x80theora"), last = bytes.rfind("OggS");
  REQUIRE(bytes.starts_with("OggS"));
  REQUIRE(head != std::string::npos);
  Film film{big_endian(bytes, head + 14, 3), big_endian(bytes, head + 17, 3), 0, 0};
  film.rate = big_endian(bytes, head + 22, 4) / big_endian(bytes, head + 26, 4);
  int const shift =
      (big_endian(bytes, head + 40, 2) >> 5) & 31; // between key frames and those that follow them
  int granule = 0;
  for (std::size_t i = 4; i-- > 0;)
    granule = 256 * granule + static_cast<unsigned char>(bytes.at(last + 6 + i));
  film.frames = (granule >> shift) + (granule & ((1 << shift) - 1));
  return film;
}

} // namespace

TEST_CASE("a film has its frames and rate, in the size of the picture that holds all of them") {
  auto const of = [](std::string const& more) { return field(R"(,"deformed":true)" + more); };
  auto const result = draw("film", of(R"(,"film":{"rate":4})"));
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  CHECK(result.messages.find("film/it.ogv") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(work / "film/it.png"));
  auto const film = film_of(work / "film/it.ogv");
  CHECK(film.rate == 4);
  CHECK(film.frames == 2);
  REQUIRE(draw("still", of(R"(,"time":0)")).code == 0);
  Image const still(work / "still/it.png");
  CHECK(film.width == still.width() + still.width() % 2);
  CHECK(film.height > still.height()); // the second frame reaches lower
  REQUIRE(draw("film", of("")).code == 0);
  CHECK_FALSE(std::filesystem::exists(work / "film/it.ogv")); // of an earlier run
  CHECK(
      draw("film", of(R"(,"film":{"frames":9})")).messages.find("has 2 frames, and a film of 9 is wanted") !=
      std::string::npos);
  CHECK(draw("film", of(R"(,"film":{},"time":0)")).messages.find("is not for a film") != std::string::npos);
  CHECK(draw("film", of(R"(,"film":{},"pdf":true)")).messages.find("leave out svg and pdf") !=
        std::string::npos);
  CHECK(draw("film", of(R"(,"film":{"rate":2.5})")).messages.find("a whole number is wanted") !=
        std::string::npos);
  auto const panel = R"({"name":"p","kind":"panel","figures":[)" + of(R"(,"film":{})") + "]}";
  CHECK(draw("film", panel).messages.find("is not for a part of a panel") != std::string::npos);
}
