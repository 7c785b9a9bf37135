// Pressures read at every contact point: uniform and linear ones in plane, section and space, for every kind
// of cell and both discretisations.
#include <doctest/doctest.h>
#include <numbers>

#include "dynamics/space.hpp"

using namespace stiction;

namespace {

/// A pressed block, its kinematics, kind of cells and discretisation.
struct Case {
  std::string kinematics, kind, method;
  [[nodiscard]] bool space() const { return kinematics == "three_dimensional"; }
  [[nodiscard]] bool section() const { return kinematics == "axisymmetric"; }
  [[nodiscard]] bool quadratic() const {
    return kind == "quad8" || kind == "tri6" || kind == "hex20" || kind == "tet10";
  }
  [[nodiscard]] bool mortar() const { return method == "mortar"; }
  [[nodiscard]] std::string name() const { return kinematics + " " + kind + " " + method; }
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (std::string const method : {"node_to_segment", "mortar"}) {
    for (std::string const kinematics : {"plane_strain", "axisymmetric"})
      for (std::string const kind : {"quad4", "tri3", "quad8", "tri6"})
        all.push_back({kinematics, kind, method});
    for (std::string const kind : {"hex8", "tet4", "hex20", "tet10"})
      all.push_back({"three_dimensional", kind, method});
  }
  return all;
}

constexpr double young = 1000, width = 2; // Pa, m

/// A block of 3 (by 2) cells on the floor, 2 m wide and `height` high, nu = 0, all of it driven but for the
/// normal component of its sole.
test::Input block_on_floor(Case const& c, double height) {
  auto table = c.space() ? test::space() : test::make("scene");
  auto const material = test::linear_elastic(young, 0);
  test::at(table, "bodies.foot") = c.space()
                                       ? test::box({{0, 0, 0}, {width, width, height}, {3, 2, 1}}, material)
                                       : test::block({{0, 0}, {width, height}, {3, 1}}, material);
  test::at(table, "bodies.foot.mesh.kind") = test::text(c.kind);
  test::at(table, "kinematics") = test::text(c.kinematics);
  test::at(table, "obstacles.floor") = test::floor();
  test::at(table, "pairs.sole") = test::pair("foot.bottom", "floor");
  test::at(table, "pairs.sole.discretisation") = test::text(c.method);
  test::at(table, "motions") = test::list({test::fix("foot.top")}); // until each test has its own
  if (c.space())
    test::at(table, "motions") = test::list({test::fix_in("foot.top", "xyz")});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

/// The scene without the motions that hold it.
scene::Scene released(test::Input const& table) {
  auto scene = scene::build(table);
  scene.model->motions.clear();
  return scene;
}

/// Drives a node's component to a value in a second.
void lead(scene::Scene& scene, Index node, int component, double value) {
  scene.model->motions.push_back({{node}, component, {{0, 1}, {0, value}}});
}

/// The pressure wanted at X, Pa.
using Pressure = std::function<double(contact::Vec3 const&)>;

contact::Vec3 position(scene::Scene const& scene, Index node) {
  contact::Vec3 X = contact::Vec3::Zero();
  X.head(scene.model->dim()) = scene.model->reference.row(node).transpose();
  return X;
}

/// The strain -p(X) / E across a layer so thin that it cannot carry shear: the sole bears p.
test::State press_layer(scene::Scene& scene, Pressure const& pressure) {
  int const last = scene.model->dim() - 1;
  for (Index node = 0; node < scene.model->first_node.back(); ++node) {
    auto const X = position(scene, node);
    for (int c = 0; c < last; ++c)
      lead(scene, node, c, 0);
    if (X[last] > 0)
      lead(scene, node, last, -pressure(X) / young * X[last]);
  }
  scene.model->control.force_tolerance = 1e-12;
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), 1, 1);
}

/// Calls check(X, state of the point) for all contact points.
template<class Check> void each_point(scene::Scene const& scene, test::State const& state, Check&& check) {
  auto const& pair = scene.model->pairs[0];
  for (std::size_t i = 0; i < pair.secondary.size(); ++i)
    check(position(scene, pair.secondary[i]), state.contacts[0][i]);
}

/// Areas sum to the sole's, tractions times areas to the force on it.
void check_sums(scene::Scene const& scene, test::State const& state, double whole, double force,
                double error = 1e-9) {
  double area = 0, along = 0;
  each_point(scene, state, [&](auto const&, auto const& point) {
    CHECK(point.area > 0);
    area += point.area;
    along += point.area * point.dry[0];
  });
  CHECK(area == doctest::Approx(whole).epsilon(1e-12));
  CHECK(along == doctest::Approx(force).epsilon(error));
  int const last = scene.model->dim() - 1;
  CHECK(test::contact_on(scene, state)[last] == doctest::Approx(force).epsilon(error));
  CHECK(-state.on_rigid[0].force[last] == doctest::Approx(force).epsilon(error));
}

double area_of(Case const& c) {
  return c.space() ? width * width : c.section() ? std::numbers::pi * width * width : width;
}

/// Height of a layer that hardly carries shear, and how exactly it does not; triangles must not be so flat,
/// and three points of quadrature are too few for a linear stress times r.
struct Layer {
  double height = 1e-6, error = 1e-8; // m, relative
  explicit Layer(Case const& c) {
    if (c.kind == "tri6" || c.kind == "tet10")
      height = 0.01, error = c.section() ? 1e-2 : 5e-4;
  }
};

} // namespace

TEST_CASE("pressures: a uniform one is read at every point, on axis, rim and corners") {
  for (auto const& c : cases()) {
    INFO(c.name());
    auto scene = released(block_on_floor(c, 1));
    auto const state = press_layer(scene, [](auto const&) { return 10.0; });
    each_point(scene, state, [](auto const& X, auto const& point) {
      INFO("at ", X.x(), " ", X.y());
      CHECK(point.dry[0] == doctest::Approx(10).epsilon(1e-10));
    });
    check_sums(scene, state, area_of(c), 10 * area_of(c));
  }
}

/// Where on the axis x a point reads a pressure that is linear in x, edges being h long: the centroid of what
/// it stands for, which differs from X by the order of h on borders and of h^2 / r about the axis.
double reads_at(Case const& c, double x, double h) {
  bool const first = x<1e-9, last = x> width - 1e-9, middle = std::lround(2 * x / h) % 2 == 1;
  if (c.mortar() || (c.quadratic() && !c.section()))
    return x;
  if (c.quadratic())
    return first ? h / 5 : middle ? x + h * h / (20 * x) : x - h * h / (10 * x);
  if (c.section())
    return first  ? h / 2
           : last ? (x * x / 2 - x * h / 3 + h * h / 12) / (x / 2 - h / 6)
                  : x + h * h / (6 * x);
  return first ? h / 3 : last ? x - h / 3 : x;
}

TEST_CASE("pressures: a linear one is read where each point stands for it") {
  for (auto const& c : cases()) {
    if (c.kind == "tri3" || c.kind == "tet4") // whose strains are constant
      continue;
    INFO(c.name());
    Layer const layer(c);
    auto scene = released(block_on_floor(c, layer.height));
    double const slope_y = c.space() ? 2 : 0, h = width / 3, h_y = width / 2;
    auto const pressure = [&](contact::Vec3 const& X) { return 10 + 3 * X.x() + slope_y * X.y(); };
    auto const state = press_layer(scene, pressure);
    bool const borrowed = c.space() && c.quadratic() && !c.mortar();
    each_point(scene, state, [&](contact::Vec3 const& X, auto const& point) {
      INFO("at ", X.x(), " ", X.y());
      contact::Vec3 const at(reads_at(c, X.x(), h), c.space() ? reads_at(c, X.y(), h_y) : 0, 0);
      bool const inside = at.x() > 0.1 && at.x() < width - 0.1 && at.y() > 0.1 && at.y() < width - 0.1;
      if (!borrowed || (inside && c.kind == "hex20")) // on an even mesh
        CHECK(point.dry[0] == doctest::Approx(pressure(at)).epsilon(layer.error));
      else // within half a facet
        CHECK(std::abs(point.dry[0] - pressure(X)) < 0.5 * (3 * h + 2 * h_y));
    });
    double const mean_x = c.section() ? 2 * width / 3 : width / 2;
    check_sums(scene, state, area_of(c), area_of(c) * pressure({mean_x, width / 2, 0}), layer.error);
  }
}

/// Integral of the function of the point at x of an even row, edges being h long, times 2 pi x in a section:
/// hats, or the functions of quadratic edges, of which the axis gets an eighth of its middle's.
double stands_for(Case const& c, double x, double h) {
  bool const first = x<1e-9, last = x> width - 1e-9, middle = std::lround(2 * x / h) % 2 == 1;
  double const turn = 2 * std::numbers::pi;
  if (c.quadratic() && !c.mortar()) {
    double const line = h / 6 * (middle ? 4 : first || last ? 1 : 2);
    if (!c.section())
      return line;
    return first ? turn * h * h / 24 : middle && x < h ? turn * h * h * 7 / 24 : turn * x * line;
  }
  if (!c.section())
    return first || last ? h / 2 : h;
  return first ? turn * h * h / 6 : turn * (last ? x * h / 2 - h * h / 6 : x * h);
}

TEST_CASE("pressures: areas are the integrals of the points' functions") {
  for (auto const& c : cases()) {
    if (c.kind == "tet4" || c.kind == "tet10" || (c.kind == "hex20" && !c.mortar()))
      continue; // in mesh/topology/hats.cpp
    INFO(c.name());
    auto scene = released(block_on_floor(c, 1));
    auto const state = press_layer(scene, [](auto const&) { return 10.0; });
    auto const& pair = scene.model->pairs[0];
    for (std::size_t i = 0; i < pair.areas.size(); ++i) {
      auto const X = position(scene, pair.secondary[i]);
      INFO("at ", X.x(), " ", X.y());
      double const expected =
          stands_for(c, X.x(), width / 3) * (c.space() ? stands_for(c, X.y(), width / 2) : 1);
      CHECK(pair.areas[i] == doctest::Approx(expected).epsilon(1e-12));
      CHECK(state.contacts[0][i].area == doctest::Approx(expected).epsilon(1e-12));
    }
  }
}

/// Bending without Poisson's ratio: u_z = -(e + a x + b y) z, u_x = a z^2 / 2, u_y = b z^2 / 2 is of second
/// order, so that quadratic cells solve it exactly.
TEST_CASE("pressures: under a bent block quadratic cells read the linear pressure to rounding") {
  for (auto const& c : cases()) {
    if (!c.quadratic() || c.section() || (c.space() && !c.mortar()))
      continue;
    INFO(c.name());
    auto scene = released(block_on_floor(c, 1));
    int const last = scene.model->dim() - 1;
    contact::Vec3 const slope(0.003, c.space() ? 0.002 : 0, 0);
    auto const strain = [&](contact::Vec3 const& X) { return 0.01 + slope.dot(X) - slope[last] * X[last]; };
    for (Index node = 0; node < scene.model->first_node.back(); ++node) {
      auto const X = position(scene, node);
      if (X[last] < 1 - 1e-9)
        continue;
      for (int k = 0; k < last; ++k)
        lead(scene, node, k, slope[k] / 2);
      lead(scene, node, last, -strain(X));
    }
    scene.model->control.force_tolerance = 1e-12;
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 1, 1);
    each_point(scene, state, [&](contact::Vec3 const& X, auto const& point) {
      INFO("at ", X.x(), " ", X.y());
      CHECK(point.dry[0] == doctest::Approx(young * strain(X)).epsilon(1e-9));
    });
  }
}

TEST_CASE("pressures: friction and bonds act on the traction that is read, at every point alike") {
  for (auto const& c : cases()) {
    if (c.section())
      continue;
    INFO(c.name());
    auto table = block_on_floor(c, 1);
    test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
    auto scene = released(table);
    int const last = scene.model->dim() - 1;
    for (Index node = 0; node < scene.model->first_node.back(); ++node) {
      auto const X = position(scene, node);
      for (int k = 0; k < last; ++k)
        lead(scene, node, k, k == 0 ? 0.06 : 0.08);
      if (X[last] > 0)
        lead(scene, node, last, -0.01 * X[last]);
    }
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 1, 1);
    double const x = c.space() ? 0.6 : 1, y = c.space() ? 0.8 : 0;
    each_point(scene, state, [&](auto const&, auto const& point) {
      CHECK(point.status == interface::Status::slip);
      CHECK(point.dry[0] == doctest::Approx(10).epsilon(1e-7));
      CHECK(std::abs(point.dry[1]) == doctest::Approx(3 * x).epsilon(1e-7));
      CHECK(std::abs(point.dry[2]) == doctest::Approx(3 * y).epsilon(1e-7));
    });
    check_sums(scene, state, area_of(c), 10 * area_of(c));
  }
}

/// C u beta^2 at every point of a sole lifted by u < u0, whole bonds.
TEST_CASE("pressures: bonds hold by their area, on axis and corners too") {
  for (auto const& c : cases()) {
    INFO(c.name());
    auto table = block_on_floor(c, 1);
    auto adhesion = test::rcc(1, 1000, 1);
    test::at(adhesion, "beta0") = test::value(1);
    test::at(adhesion, "bonding") = test::text("never");
    test::at(table, "pairs.sole.adhesion") = adhesion;
    auto scene = released(table);
    int const last = scene.model->dim() - 1;
    for (Index node = 0; node < scene.model->first_node.back(); ++node)
      for (int k = 0; k <= last; ++k)
        lead(scene, node, k, k == last ? 0.001 : 0);
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 1, 1);
    double force = 0;
    each_point(scene, state, [&](auto const&, auto const& point) {
      CHECK(point.gap == doctest::Approx(0.001).epsilon(1e-10));
      CHECK(point.bond.beta == doctest::Approx(1).epsilon(1e-12));
      CHECK(point.adhesion[0] == doctest::Approx(-1).epsilon(1e-9));
      force += point.area * point.adhesion[0];
    });
    CHECK(force == doctest::Approx(-area_of(c)).epsilon(1e-9));
    CHECK(test::contact_on(scene, state)[last] == doctest::Approx(-area_of(c)).epsilon(1e-9));
    CHECK(state.ledger.bond == doctest::Approx(area_of(c) * (0.5e-3 - 1)).epsilon(1e-9));
  }
}

TEST_CASE("pressures: under rates a moving obstacle is seen by all nodes behind a point") {
  for (auto const& c : cases()) {
    INFO(c.name());
    auto table = block_on_floor(c, 1);
    test::at(table, "scheme") = test::make("scheme.moreau_jean");
    test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
    std::string const up = c.space() ? "z" : "y";
    test::at(table, "obstacles.floor.times") = test::values({0, 1}, "s");
    test::at(table, "obstacles.floor." + up) = test::values({-0.05, -0.03}, "m");
    if (!c.section())
      test::at(table, "obstacles.floor.x") = test::values({0, 0.01}, "m");
    auto const scene = released(table);
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 1e-3, 1);
    each_point(scene, state, [&](auto const&, auto const& point) {
      CHECK(point.rate[0] == doctest::Approx(-0.02).epsilon(1e-9));
      CHECK(std::abs(point.rate[1]) == doctest::Approx(c.section() ? 0 : 0.01).epsilon(1e-9));
    });
  }
}
