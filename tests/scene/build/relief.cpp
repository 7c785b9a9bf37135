// Boundaries with heights: nodes where the map says, cells below them, what is said where that does not fit.
#include <doctest/doctest.h>

#include "mesh/gmsh/mesher_process.hpp"
#include "mesh/topology/quality.hpp"
#include "scene/complaints.hpp"
#include "scene/explain/explain.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

constexpr double tiny = 1e-14; // m, of bodies of 1 m

Input rough(double slope) {
  return make("surface.rough", {{"hurst", value(0.8)},
                                {"shortest", value(0.25, "m")},
                                {"rms_slope", value(slope)},
                                {"seed", value(3)}});
}

Input relief(std::string set, Input surface, std::vector<double> const& size,
             std::vector<double> const& points) {
  return make("relief", {{"set", text(std::move(set))},
                         {"surface", std::move(surface)},
                         {"size", values(size, "m")},
                         {"points", values(points)}});
}

/// foot_on_floor whose top, at y = 1, is rough.
Input rough_foot(char const* kind = "quad4", double slope = 0.05) {
  auto table = foot_on_floor();
  at(table, "bodies.foot.mesh.cells") = values({16, 4});
  at(table, "bodies.foot.mesh.kind") = text(kind);
  at(table, "bodies.foot.relief") = relief("top", rough(slope), {1}, {16});
  return table;
}

/// A cube, its face `set` rough; nothing else.
Input cube(char const* kind, char const* set) {
  auto scene = make("scene");
  at(scene, "kinematics") = text("three_dimensional");
  at(scene, "bodies.foot") = make("body", {{"mesh", make("mesh.box", {{"origin", values({0, 0, 0}, "m")},
                                                                      {"size", values({1, 1, 1}, "m")},
                                                                      {"cells", values({4, 3, 2})},
                                                                      {"kind", text(kind)}})},
                                           {"material", linear_elastic(1000, 0)},
                                           {"density", value(1, "kg/m^3")},
                                           {"relief", relief(set, rough(0.05), {1, 1}, {16, 16})}});
  at(scene, "motions") = list({fix("foot.bottom"), fix("foot.top")});
  at(scene, "scheme") = quasi_static();
  at(scene, "schedule") = schedule({{1, 1}});
  return scene;
}

Input without_relief(Input table) {
  remove(table, "bodies.foot.relief");
  return table;
}

mesh::Mesh mesh_of(Input const& table) {
  return scene::build(table).model->bodies.at(0)->mesh;
}

/// A rigid map of the relief's surface, size and points.
contact::RigidHeights rigid(Input table, std::vector<double> const& point,
                            std::vector<double> const& normal) {
  auto shape = at(table, "bodies.foot.relief");
  shape.tag = "rigid.height_map";
  remove(shape, "set");
  remove(shape, "depth");
  at(shape, "point") = values(point, "m");
  at(shape, "normal") = values(normal);
  auto scene = without_relief(std::move(table));
  at(scene, "obstacles.twin.shape") = std::move(shape);
  auto const built = scene::build(scene);
  for (auto const& body : built.model->rigids)
    if (body.name == "twin")
      return std::get<contact::RigidHeights>(body.shape);
  throw std::logic_error("no twin");
}

/// Largest distance of nodes from where they belong, m: nodes of the flat mesh, moved along the map's normal
/// by its height there times a share that falls from 1 in its plane to 0 at `depth`.
double misplaced(Input const& table, contact::RigidHeights const& map, double depth = 1) {
  auto const made = mesh_of(table), as_made = mesh_of(without_relief(table));
  double most = 0;
  for (Index i = 0; i < made.node_count(); ++i) {
    contact::Vec3 X = contact::Vec3::Zero();
    X.head(made.dim) = as_made.nodes.row(i).transpose();
    auto local = map.prepared->local(X);
    if (map.boundary == contact::RigidHeights::Rim::free) // past the rim as there
      for (int k = 0; k + 1 < made.dim; ++k)
        local[k] = std::min(std::max(local[k], 0.0), map.size[ix(k)]);
    double const share = std::max(0.0, 1 + local.z() / depth);
    double const height = map.prepared->field.at(local.x(), made.dim == 2 ? 0 : local.y()).h;
    contact::Vec3 const wanted = X + share * height * map.prepared->axes.col(2);
    most = std::max(most, (made.nodes.row(i).transpose() - wanted.head(made.dim)).norm());
  }
  return most;
}

/// Of a plane mesh of quad4, m^2.
double area(mesh::Mesh const& mesh) {
  double twice = 0;
  auto const& nodes = mesh.blocks.at(0).nodes;
  for (std::size_t first = 0; first < nodes.size(); first += 4)
    for (std::size_t k = 0; k < 4; ++k) {
      auto const p = mesh.nodes.row(nodes[first + k]), q = mesh.nodes.row(nodes[first + (k + 1) % 4]);
      twice += p[0] * q[1] - p[1] * q[0];
    }
  return 0.5 * twice;
}

/// One complaint of the scene, at this key of the relief ("" is itself), that holds these words.
bool refused(Input const& table, std::string const& key, std::string const& words) {
  auto const all = complaints(table);
  std::string const place = "bodies.foot.relief" + (key.empty() ? "" : "." + key) + ": ";
  bool const one =
      all.size() == 1 && all[0].find(place) != std::string::npos && all[0].find(words) != std::string::npos;
  if (!one)
    for (auto const& text : all)
      MESSAGE(text);
  return one;
}

} // namespace

TEST_SUITE("scene") {
  TEST_CASE("nodes of a relief lie where a rigid map of the same surface does, those below in proportion") {
    for (char const* kind : {"quad4", "quad8", "tri3", "tri6"}) {
      INFO(kind);
      auto const table = rough_foot(kind);
      CHECK(misplaced(table, rigid(table, {0.5, 1}, {0, 1})) < tiny);
      CHECK(misplaced(table, rigid(table, {0.5, 1}, {0, -1})) > 1e-3); // as it should be seen
    }
    auto const relief = scene::build(rough_foot()).reliefs.at("foot");
    CHECK(relief.least >= 0);
    CHECK(relief.most > 0.01);
    CHECK(relief.spacing == doctest::Approx(1.0 / 16));
    CHECK(scene::build(rough_foot("quad8")).reliefs.at("foot").spacing == doctest::Approx(1.0 / 32));
  }

  TEST_CASE("reliefs lie in space, on any face") {
    for (char const* kind : {"hex8", "hex20", "tet4", "tet10"}) {
      INFO(kind);
      CHECK(misplaced(cube(kind, "top"), rigid(cube(kind, "top"), {0.5, 0.5, 1}, {0, 0, 1})) < tiny);
    }
    CHECK(misplaced(cube("hex8", "bottom"), rigid(cube("hex8", "bottom"), {0.5, 0.5, 0}, {0, 0, -1})) < tiny);
    CHECK(misplaced(cube("hex20", "left"), rigid(cube("hex20", "left"), {0, 0.5, 0.5}, {-1, 0, 0})) < tiny);
    auto turned = cube("hex8", "right");
    at(turned, "bodies.foot.relief.along") = values({0, 1, 2});
    CHECK(misplaced(turned, rigid(turned, {1, 0.5, 0.5}, {1, 0, 0})) < tiny);
    auto shifted = cube("tet10", "top");
    at(shifted, "bodies.foot.relief.point") = values({0.2, 0.9, 5}, "m");
    CHECK(misplaced(shifted, rigid(shifted, {0.2, 0.9, 1}, {0, 0, 1})) < tiny);
  }

  TEST_CASE("a block loses its mean height times its area, whatever the depth") {
    for (double const depth : {0.0, 0.25, 0.4}) {
      auto table = rough_foot();
      at(table, "bodies.foot.relief.depth") = value(depth, "m");
      auto const made = mesh_of(table);
      double mean = 0;
      for (Index const node : made.sets.at("top").nodes) {
        auto const X = made.nodes.row(node);
        mean += (1 - X[1]) / 16 * (X[0] == 0 || X[0] == 1 ? 0.5 : 1);
      }
      CHECK(mean > 0.01);
      CHECK(area(made) == doctest::Approx(1 - mean).epsilon(tiny));
      if (depth > 0)
        CHECK(misplaced(table, rigid(table, {0.5, 1}, {0, 1}), depth) < tiny);
    }
  }

  TEST_CASE("a sloping boundary of a mesh of gmsh has its relief along its normal") {
    if (mesh::find_mesher().empty()) {
      MESSAGE("the mesher was not built: nothing tested");
      return;
    }
    auto table = rough_foot();
    for (char const* part : {"pairs", "obstacles"}) // the bottom is no nearer than the far corner, and moves
      remove(table, part);
    auto const edge = [](double x, double y, char const* name) {
      return make("edge", {{"to", values({x, y}, "m")}, {"name", text(name)}});
    };
    at(table, "bodies.foot.mesh") =
        make("mesh.gmsh", {{"start", values({0, 0}, "m")},
                           {"size", value(0.1, "m")},
                           {"kind", text("tri6")},
                           {"edges", list({edge(1, 0, "bottom"), edge(1, 1.75, "right"), edge(0, 1, "top"),
                                           edge(0, 0, "left")})}});
    at(table, "bodies.foot.relief.size") = values({1.25}, "m");
    at(table, "bodies.foot.relief.surface.shortest") = value(0.3, "m");
    // 1.4 m below the slope lies the corner at (1, 0)
    for (char const* boundary : {"periodic", "free"}) { // the corner at the origin lies 0.6 m past the rim
      INFO(boundary);
      at(table, "bodies.foot.relief.boundary") = text(boundary);
      CHECK(misplaced(table, rigid(table, {0.5, 1.375}, {-0.6, 0.8}), 1.4) < 10 * tiny);
    }
  }

  TEST_CASE("maps that end cover their boundary, and go on past it as at their rim") {
    auto table = rough_foot();
    at(table, "bodies.foot.relief.boundary") = text("free");
    CHECK(misplaced(table, rigid(table, {0.5, 1}, {0, 1})) < tiny);
    at(table, "bodies.foot.relief.size") = values({0.9}, "m");
    CHECK(refused(table, "size", "has 0.9 m along the map's x, and the boundary goes on for 0.05 m past it"));
    at(table, "bodies.foot.relief.point") = values({0.55, 1}, "m");
    CHECK(refused(table, "size", "goes on for 0.1 m past it; give a map that covers it, or boundary = "));
    at(table, "bodies.foot.relief.boundary") = text("periodic");
    CHECK(complaints(table).empty());
    auto wide = cube("hex8", "top");
    at(wide, "bodies.foot.relief.boundary") = text("free");
    at(wide, "bodies.foot.relief.size") = values({1, 0.5}, "m");
    CHECK(refused(wide, "size", "has 0.5 m along the map's y, and the boundary goes on for 0.25 m past it"));
  }

  TEST_CASE("reliefs that cannot be made are refused in one sentence each") {
    auto table = rough_foot();
    at(table, "bodies.foot.relief.set") = text("topp");
    CHECK(
        refused(table, "set",
                "there is no boundary \"topp\"; known are bottom, left, right, top; did you mean \"top\"?"));
    table = rough_foot();
    at(table, "kinematics") = text("axisymmetric");
    CHECK(refused(table, "", "heights are not the same all around an axis"));
    table = rough_foot("quad4", 2.0);
    at(table, "bodies.foot.relief.depth") = value(0.25, "m");
    CHECK(refused(table, "", "fold cells over within a depth of 0.25 m: the smallest scaled Jacobian is -"));
    table = rough_foot();
    at(table, "bodies.foot.relief.depth") = value(1.5, "m");
    CHECK(refused(table, "depth", "is 1.5 m, and the body is 1 m thick below \"top\""));
    table = rough_foot();
    at(table, "bodies.foot.relief.points") = values({3});
    CHECK(refused(table, "", "points has 3; give whole numbers in [4, 2048]"));
    table = rough_foot();
    at(table, "bodies.foot.relief.surface.shortest") = value(0.01, "m");
    CHECK(refused(table, "surface.shortest", "m"));
    table = rough_foot();
    at(table, "bodies.foot.relief.surface") = make("surface.map", {{"heights", values({1, 2})}});
    CHECK(refused(table, "surface", "has 2 heights; there are 16 points (16 x 1)"));
    table = rough_foot();
    remove(table, "bodies.foot.relief.surface");
    CHECK(refused(table, "surface", "is missing"));
    table = cube("hex8", "top");
    at(table, "bodies.foot.relief.along") = values({0, 0, 1});
    CHECK(refused(table, "", "along is the normal; give a direction across it"));
    auto disc = foot_on_floor();
    at(disc, "bodies.foot") = half_disc(1, 0.2, linear_elastic(1000, 0));
    at(disc, "bodies.foot.relief") = relief("arc", rough(0.05), {2}, {32});
    CHECK(refused(disc, "set", "\"arc\" is not plane: along its mean normal its nodes lie up to"));
  }

  TEST_CASE("explain tells of a relief, and where nodes do not show all of it") {
    auto const warned = [](Input const& table) {
      std::string all;
      for (auto const& warning : scene::explain(table).warnings)
        if (warning.text.find("relief") != std::string::npos)
          all += warning.text + " -> " + warning.change;
      return all;
    };
    auto table = rough_foot();
    CHECK(warned(table) ==
          "body foot: nodes of top are up to 62.5 mm apart, and its relief has waves down to 250 mm, 4 "
          "nodes (< 8) to each: they do not show all of it -> cells of top with nodes 31.2 mm apart, "
          "or a larger `shortest`");
    CHECK(warned(rough_foot("quad8")).empty());
    at(table, "bodies.foot.relief.surface") =
        make("surface.map", {{"heights", values(std::vector<double>(16, 0.01))}});
    CHECK(warned(table).empty());
    at(table, "bodies.foot.relief.surface.heights") = values(std::vector<double>(32, 0.01));
    at(table, "bodies.foot.relief.points") = values({32});
    CHECK(warned(table) ==
          "body foot: nodes of top are up to 62.5 mm apart, and its relief has a height every 31.2 "
          "mm: they do not show all of it -> cells of top with nodes 31.2 mm apart, or a map of "
          "fewer points");
    at(table, "bodies.foot.relief.surface") =
        make("surface.wave", {{"amplitude", value(0.01, "m")}, {"wavelengths", values({0.4}, "m")}});
    CHECK(warned(table).find("waves down to 400 mm, 6.4 nodes (< 8) to each") != std::string::npos);
    at(table, "bodies.foot.relief.surface.wavelengths") = values({0.5}, "m");
    CHECK(warned(table).empty());
    at(table, "bodies.foot.relief.surface") = make("surface.cylinder", {{"radius", value(10, "m")}});
    at(table, "bodies.foot.relief.boundary") = text("free");
    CHECK(warned(table).empty());
    std::string told;
    for (auto const& section : scene::explain(table).sections)
      for (auto const& line : section.lines)
        told += section.title + "|" + line.name + "|" + line.words + "\n";
    CHECK(told.find("Body foot|relief|relief{set = \"top\", size = {1 m}, points = {32}") !=
          std::string::npos);
    CHECK(told.find("Body foot|surface|surface.cylinder{radius = 10 m") != std::string::npos);
    CHECK(told.find(" to 12.5 mm at its nodes, up to 62.5 mm apart") != std::string::npos);
  }
}
