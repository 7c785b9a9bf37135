// Rows of points that are means over nodes, where cells have nodes at mid-sides.
#include <doctest/doctest.h>

#include "differences.hpp"
#include "dynamics/contact/contact_geometry.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using dynamics::ContactGeometry;

namespace {

/// The kinematics of all points of the first pair at u.
std::vector<contact::PointKinematics<3>> seen_at(ContactGeometry<3>& geometry, dynamics::State const& old,
                                                 Vector const& u) {
  geometry.locate(u);
  auto const count = static_cast<int>(old.contacts[0].size());
  for (int i = 0; i < count; ++i)
    geometry.see({0, i}, old.contacts[0][ix(i)].foot);
  geometry.settle();
  std::vector<contact::PointKinematics<3>> all;
  for (int i = 0; i < count; ++i)
    all.push_back(geometry.kinematics({0, i}, old.contacts[0][ix(i)].foot));
  return all;
}

/// The upper body moves by `way` in a step: are rows and changes the derivative of gaps and slips?
void check_means(test::Input const& table, contact::Vec3 const& way) {
  auto const scene = scene::build(table);
  auto const& model = *scene.model;
  dynamics::Stepper stepper(model);
  auto const old = stepper.initial();
  ContactGeometry<3> geometry(model);
  geometry.begin(old, 1);
  REQUIRE(geometry.shared(0));
  Vector u = old.u;
  for (Index node = 0; node < model.node_count(); ++node) // bent
    u[3 * node + 2] =
        0.05 * std::sin(2 * model.reference.data()[3 * node] + model.reference.data()[3 * node + 1]);
  for (Index node = model.first_node[model.first_node.size() - 2]; node < model.first_node.back(); ++node)
    u.segment<3>(3 * node) += way + 0.002 * contact::Vec3(node % 3, node % 5, node % 2);
  auto const points = seen_at(geometry, old, u);
  Dense rows = Dense::Zero(3 * static_cast<Index>(points.size()), u.size());
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    REQUIRE(points[i].found);
    Index const row = 3 * static_cast<Index>(i);
    auto const add = [&](Indices const& nodes, Eigen::Ref<Dense const> const& block) {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        rows.block<3, 3>(row, 3 * nodes[k]) += block.middleCols<3>(3 * static_cast<Index>(k));
    };
    add(points[i].nodes, points[i].H.leftCols(points[i].unknowns()));
    geometry.change({0, static_cast<int>(i)}, points[i], [&](Indices const& nodes, auto const& change) {
      largest = std::max(largest, change.cwiseAbs().maxCoeff());
      add(nodes, change);
    });
  }
  CHECK(largest > 0.01);
  auto const moves = [&](Vector const& at) {
    Vector all(rows.rows());
    Index row = 0;
    for (auto const& point : seen_at(geometry, old, at)) {
      all.segment<3>(row) << point.gap, point.slip;
      row += 3;
    }
    return all;
  };
  test::check_rate(test::rate(moves, rows, u, 1e-4, 3), "motion");
}

test::Input hex20_over(char const* counterpart) {
  auto table = test::space();
  auto const material = test::linear_elastic(1000, 0.3);
  test::at(table, "bodies.lower") = test::box({{-0.5, -0.5, -1}, {2, 2, 1}, {3, 3, 1}}, material);
  test::at(table, "bodies.upper") = test::box({{0, 0, 0.02}, {1, 1, 1}, {1, 1, 1}}, material);
  test::at(table, "bodies.upper.mesh.kind") = test::text("hex20");
  test::at(table, "pairs.joint") = test::pair("upper.bottom", counterpart);
  test::at(table, "motions") =
      test::list({test::fix_in("lower.bottom", "xyz"), test::fix_in("upper.top", "xyz")});
  return table;
}

} // namespace

TEST_CASE("means over nodes: rows and their changes are the derivative of gap and slip in space") {
  auto on_ball = hex20_over("ball");
  test::at(on_ball, "obstacles.ball.shape") = test::make(
      "rigid.sphere", {{"centre", test::values({0.4, 0.7, -3}, "m")}, {"radius", test::value(3, "m")}});
  check_means(on_ball, {0.3, -0.2, -0.02});
  check_means(hex20_over("lower.top"), {0.3, -0.2, 0});
}
