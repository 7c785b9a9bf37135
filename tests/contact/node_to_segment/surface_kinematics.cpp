// Surfaces in space: rows of H, geometric stiffness by differences, rigid motions, balance, frames.
#include <doctest/doctest.h>

#include "contact/surfaces.hpp"
#include "differences.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A surface and a point whose foot is well inside a facet, on an edge or at a vertex.
struct Case {
  Shell shell;
  Vec3 point;
  FootFeature::Kind kind = FootFeature::face;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (bool const triangles : {false, true}) {
    for (auto const& point : {Vec3(0.43, 0.52, 0.1), Vec3(0.31, 0.66, -0.03), Vec3(0.03, 0.05, 0.08)})
      all.push_back({waves(5, triangles), point});
    auto const box = cube(2, triangles).shake(0.03);
    all.push_back({box, {1.2, 0.4, 1.3}, FootFeature::edge});
    all.push_back({box, {1.2, 1.3, 1.25}, FootFeature::vertex});
    all.push_back({box, {1.2, 0.3, 0.45}});
    all.push_back({ball(4, triangles), {0.7, -0.8, 0.35}});
  }
  return all;
}

Vec3 at(std::vector<double> const& x, Index node) {
  return {x[ix(3 * node)], x[ix(3 * node + 1)], x[ix(3 * node + 2)]};
}

/// Adds a move of the point's own unknowns to all positions.
std::vector<double> moved(std::vector<double> x, PointKinematics<3> const& point, Vector const& move) {
  for (int k = 0; k < point.unknowns(); ++k)
    x[ix(3 * point.nodes[ix(k / 3)] + k % 3)] += move[k];
  return x;
}

std::vector<double> carried(std::vector<double> x, Mat<3> const& turn, Vec3 const& shift) {
  for (std::size_t i = 0; i < x.size(); i += 3) {
    Vec3 const v = turn * Vec3(x[i], x[i + 1], x[i + 2]) + shift;
    std::copy(v.data(), v.data() + 3, x.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return x;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("in space the geometric stiffness is the derivative of the forces by all positions") {
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface({1, 0.3, 0.2});
      auto const x = c.shell.with(c.point);
      auto const point = kinematics(surface, c.shell.free_node(), {}, {}, x);
      REQUIRE(point.found);
      REQUIRE(FootFeature::of(point.foot).kind == c.kind);
      CAPTURE(c.point.transpose());
      CAPTURE(point.count);
      for (auto const& force : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(2, -3, 0.5)}) {
        auto const forces = [&](Vector const& m) {
          auto const k = kinematics(surface, c.shell.free_node(), {}, point.foot, moved(x, point, m));
          return Vector(k.H.transpose() * force);
        };
        Block<3> const K = geometric_stiffness(surface, point, x, force);
        check_rate(rate(forces, Dense(K), Vector::Zero(point.unknowns()), 1e-3, 1), "stiffness");
      }
      // nothing else takes part
      auto const before = point.H;
      std::vector<double> elsewhere = x;
      for (Index node = 0; node < c.shell.free_node(); ++node)
        if (std::find(point.nodes.begin(), point.nodes.begin() + point.count, node) ==
            point.nodes.begin() + point.count)
          elsewhere[ix(3 * node)] += 0.01;
      CHECK((kinematics(surface, c.shell.free_node(), {}, point.foot, elsewhere).H - before).isZero(1e-12));
    }
  }

  TEST_CASE("frame, slip and forces go on across sides and vertices of facets") {
    for (bool const triangles : {false, true})
      for (double const gap : {-0.01, 0.0, 0.06}) {
        auto const shell = waves(5, triangles);
        auto const surface = shell.surface({1, 0.3, 0.2});
        // stretched by position, so that facets are strained differently
        auto const moved_to = [&](Vec3 const& point) {
          auto x = shell.with(point);
          for (Index node = 0; node < shell.free_node(); ++node)
            for (int c = 0; c < 2; ++c)
              x[ix(3 * node + c)] *= 1 + 0.2 * std::sin(3.0 * node + c);
          return x;
        };
        auto const still = moved_to(Vec3::Zero());
        for (int f = 0; f < surface.size(); ++f)
          for (int k = 0; k < surface.facets()[ix(f)].count; ++k)
            for (double const part : {0.0, 0.3}) { // a node, a point of a side
              auto const& facet = surface.facets()[ix(f)];
              int const other = facet.neighbour[ix(k)];
              if (other < 0)
                continue;
              Vec2 const here = side_coordinates(facet.count, k, part),
                         there = side_coordinates(surface.facets()[ix(other)].count, facet.across[ix(k)],
                                                  1 - part);
              auto const at_foot = surface.evaluate({f, here.x(), here.y()}, still);
              auto const x = moved_to(at_foot.x + gap * at_foot.normal);
              auto const a = kinematics(surface, shell.free_node(), {f, 0.2, 0.2}, {f, here.x(), here.y()},
                                        x),
                         b = kinematics(surface, shell.free_node(), {f, 0.2, 0.2},
                                        {other, there.x(), there.y()}, x);
              REQUIRE((a.found && b.found));
              CHECK((a.frame - b.frame).norm() < 1e-12);
              CHECK((a.slip - b.slip).norm() < 1e-12);
              Dense H = Dense::Zero(3, static_cast<Index>(x.size()));
              for (int j = 0; j < a.count; ++j)
                H.middleCols<3>(3 * a.nodes[ix(j)]) += a.H.middleCols<3>(3 * j);
              for (int j = 0; j < b.count; ++j)
                H.middleCols<3>(3 * b.nodes[ix(j)]) -= b.H.middleCols<3>(3 * j);
              CHECK(H.cwiseAbs().maxCoeff() < 1e-11);
            }
      }
  }

  TEST_CASE("along the normal the gap grows as its row says, whatever the surface") {
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface();
      auto const point = kinematics(surface, c.shell.free_node(), {}, {}, c.shell.with(c.point));
      auto const gap = [&](Vector const& s) {
        return Vector::Constant(1, kinematics(surface, c.shell.free_node(), {}, point.foot,
                                              c.shell.with(c.point + s[0] * point.normal()))
                                       .gap)
            .eval();
      };
      Vec3 const n = point.normal();
      Dense const slope = point.H.block<1, 3>(0, 0) * n;
      CHECK(slope(0, 0) == doctest::Approx(1));
      CHECK((jacobian(gap, Vector::Zero(1), 1e-3) - slope).cwiseAbs().maxCoeff() < 1e-10);
    }
  }

  TEST_CASE("on a flat facet among flat ones the rows are the derivatives of gap and slip") {
    Mat<3> const turn = turned({0.4, -0.7, 0.3});
    for (bool const triangles : {false, true}) {
      auto const shell = sheet(6, triangles).move([&](Vec3 const& v) { return Vec3(turn * v); });
      auto const surface = shell.surface();
      Vec3 const position = turn * Vec3(0.37, 0.55, 0.0);
      auto const x = shell.with(position);
      auto const point = kinematics(surface, shell.free_node(), {}, {}, x);
      auto const after = [&](Vector const& m) {
        auto const k = kinematics(surface, shell.free_node(), point.foot, point.foot, moved(x, point, m));
        return Vector(Vec3(k.gap, k.slip[0], k.slip[1]));
      };
      check_rate(rate(after, Dense(point.H), Vector::Zero(point.unknowns()), 1e-4, 1), "rows");
    }
  }

  TEST_CASE("on the surface the slip rows are the derivatives of the slip that starts there") {
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface();
      if (c.kind != FootFeature::face)
        continue;
      auto x = c.shell.with(c.point);
      auto const above = kinematics(surface, c.shell.free_node(), {}, {}, x);
      x = c.shell.with(surface.position(above.foot, x));
      auto const point = kinematics(surface, c.shell.free_node(), {}, above.foot, x);
      CHECK(std::abs(point.gap) < 1e-12);
      auto const slip = [&](Vector const& m) {
        return Vector(
            kinematics(surface, c.shell.free_node(), point.foot, point.foot, moved(x, point, m)).slip);
      };
      Dense const rows = point.H.bottomRows(2);
      CHECK(slip(Vector::Zero(point.unknowns())).norm() < 1e-12);
      check_rate(rate(slip, rows, Vector::Zero(point.unknowns()), 1e-4, 1), "slip");
    }
  }

  TEST_CASE("in space a rigid motion changes neither gap nor slip and turns frame and forces") {
    Mat<3> const turn = turned({1.1, -0.4, 2.0});
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface();
      auto const x = c.shell.with(c.point), y = carried(x, turn, {3, -2, 5});
      auto const before = kinematics(surface, c.shell.free_node(), {}, {}, x);
      Foot const start{before.foot.segment, before.foot.xi * 0.9 + 0.02, before.foot.eta * 0.95 + 0.01};
      auto const one = kinematics(surface, c.shell.free_node(), start, {}, x);
      auto const two = kinematics(surface, c.shell.free_node(), start, one.foot, y);
      REQUIRE(two.found);
      CHECK(two.gap == doctest::Approx(one.gap).epsilon(1e-9));
      CHECK(one.slip.norm() > 1e-4);
      CHECK((two.slip - one.slip).norm() < 1e-10);
      CHECK((two.frame - turn * one.frame).norm() < 1e-9);
      for (int k = 0; k < one.count; ++k)
        CHECK((two.H.middleCols<3>(3 * k) - one.H.middleCols<3>(3 * k) * turn.transpose()).norm() < 1e-9);
    }
  }

  TEST_CASE("in space the rows do no work in rigid motions: forces and moments balance") {
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface();
      auto const x = c.shell.with(c.point);
      auto const point = kinematics(surface, c.shell.free_node(), {}, {}, x);
      CHECK(std::abs(point.gap) > 0.003); // moments need a lever
      for (int row = 0; row < 3; ++row) {
        Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
        for (int k = 0; k < point.count; ++k) {
          Vec3 const f = point.H.block<1, 3>(row, 3 * k).transpose();
          force += f;
          moment += at(x, point.nodes[ix(k)]).cross(f);
        }
        CHECK(force.norm() < 1e-13);
        CHECK(moment.norm() < 1e-12);
      }
      CHECK((point.H.leftCols<3>() - point.frame.transpose()).norm() < 1e-13);
    }
  }

  TEST_CASE("the frame is right-handed and its first tangent follows the material") {
    for (auto const& c : cases()) {
      auto const surface = c.shell.surface({1, 0.3, 0.2});
      auto const point = kinematics(surface, c.shell.free_node(), {}, {}, c.shell.with(c.point));
      Vec3 const n = point.frame.col(0), t1 = point.frame.col(1), t2 = point.frame.col(2);
      CHECK((t1.cross(t2) - n).norm() < 1e-13);
      CHECK(std::abs(t1.dot(n)) < 1e-13);
    }
    auto shell = sheet(4, false);
    auto const surface = shell.surface({1, 0, 0});
    shell.move([](Vec3 const& v) { return Vec3(v.x(), v.y() + 0.5 * v.x(), v.z()); }); // simple shear
    auto const sheared = kinematics(surface, shell.free_node(), {}, {}, shell.with({0.4, 0.6, 0.1}));
    CHECK((sheared.frame.col(1) - Vec3(1, 0.5, 0).normalized()).norm() < 1e-13);
    auto const upright = sheet(4, true).surface({0, 0, 2}); // along the normal: the next axis instead
    auto const point = kinematics(upright, 25, {}, {}, sheet(4, true).with({0.4, 0.6, 0.1}));
    CHECK((point.frame.col(1) - Vec3(1, 0, 0)).norm() < 1e-13);
  }

  TEST_CASE("slip on a sheet is the path of the foot along the tangents") {
    auto const shell = sheet(7, true);
    auto const surface = shell.surface({0, 1, 0});
    auto const start = kinematics(surface, shell.free_node(), {}, {}, shell.with({0.2, 0.3, 0.05}));
    CHECK(start.slip.norm() == 0);
    auto const end =
        kinematics(surface, shell.free_node(), start.foot, start.foot, shell.with({0.7, 0.6, -0.01}));
    CHECK(end.gap == doctest::Approx(-0.01));
    CHECK(end.slip[0] == doctest::Approx(0.3));  // t1 = y
    CHECK(end.slip[1] == doctest::Approx(-0.5)); // t2 = n x t1 = -x
  }
}
