// Reading every generator from a script's table.
#include <doctest/doctest.h>

#include "core/reader.hpp"
#include "mesh/helpers.hpp"
#include "mesh/source/source.hpp"

using namespace stiction;
using namespace stiction::mesh;
using core::Input;

namespace {

Input metres(double value) {
  return {core::Quantity{value, {1, 0, 0}}, "study.lua:1", ""};
}
Input pair(double x, double y) {
  return {core::List{metres(x), metres(y)}, "study.lua:1", ""};
}
Input words(std::string text) {
  return {std::move(text), "study.lua:1", ""};
}
Input made(std::string tag, core::Table table) {
  return {std::move(table), "study.lua:1", std::move(tag)};
}
Input edge(double x, double y, std::string name) {
  return made("", {{"to", pair(x, y)}, {"name", words(std::move(name))}});
}

Generator read(Input const& input, core::Complaints& complaints) {
  return core::Reader(input, "mesh", complaints).alternative<Generator>();
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("a half disc is read from a table and made") {
    core::Complaints complaints;
    auto const generator = read(
        made("mesh.half_disc", {{"radius", metres(5e-3)}, {"size", metres(1e-3)}, {"kind", words("quad8")}}),
        complaints);
    CHECK(complaints.empty());
    CHECK(make(generator).blocks.at(0).kind == CellKind::quad8);
  }

  TEST_CASE("a block's numbers arrive where they belong") {
    core::Complaints complaints;
    core::List const cells{{core::Quantity{3, {}}, "", ""}, {core::Quantity{2, {}}, "", ""}};
    auto const generator =
        read(made("mesh.block", {{"origin", pair(1, 2)}, {"size", pair(3, 4)}, {"cells", {cells, "", ""}}}),
             complaints);
    CHECK(complaints.empty());
    Mesh const mesh = make(generator);
    CHECK(mesh.cell_count() == 6);
    CHECK(mesh.nodes.row(mesh.node_count() - 1) == Eigen::RowVector2d(4, 6));
  }

  TEST_CASE("a box and a half ball read their kinds and a kind of the plane is refused") {
    core::Complaints complaints;
    core::List const cells{
        {core::Quantity{1, {}}, "", ""}, {core::Quantity{2, {}}, "", ""}, {core::Quantity{3, {}}, "", ""}};
    core::Table table{{"size", {core::List{metres(1), metres(1), metres(1)}, "", ""}},
                      {"cells", {cells, "", ""}},
                      {"kind", words("hex20")}};
    Mesh const mesh = make(read(made("mesh.box", table), complaints));
    CHECK(complaints.empty());
    CHECK(mesh.cell_count() == 6);
    CHECK(mesh.blocks.at(0).kind == CellKind::hex20);

    auto const generator = read(made("mesh.half_ball", {{"radius", metres(1)},
                                                        {"fine", pair(0.5, 0.2)},
                                                        {"fine_size", metres(0.2)},
                                                        {"coarse_size", metres(0.5)},
                                                        {"part", words("half")},
                                                        {"kind", words("tet10")}}),
                                complaints);
    CHECK(complaints.empty());
    CHECK(std::get<HalfBallOptions>(generator).part == Part::half);
    CHECK(make(generator).blocks.at(0).kind == CellKind::tet10);

    table["kind"] = words("quad4");
    (void)read(made("mesh.box", table), complaints);
    REQUIRE(complaints.size() == 1);
    CHECK(test::mentions(complaints[0].message(), "hex8"));
    CHECK_FALSE(test::mentions(complaints[0].message(), "tri3"));
  }

  TEST_CASE("the default of a kind is named among those that may be chosen") {
    for (auto const& schema : generator_schemas())
      for (std::size_t i = 0; i < schema.parameters.size(); ++i)
        if (auto const& names = schema.parameters[i].choices; !names.empty())
          CHECK(std::find(names.begin(), names.end(), std::get<std::string>(schema.fallback(i))) !=
                names.end());
  }

  TEST_CASE("a gmsh geometry reads its nested lists, and misspelt keys in them are complained about") {
    core::Complaints complaints;
    core::List const edges{edge(1, 0, "bottom"), edge(1, 1, ""), edge(0, 0, "")};
    core::List const refine{
        made("", {{"near", words("bottom")}, {"size", metres(0.1)}, {"beyond", metres(1)}})};
    core::Table table{{"size", metres(0.5)},
                      {"start", pair(0, 0)},
                      {"edges", {edges, "", ""}},
                      {"refine", {refine, "", ""}}};
    auto const generator = read(made("mesh.gmsh", table), complaints);
    CHECK(complaints.empty());
    auto const& geometry = std::get<GmshGeometry>(generator);
    REQUIRE(geometry.edges.size() == 3);
    CHECK(geometry.edges[0].name == "bottom");
    CHECK(geometry.refine.at(0).until == 1);

    core::List const wrong{made("", {{"too", pair(1, 0)}})};
    table["edges"] = {wrong, "", ""};
    (void)read(made("mesh.gmsh", table), complaints);
    REQUIRE(complaints.size() == 2);
    CHECK(complaints[1].path == "mesh.edges[1].too");
  }

  TEST_CASE("every generator is described") {
    for (auto const& schema : generator_schemas())
      for (auto const& parameter : schema.parameters)
        CHECK_FALSE(parameter.meaning.empty());
  }
}
