// Kelvin-Voigt damping: its power, its matrix, and what it leaves alone.
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include "differences.hpp"
#include "solid/helpers.hpp"

using namespace stiction;
using namespace stiction::test;
using solid::Body;
using solid::Cells;

namespace {

Body damped(Case const& each, material::Material const& law, material::KelvinVoigt const& damping) {
  Body body = each.body(law, 1);
  body.damping = damping;
  return body;
}

Vector damping_force(Cells const& cells, Vector const& u, Vector const& v) {
  Vector f = Vector::Zero(u.size());
  static_cast<void>(cells.add_damping(view(u), view(v), view(f)));
  return f;
}

/// A(u), kg/s.
Dense damping_matrix(Cells const& cells, Vector const& u, int dim) {
  return assembled(cells, static_cast<Index>(u.size()), dim, [&](auto const& map, std::span<double> values) {
    cells.add_damping_stiffness(view(u), 1, map, values);
  });
}

constexpr material::KelvinVoigt sample{30, 50};

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("damping: A is the derivative of the force by v and symmetric and semidefinite and its power is "
            "v.A v") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = damped(each, law, sample);
      Cells const cells(body, each.kinematics);
      Vector const u = random_vector(each.dim() * body.mesh.node_count(), 0.03);
      Vector const v = random_vector(u.size(), 1, 12);
      Vector f = Vector::Zero(u.size());
      double const power = cells.add_damping(view(u), view(v), view(f));
      Dense const A = damping_matrix(cells, u, each.dim());
      CHECK((f - A * v).norm() <= 1e-13 * f.norm());
      CHECK(power == doctest::Approx(f.dot(v)).epsilon(1e-12));
      CHECK(power > 0);
      Dense const columns = jacobian([&](Vector const& at) { return damping_force(cells, u, at); }, v, 1.0);
      CHECK((columns - A).norm() <= 1e-12 * A.norm()); // linear in v
      auto const eigenvalues = Eigen::SelfAdjointEigenSolver<Dense>(A, Eigen::EigenvaluesOnly).eigenvalues();
      CHECK(eigenvalues.minCoeff() >= -1e-13 * eigenvalues.maxCoeff());
    });
  }

  TEST_CASE("damping: a deformed body that turns or moves as a whole dissipates nothing") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = damped(each, law, sample);
      Cells const cells(body, each.kinematics);
      Vector const X = nodal(body.mesh, [](Point const& at) { return at; });
      Vector const u = small_strain(law) ? Vector::Zero(X.size()).eval() : random_vector(X.size(), 0.03);
      Point const spin = each.axisymmetric() ? Point::Zero().eval()
                         : each.dim() == 3   ? Point(0.4, -1, 2)
                                             : Point(0, 0, 2);
      Point const drift = each.axisymmetric() ? Point(0, 3, 0) : Point(1, 3, -2);
      Vector v = Vector::Zero(X.size());
      for (Index node = 0; node < body.mesh.node_count(); ++node)
        add_at_node(v, node, each.dim(), drift + spin.cross(at_node(X + u, node, each.dim())));
      double const scale = damping_matrix(cells, u, each.dim()).norm();
      CHECK(damping_force(cells, u, v).norm() <= 1e-13 * scale * v.norm());
    });
  }

  TEST_CASE("damping: homogeneous rates dissipate 2 eta dev:dev + zeta tr^2 per volume") {
    each_case([](Case const& each) {
      Matrix3 rate = Matrix3::Zero();
      rate.diagonal() << 0.3, -0.5, each.dim() == 3 ? 0.4 : 0.0;
      if (each.axisymmetric())
        rate(2, 2) = 0.3;
      else
        rate(0, 1) = 0.2;
      Body const body = damped(each, material::LinearElastic{1e6, 0.3}, sample);
      Cells const cells(body, each.kinematics);
      Vector const v = nodal(body.mesh, [&](Point const& X) { return rate * X; });
      Vector f = Vector::Zero(v.size());
      Matrix3 const strain = (rate + rate.transpose()) / 2;
      Matrix3 const dev = strain - strain.trace() / 3 * Matrix3::Identity();
      double const volume = each.axisymmetric() ? std::acos(-1.0) * 12 : 3;
      double const exact = volume * (2 * sample.shear_viscosity * dev.squaredNorm() +
                                     sample.bulk_viscosity * strain.trace() * strain.trace());
      CHECK(cells.add_damping(view(f), view(v), view(f)) == doctest::Approx(exact).epsilon(1e-12));
    });
  }

  TEST_CASE("damping: viscosities equal to the moduli make its matrix the stiffness at rest") {
    Case const each{mesh::CellKind::quad8, Kinematics::plane_strain, solid::Interpolation::plain};
    double const young = 1e3, poisson = 0.3;
    material::Moduli const moduli{young, poisson};
    Body const body =
        damped(each, material::StVenantKirchhoff{young, poisson}, {moduli.shear(), moduli.bulk()});
    Cells const cells(body, each.kinematics);
    Vector const zero = Vector::Zero(2 * body.mesh.node_count());
    Dense const K = stiffness(cells, zero, 2);
    CHECK((damping_matrix(cells, zero, 2) - K).norm() <= 1e-14 * K.norm());
  }

  TEST_CASE("damping: a body without it is left alone") {
    Case const each{mesh::CellKind::hex8, Kinematics::three_dimensional, solid::Interpolation::plain};
    Body const body = each.body(material::BlatzKo{1e6}, 1);
    Cells const cells(body, each.kinematics);
    CHECK(!cells.damped());
    Vector const v = random_vector(3 * body.mesh.node_count(), 1);
    Vector f = Vector::Zero(v.size());
    CHECK(cells.add_damping(view(f), view(v), view(f)) == 0);
    CHECK(f.isZero(0));
    CHECK(damping_matrix(cells, f, 3).isZero(0));
  }
}
