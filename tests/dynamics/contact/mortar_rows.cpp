// Mortar rows and stiffness on bent surfaces of all cell kinds: areas, balance, rigid motions, rates.
#include <doctest/doctest.h>
#include <numbers>
#include <random>

#include "differences.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using contact::Local;
using contact::Mat;
using contact::Mortar;
using contact::Vec;

namespace {

/// A mortar pair of two blocks one on the other, cells 3 and 4 across, bent and shaken by a little.
template<int D> struct Bent {
  scene::Scene scene;
  dynamics::Pair const* pair;
  Mortar<D> mortar;
  std::vector<double> x;

  explicit Bent(test::Input const& table)
      : scene(scene::build(table)), pair(scene.model->pairs.data()),
        mortar(*pair->mortar, &std::get<contact::CellSurface>(pair->primary), {pair->secondary, 1, false}) {
    auto const& reference = scene.model->reference;
    x.assign(reference.data(), reference.data() + reference.size());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-0.01, 0.01);
    for (std::size_t i = 0; i < x.size(); i += D) {
      double const r = D == 3 ? x[i + 1] : 0;
      x[i + D - 1] += 0.08 * std::cos(3 * x[i]) + 0.06 * std::sin(2 * r + x[i]);
      for (std::size_t c = 0; c < D; ++c)
        x[i + c] += uniform(random);
    }
    mortar.begin(x, nullptr);
    mortar.locate(x, nullptr);
  }
  [[nodiscard]] std::vector<Local<D>> forces() const {
    std::vector<Local<D>> all;
    for (Index i = 0; i < pair->size(); ++i)
      all.emplace_back(Local<D>::Constant(0.3) + (1.0 + 0.1 * i) * Local<D>::Unit(i % D));
    return all;
  }
  /// H^T forces over all unknowns, the samples held.
  [[nodiscard]] Vector nodal(Vector const& positions, std::vector<Local<D>> const& p) const {
    auto moved = mortar;
    moved.locate({positions.data(), ix(static_cast<Index>(positions.size()))}, nullptr);
    Vector f = Vector::Zero(positions.size());
    for (Index i = 0; i < pair->size(); ++i) {
      auto const& point = moved.point(i);
      if (!point.found)
        continue;
      for (int k = 0; k < point.count; ++k)
        f.segment<D>(D * point.nodes[ix(k)]) += point.H.template middleCols<D>(D * k).transpose() * p[ix(i)];
    }
    return f;
  }
  [[nodiscard]] Vector positions() const {
    return Eigen::Map<Vector const>(x.data(), static_cast<Index>(x.size()));
  }
};

test::Input blocks(char const* lower, char const* upper) {
  auto table = test::two_blocks();
  auto const material = test::linear_elastic(1000, 0.3);
  test::at(table, "bodies.lower") = test::block({{-0.5, -1}, {2, 1}, {5, 2}}, material);
  test::at(table, "bodies.upper") = test::block({{0, 0.05}, {1, 1}, {3, 2}}, material);
  test::at(table, "bodies.lower.mesh.kind") = test::text(lower);
  test::at(table, "bodies.upper.mesh.kind") = test::text(upper);
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  return table;
}

test::Input boxes(char const* lower, char const* upper) {
  auto table = test::space();
  auto const material = test::linear_elastic(1000, 0.3);
  test::at(table, "bodies.lower") = test::box({{-0.3, -0.3, -1}, {1.6, 1.6, 1}, {3, 3, 1}}, material);
  test::at(table, "bodies.upper") = test::box({{0, 0, 0.05}, {1, 1, 1}, {2, 2, 1}}, material);
  test::at(table, "bodies.lower.mesh.kind") = test::text(lower);
  test::at(table, "bodies.upper.mesh.kind") = test::text(upper);
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "lower.top");
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "motions") =
      test::list({test::fix_in("lower.bottom", "xyz"), test::fix_in("upper.top", "xyz")});
  return table;
}

/// The upper body moved by `way` along x since the samples were chosen.
template<int D> Bent<D> slid(Bent<D> bent, double way) {
  auto const& first = bent.scene.model->first_node;
  for (Index node = first[1]; node < first[2]; ++node)
    bent.x[ix(D * node)] += way;
  bent.mortar.locate(bent.x, nullptr);
  return bent;
}

template<int D> Vec<D> position(std::vector<double> const& x, Index node) {
  return Eigen::Map<Vec<D> const>(&x[ix(D * node)]);
}

template<int D> void check_areas(Bent<D> const& bent) {
  double sum = 0, all = 0;
  for (Index i = 0; i < bent.pair->size(); ++i) {
    CHECK(bent.mortar.area(i) == doctest::Approx(bent.pair->areas[ix(i)]).epsilon(1e-9));
    sum += bent.mortar.area(i);
    all += bent.pair->areas[ix(i)];
  }
  CHECK(sum == doctest::Approx(1).epsilon(1e-12));
  CHECK(all == doctest::Approx(1).epsilon(1e-12));
}

/// No row does work in a translation or a turn.
template<int D> void check_balance(Bent<D> const& bent) {
  for (Index i = 0; i < bent.pair->size(); ++i) {
    auto const& point = bent.mortar.point(i);
    REQUIRE(point.found);
    CHECK(point.gap > 0.01); // moments need a lever
    for (int row = 0; row < D; ++row) {
      contact::Vec3 force = contact::Vec3::Zero(), moment = contact::Vec3::Zero();
      for (int k = 0; k < point.count; ++k) {
        contact::Vec3 f = contact::Vec3::Zero(), at = contact::Vec3::Zero();
        f.head<D>() = point.H.template block<1, D>(row, D * k).transpose();
        at.head<D>() = position<D>(bent.x, point.nodes[ix(k)]);
        force += f;
        moment += at.cross(f);
      }
      CHECK(force.norm() < 1e-12);
      CHECK(moment.norm() < 1e-12);
    }
  }
}

template<int D> void check_rigid_motion(Bent<D> const& bent) {
  Mat<D> turn = Mat<D>::Identity();
  turn.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(0.9).toRotationMatrix();
  std::vector<double> y = bent.x;
  for (std::size_t i = 0; i < y.size(); i += D) {
    Vec<D> const to = turn * position<D>(bent.x, static_cast<Index>(i / D)) + Vec<D>::Constant(2);
    std::copy(to.data(), to.data() + D, &y[i]);
  }
  auto other = bent.mortar;
  other.begin(y, nullptr);
  other.locate(y, nullptr);
  for (Index i = 0; i < bent.pair->size(); ++i) {
    CHECK(other.point(i).gap == doctest::Approx(bent.mortar.point(i).gap).epsilon(1e-9));
    CHECK(other.point(i).slip.norm() < 1e-12);
    CHECK(other.area(i) == doctest::Approx(bent.mortar.area(i)).epsilon(1e-9));
  }
}

template<int D> void check_stiffness(Bent<D> const& bent) {
  auto const p = bent.forces();
  auto const [nodes, K] = bent.mortar.stiffness(p, bent.x);
  Vector const x = bent.positions();
  // only the unknowns named take part
  Dense full = Dense::Zero(x.size(), x.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      full.block<D, D>(D * nodes[i], D * nodes[j]) =
          K.template block<D, D>(D * static_cast<Index>(i), D * static_cast<Index>(j));
  auto const rate = test::rate([&](Vector const& y) { return bent.nodal(y, p); }, full, x, 1e-4, 3);
  CHECK_MESSAGE(rate.second_order, rate.words());
  CHECK(rate.errors[2] <= 1e-5 * rate.scale);
}

/// Gaps and slips of all points, the samples held; zero where nothing is found.
template<int D>
Vector measures(Mortar<D> mortar, Vector const& x, Index points, contact::PosedObstacle<D> const* obstacle) {
  mortar.locate({x.data(), ix(static_cast<Index>(x.size()))}, obstacle);
  Vector all = Vector::Zero(D * points);
  for (Index i = 0; i < points; ++i)
    if (auto const& point = mortar.point(i); point.found)
      all.segment<D>(D * i) << point.gap, point.slip;
  return all;
}

/// Rows and their changes are the derivative; the largest change is at least `least`.
template<int D>
void check_motion(Mortar<D> const& mortar, Vector const& x, Index points, double least,
                  contact::PosedObstacle<D> const* obstacle = nullptr) {
  Dense rows = Dense::Zero(D * points, x.size());
  double largest = 0;
  for (Index i = 0; i < points; ++i) {
    auto const& point = mortar.point(i);
    if (!point.found)
      continue;
    for (int k = 0; k < point.count; ++k)
      rows.block<D, D>(D * i, D * point.nodes[ix(k)]) += point.H.template middleCols<D>(D * k);
    auto const [nodes, change] = mortar.change(i, {x.data(), ix(static_cast<Index>(x.size()))});
    for (std::size_t k = 0; k < nodes.size(); ++k)
      rows.block<D, D>(D * i, D * nodes[k]) += change.template middleCols<D>(D * static_cast<Index>(k));
    largest = std::max(largest, change.size() > 0 ? change.cwiseAbs().maxCoeff() : 0.0);
  }
  CHECK(largest > least);
  auto const moves = [&](Vector const& y) { return measures<D>(mortar, y, points, obstacle); };
  test::check_rate(test::rate(moves, rows, x, 1e-4, 3), "motion");
}

template<int D> void check_motion(Bent<D> const& bent) {
  check_motion<D>(bent.mortar, bent.positions(), bent.pair->size(), 0.05);
}

/// A box on a ball or a drum, moved by `way` since the samples were chosen.
void check_motion_on(test::Input const& shape, contact::Vec3 const& way) {
  auto table = boxes("hex8", "hex20");
  test::remove(table, "bodies.lower");
  test::at(table, "motions") = test::list({test::fix_in("upper.top", "xyz")});
  test::at(table, "obstacles.ball.shape") = shape;
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "ball");
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  auto const scene = scene::build(table);
  auto const& model = *scene.model;
  auto const& pair = model.pairs[0];
  Mortar<3> mortar(*pair.mortar, nullptr, {pair.secondary, 1, false});
  contact::PosedObstacle<3> const ball{&model.rigids[0].shape, {}, contact::Vec3(1, 0.2, -0.3)};
  Vector x = Eigen::Map<Vector const>(model.reference.data(), model.dofs());
  mortar.begin({x.data(), ix(static_cast<Index>(x.size()))}, &ball);
  for (Index node = 0; node < x.size() / 3; ++node)
    x.segment<3>(3 * node) += way;
  mortar.locate({x.data(), ix(static_cast<Index>(x.size()))}, &ball);
  check_motion<3>(mortar, x, pair.size(), 0.02, &ball);
}

/// A plate above a drum of radius 2, whose samples go round it by `angle` while the plate turns with them.
template<int D> void check_round_a_drum(Bent<D> const& plain, double angle) {
  auto x = plain.x;
  auto const first = plain.scene.model->first_node[1];
  auto const& reference = plain.scene.model->reference;
  double const middle = 0.6, radius = 2;
  auto const bend = [&](double across, double height, double turned, double* at) {
    double const phi = (across - middle) / radius + turned, r = radius + height;
    at[0] = middle + r * std::sin(phi);
    at[D - 1] = r * std::cos(phi) - radius;
  };
  auto const put = [&](double turned) {
    for (Index node = 0; node < static_cast<Index>(x.size()) / D; ++node)
      bend(reference.data()[D * node], reference.data()[D * node + D - 1], node >= first ? turned : 0,
           &x[ix(D * node)]);
  };
  auto mortar = plain.mortar;
  put(0);
  mortar.begin(x, nullptr);
  put(angle);
  mortar.locate(x, nullptr);
  for (Index i = 0; i < plain.pair->size(); ++i) {
    REQUIRE(mortar.point(i).found);
    Vec<D> along = Vec<D>::Zero();
    for (int a = 1; a < D; ++a)
      along += mortar.point(i).slip[a - 1] * mortar.point(i).frame.col(a);
    // facets a tenth of a radius long: their chords are shorter than arcs by 4e-4 of them
    CHECK(along.norm() == doctest::Approx(radius * angle).epsilon(2e-3));
  }
}

} // namespace

TEST_CASE("mortar: areas add up and rows balance forces and moments on bent surfaces") {
  for (auto const& [lower, upper] : std::vector<std::pair<char const*, char const*>>{
           {"quad4", "quad4"}, {"quad8", "tri6"}, {"tri3", "quad8"}}) {
    Bent<2> const bent(blocks(lower, upper));
    check_areas(bent);
    check_balance(bent);
    check_rigid_motion(bent);
  }
  for (auto const& [lower, upper] : std::vector<std::pair<char const*, char const*>>{
           {"hex8", "hex8"}, {"tet4", "hex20"}, {"hex20", "tet10"}, {"tet10", "tet4"}}) {
    CAPTURE(std::string(lower));
    CAPTURE(std::string(upper));
    Bent<3> const bent(boxes(lower, upper));
    check_areas(bent);
    check_balance(bent);
    check_rigid_motion(bent);
  }
}

TEST_CASE("mortar: the stiffness is the derivative of the nodal forces") {
  check_stiffness(Bent<2>(blocks("quad4", "quad4")));
  check_stiffness(Bent<2>(blocks("quad8", "tri6")));
  check_stiffness(Bent<3>(boxes("hex8", "tet4")));
  check_stiffness(Bent<3>(boxes("tet10", "hex20")));
}

TEST_CASE("mortar: rows and their changes are the derivative of gap and slip, however long the way") {
  for (double const way : {0.0, 0.2}) {
    check_motion(slid(Bent<2>(blocks("quad4", "quad4")), way));
    check_motion(slid(Bent<2>(blocks("quad8", "tri6")), way));
    check_motion(slid(Bent<3>(boxes("hex8", "tet4")), way));
    check_motion(slid(Bent<3>(boxes("tet10", "hex20")), way));
  }
}

TEST_CASE("mortar: against obstacles in space, too") {
  auto const ball = test::make(
      "rigid.sphere", {{"centre", test::values({0.4, 0.7, -3}, "m")}, {"radius", test::value(3, "m")}});
  auto const drum = test::make("rigid.cylinder", {{"centre", test::values({0.5, 0.5, -2}, "m")},
                                                  {"axis", test::values({0.2, 1, 0.1}, "1")},
                                                  {"radius", test::value(2, "m")}});
  check_motion_on(ball, {0.4, -0.3, -0.02});
  check_motion_on(drum, {0.4, -0.3, -0.02});
}

TEST_CASE("mortar: slip round a drum is the arc") {
  auto plane = blocks("quad4", "quad4");
  test::at(plane, "bodies.lower") =
      test::block({{-0.5, -1}, {2.2, 1}, {22, 2}}, test::linear_elastic(1000, 0.3));
  test::at(plane, "bodies.upper") =
      test::block({{0.4, 0}, {0.4, 1}, {3, 2}}, test::linear_elastic(1000, 0.3));
  check_round_a_drum(Bent<2>(plane), 0.3);
  auto space = boxes("hex8", "hex8");
  test::at(space, "bodies.lower") =
      test::box({{-0.5, -0.1, -1}, {2.2, 0.6, 1}, {22, 2, 1}}, test::linear_elastic(1000, 0.3));
  test::at(space, "bodies.upper") =
      test::box({{0.4, 0, 0}, {0.4, 0.4, 1}, {3, 3, 1}}, test::linear_elastic(1000, 0.3));
  check_round_a_drum(Bent<3>(space), 0.3);
}

TEST_CASE("mortar: where samples have slid off an end the means are over those that are left") {
  auto const bent = slid(Bent<2>(blocks("quad4", "quad4")), 1.1);
  auto const& upper = bent.scene.model->first_node[1];
  int found = 0, lost = 0;
  for (Index i = 0; i < bent.pair->size(); ++i) {
    auto const& point = bent.mortar.point(i);
    ++(point.found ? found : lost);
    double own = 0; // of the row of the gap: how far it follows the upper body
    for (int k = 0; k < point.count; ++k)
      own += point.nodes[ix(k)] >= upper ? point.H(0, 2 * k + 1) : 0;
    CHECK((!point.found || std::abs(own) > 0.95));
  }
  CHECK(found > 1);
  CHECK(lost > 0);
  check_stiffness(bent);
}

TEST_CASE("mortar: a point's foot and frame are those of what it stands for most, which is next to it") {
  Bent<2> const bent(blocks("quad4", "quad4"));
  double const cell = 1.0 / 3;
  for (Index i = 0; i < bent.pair->size(); ++i) {
    auto const& point = bent.mortar.point(i);
    auto const& lower = std::get<contact::CellSurface>(bent.pair->primary);
    Vec<2> const foot = lower.positions<2>(point.foot.segment, bent.x) *
                        contact::facet_shape(lower.facet(point.foot.segment).kind, {point.foot.xi, 0}).N;
    CHECK(std::abs(foot.x() - position<2>(bent.x, bent.pair->secondary[ix(i)]).x()) < 0.4 * cell);
  }
}

TEST_CASE("mortar: areas on bodies of revolution are those of full turns") {
  auto table = blocks("quad4", "quad4");
  test::at(table, "kinematics") = test::text("axisymmetric");
  auto const material = test::linear_elastic(1000, 0.3);
  test::at(table, "bodies.lower") = test::block({{0, -1}, {2, 1}, {5, 2}}, material);
  test::at(table, "bodies.upper") = test::block({{0.5, 0}, {1, 1}, {3, 2}}, material);
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.25, 1);
  double sum = 0;
  for (auto const& point : state.contacts[0])
    sum += point.area;
  CHECK(sum == doctest::Approx(std::numbers::pi * (1.5 * 1.5 - 0.5 * 0.5)));
}

TEST_CASE("mortar: a point that faced nothing when the step began bears nothing in it") {
  auto table = blocks("quad4", "quad4");
  test::remove(table, "bodies.lower");
  test::at(table, "motions") = test::list({test::fix("upper.top")});
  test::at(table, "obstacles.edge.shape") =
      test::make("rigid.polyline", {{"points", test::values({0.5, 0, -3, 0}, "m")}});
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "edge");
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  auto const scene = scene::build(table);
  auto const& model = *scene.model;
  auto const& pair = model.pairs[0];
  Mortar<2> mortar(*pair.mortar, nullptr, {pair.secondary, 1, false});
  contact::PosedObstacle<2> const edge{&model.rigids[0].shape, contact::Pose<2>{}, contact::Vec3::UnitX()};
  std::vector<double> x(model.reference.data(), model.reference.data() + model.reference.size());
  mortar.begin(x, &edge); // from x = 0 to 1
  for (std::size_t i = 0; i < x.size(); i += 2)
    x[i] -= 0.6;
  mortar.locate(x, &edge);
  int bare = 0;
  for (Index i = 0; i < pair.size(); ++i) {
    bare += mortar.area(i) == 0 ? 1 : 0;
    CHECK(mortar.point(i).found == (mortar.area(i) > 0));
  }
  CHECK(bare > 0);
}
