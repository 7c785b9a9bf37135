// Which scenes obstacles fit, and what is said when they do not.
#include "contact/obstacles.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

bool says(std::string const& text, std::initializer_list<char const*> words) {
  for (auto const* word : words)
    if (text.find(word) == std::string::npos)
      return false;
  return true;
}

RigidPolyline line(core::Numbers points, bool closed = false) {
  return {std::move(points), closed, Smoothing::spline, {}};
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("obstacles fit the scenes they have a form in") {
    for (bool const axisymmetric : {false, true}) {
      CHECK(unfit(Obstacle{RigidPlane{}}, 2, axisymmetric).empty());
      CHECK(unfit(Obstacle{RigidCircle{{1, 2}, 3}}, 2, axisymmetric).empty());
      CHECK(unfit(Obstacle{RigidSphere{{0, 2}, 3}}, 2, axisymmetric).empty());
      CHECK(unfit(Obstacle{line({0, 0, 1, 0})}, 2, axisymmetric).empty());
    }
    CHECK(unfit(Obstacle{RigidPlane{{1, 2, 3}, {0, 0, -1}}}, 3, false).empty());
    CHECK(unfit(Obstacle{RigidSphere{{1, 2, 3}, 4}}, 3, false).empty());
    CHECK(unfit(Obstacle{RigidCylinder{{1, 2, 3}, {1, 0, 0}, 4}}, 3, false).empty());
    CHECK(unfit(Obstacle{RigidTorus{{1, 2, 3}, {1, 0, 0}, 4, 1}}, 3, false).empty());
    CHECK(unfit(Obstacle{RigidSurface{"stamp.msh", 1, {}}}, 3, false).empty());
    CHECK(unfit(Obstacle{RigidTorus{{0, 2}, {0, -1}, 4, 1}}, 2, true).empty());
    CHECK(unfit(Obstacle{RigidSphere{{1, 2}, 3}}, 2, false).empty());
  }

  TEST_CASE("a shape without a form in the scene names the one to use") {
    CHECK(says(unfit(Obstacle{RigidCircle{{}, 1}}, 3, false), {"sphere", "cylinder"}));
    CHECK(says(unfit(Obstacle{RigidCylinder{{}, {}, 1}}, 2, false), {"3D", "circle"}));
    CHECK(says(unfit(Obstacle{RigidCylinder{{}, {}, 1}}, 2, true), {"3D", "plane", "{1, 0}"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{}, {}, 2, 1}}, 2, false), {"3D", "axisymmetry", "circle"}));
    CHECK(says(unfit(Obstacle{line({0, 0, 1, 0})}, 3, false), {"plane", "surface"}));
    CHECK(says(unfit(Obstacle{RigidSurface{"stamp.obj", 1, {}}}, 3, false), {"stamp.obj", ".stl", ".msh"}));
    CHECK(says(unfit(Obstacle{RigidSurface{"stamp.msh", 1, {}}}, 2, false), {"3D", "polyline"}));
  }

  TEST_CASE("components that are too few or too many are counted") {
    CHECK(says(unfit(Obstacle{RigidPlane{{1, 2}, {}}}, 3, false), {"point", "has 2", "give 3"}));
    CHECK(says(unfit(Obstacle{RigidPlane{{}, {1, 2, 3}}}, 2, false), {"normal", "has 3", "give 2"}));
    CHECK(says(unfit(Obstacle{RigidCircle{{1}, 1}}, 2, false), {"centre", "has 1", "give 2"}));
    CHECK(says(unfit(Obstacle{RigidSphere{{1, 2}, 1}}, 3, false), {"centre", "has 2", "give 3"}));
    CHECK(says(unfit(Obstacle{RigidCylinder{{1}, {}, 1}}, 3, false), {"centre", "has 1"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{}, {0, 1}, 2, 1}}, 3, false), {"axis", "has 2"}));
    CHECK(says(unfit(Obstacle{line({0, 0, 1})}, 2, false), {"3 numbers", "even"}));
    CHECK(says(unfit(Obstacle{line({0, 0})}, 2, false), {"points is {0, 0}", "at least 2 points"}));
    CHECK(says(unfit(Obstacle{line({0, 0, 1, 0}, true)}, 2, false), {"{0, 0, 1, 0}", "at least 3 points"}));
  }

  TEST_CASE("directions that vanish and sizes that contradict each other are refused") {
    CHECK(says(unfit(Obstacle{RigidPlane{{}, {0, 0}}}, 2, false), {"normal is {0, 0}"}));
    CHECK(says(unfit(Obstacle{RigidCylinder{{}, {0, 0, 0}, 1}}, 3, false), {"axis is {0, 0, 0}"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{}, {0, 0, 0}, 2, 1}}, 3, false), {"axis is {0, 0, 0}"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{}, {}, 1, 2}}, 3, false), {"minor_radius is 2", "is 1 m"}));
    CHECK(says(unfit(Obstacle{line({0, 0, 1, 0, 1, 0})}, 2, false), {"points 2 and 3"}));
    CHECK(says(unfit(Obstacle{line({0, 0, 1, 0, 1, 1, 0, 0}, true)}, 2, false), {"points 4 and 1"}));
  }

  TEST_CASE("round shapes in axisymmetry sit on the axis") {
    CHECK(says(unfit(Obstacle{RigidSphere{{1, 0}, 1}}, 2, true), {"centre is {1, 0}", "torus"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{1, 0}, {}, 2, 1}}, 2, true), {"centre is {1, 0}", "x = 0"}));
    CHECK(says(unfit(Obstacle{RigidTorus{{}, {1, 0}, 2, 1}}, 2, true), {"axis is {1, 0}", "{0, 1}"}));
  }
}
