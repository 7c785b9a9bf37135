// The error of recovered stress: none of a uniform state, of first order in the cell size of a bent one, and
// nearly the error itself.
#include "solid/stress_error.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <doctest/doctest.h>

#include "mesh/generators/generators.hpp"

using namespace stiction;

namespace {

/// Relative error on n by n cells of the unit square under the displacement u(x, y).
template<class Field> double relative(Index n, Field&& u) {
  mesh::BlockOptions options;
  options.origin = {0, 0};
  options.size = {1, 1};
  options.cells = {static_cast<double>(n), static_cast<double>(n)};
  material::LinearElastic law;
  law.young = 1000;
  law.poisson = 0.3;
  solid::Body const body{"body", mesh::block(options), law, 1};
  std::vector<double> values;
  for (Eigen::Index i = 0; i < body.mesh.nodes.rows(); ++i) {
    auto const at = u(body.mesh.nodes(i, 0), body.mesh.nodes(i, 1));
    values.insert(values.end(), {at[0], at[1]});
  }
  auto const error = solid::stress_error(body, solid::Kinematics::plane_strain, values);
  REQUIRE(error.error.size() == static_cast<std::size_t>(n * n));
  double volume = 0;
  for (double const part : error.volume)
    volume += part;
  CHECK(volume == doctest::Approx(1));
  return error.relative();
}

/// Relative error of a square or cube, bent and sheared, the whole turned by an angle about z, rad.
double turned(int dim, double angle) {
  mesh::Mesh mesh;
  if (dim == 2) {
    mesh::BlockOptions options;
    options.size = {1, 1};
    options.cells = {4, 4};
    mesh = mesh::block(options);
  } else {
    mesh::BoxOptions options;
    options.size = {1, 1, 1};
    options.cells = {3, 3, 3};
    mesh = mesh::box(options);
  }
  material::LinearElastic law;
  law.young = 1000;
  law.poisson = 0.3;
  Dense const turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  std::vector<double> values;
  for (Eigen::Index i = 0; i < mesh.nodes.rows(); ++i) {
    double const x = mesh.nodes(i, 0), y = mesh.nodes(i, 1);
    Eigen::Vector3d u(1e-3 * x * y, -0.5e-3 * x * x, dim == 3 ? 2e-3 * x * x * y : 0);
    u.head<2>() = (turn * u.head<2>()).eval();
    values.insert(values.end(), u.data(), u.data() + dim);
    mesh.nodes.row(i).head<2>() = (turn * Eigen::Vector2d(x, y)).transpose();
  }
  solid::Body const body{"body", mesh, law, 1};
  auto const kinematics = dim == 2 ? solid::Kinematics::plane_strain : solid::Kinematics::three_dimensional;
  return solid::stress_error(body, kinematics, values).relative();
}

} // namespace

TEST_CASE("a uniform stress is recovered without error") {
  CHECK(relative(4, [](double x, double y) {
          return std::array<double, 2>{1e-3 * x + 2e-3 * y, -1e-3 * y};
        }) < 1e-12);
}

TEST_CASE("the error of a bent square falls with the size of its cells") {
  auto const bent = [](double x, double y) { return std::array<double, 2>{1e-3 * x * y, -0.5e-3 * x * x}; };
  double last = relative(4, bent);
  CHECK(last > 0.05);
  for (Index const n : {8, 16, 32}) {
    double const error = relative(n, bent);
    CHECK(std::log2(last / error) == doctest::Approx(1).epsilon(0.25));
    last = error;
  }
}

TEST_CASE("the error does not depend on the frame: shear counts twice, as in the square of a tensor") {
  for (int const dim : {2, 3}) {
    CAPTURE(dim);
    double const upright = turned(dim, 0), aslant = turned(dim, 0.6);
    CHECK(upright > 0.05);
    CHECK(aslant == doctest::Approx(upright).epsilon(1e-10));
  }
}

TEST_CASE("of a stress that jumps from one sign to the other between two cells half is error") {
  auto const folded = [](double x, double) { return std::array<double, 2>{1e-3 * std::abs(x - 0.5), 0}; };
  // recovered: a line through 0, of mean square 1/3, as that of its distance from the jump
  CHECK(relative(2, folded) == doctest::Approx(std::sqrt(0.5)).epsilon(1e-10));
}

TEST_CASE("the error that is thought of a bent square comes to the error itself") {
  // eps = {y, 0, 0} in thousandths: the stress goes with y, and the mean of a cell of height 1 / n misses it
  // by 1 / sqrt(12) / n at most, of a root mean square of 1 / sqrt(3)
  auto const bent = [](double x, double y) { return std::array<double, 2>{1e-3 * x * y, -0.5e-3 * x * x}; };
  for (Index const n : {16, 32, 64}) {
    double const exact = 0.5 / static_cast<double>(n);
    CAPTURE(n);
    CHECK(relative(n, bent) / exact == doctest::Approx(1).epsilon(2.0 / static_cast<double>(n)));
  }
}
