// What every cell kind must do: patch test, tangent with its rate, objectivity, mass, inverted cells, no
// allocation.
#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <numbers>

#include "core/error.hpp"
#include "differences.hpp"
#include "solid/allocations.hpp"
#include "solid/helpers.hpp"

using namespace stiction;
using namespace stiction::test;
using solid::Body;
using solid::Cells;

namespace {

/// A homogeneous displacement gradient: what the kinematics admits of a full one.
Matrix3 gradient_of_patch(Kinematics kinematics, bool small) {
  Matrix3 H;
  H << 0.15, 0.3, 0.05, -0.1, -0.2, 0.12, 0.07, -0.04, 0.1;
  if (kinematics != Kinematics::three_dimensional) {
    H.row(2).setZero();
    H.col(2).setZero();
  }
  if (kinematics ==
      Kinematics::axisymmetric) { // constant stress needs equal radial and hoop stretch, no shear
    H(0, 1) = H(1, 0) = 0;
    H(2, 2) = H(0, 0);
  }
  return small ? Matrix3(1e-3 * H) : H;
}

/// Cauchy stress of the law at the homogeneous gradient H.
Matrix3 exact_stress(material::Material const& law, Matrix3 const& H) {
  Matrix3 const F = Matrix3::Identity() + H;
  return std::visit(
      [&](auto const& l) -> Matrix3 {
        if (std::decay_t<decltype(l)>::small_strain) {
          material::Voigt<6> strain;
          strain << H(0, 0), H(1, 1), H(2, 2), H(0, 1) + H(1, 0), H(1, 2) + H(2, 1), H(0, 2) + H(2, 0);
          return tensor(l.template respond<6>(strain).stress);
        }
        return F * tensor(l.template respond<6>(green<6>(F)).stress) * F.transpose() / F.determinant();
      },
      law);
}

/// H with the stretch across that leaves a sheet free of stress there, by halving what it lies in.
Matrix3 free_across(material::Material const& law, Matrix3 H) {
  double low = -0.9, high = 3;
  for (int k = 0; k < 200; ++k) {
    H(2, 2) = (low + high) / 2;
    (exact_stress(law, H)(2, 2) > 0 ? high : low) = H(2, 2);
  }
  return H;
}

Matrix3 rotation(int dim) {
  Point const axis = dim == 3 ? Point(1, -2, 0.5).normalized() : Point::UnitZ();
  return Eigen::AngleAxisd(2.1, axis).toRotationMatrix();
}

/// Q v at every node.
Vector turned(Matrix3 const& Q, Vector const& v, int dim) {
  Vector result = Vector::Zero(v.size());
  for (Index node = 0; node < v.size() / dim; ++node)
    add_at_node(result, node, dim, Q * at_node(v, node, dim));
  return result;
}

/// The largest force on a node away from the boundary.
double most_inside(mesh::Mesh const& mesh, Vector const& f) {
  auto const inner = inner_nodes(mesh);
  double most = 0;
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (inner[ix(i)])
      most = std::max(most, at_node(f, i, mesh.dim).norm());
  return most;
}

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("a sheet that no stress across can stretch is told as an inverted cell is") {
    Body body = Case{mesh::CellKind::quad4, Kinematics::plane_strain, solid::Interpolation::plain, true}.body(
        material::StVenantKirchhoff{1e6, 0.3}, 1); // pulled far it has S_33 < 0 for any C_33 > 0
    Cells const cells(body, Kinematics::plane_strain);
    auto const pulled = [&](double by) {
      return force(cells, nodal(body.mesh, [&](Point const& X) { return Point(by * (X.x() - 1), 0, 0); }));
    };
    CHECK(pulled(0.5).norm() > 1);
    CHECK(std::isnan(pulled(5)[0]));
  }

  TEST_CASE("with mean dilatation one cell has one mean stress: the law's at the change of its volume") {
    material::NeoHookean law;
    law.young = 1000;
    law.poisson = 0.4;
    double const bulk = 1000 / (3 * (1 - 2 * 0.4));
    Body const body{"b",
                    grid(mesh::CellKind::quad4, {1, 1, 1}, [](Point const& at) { return at; }),
                    law,
                    1,
                    solid::Interpolation::mean_dilatation,
                    {}};
    Cells const cells(body, Kinematics::plane_strain);
    // the right side becomes 1 + 0.4 high: the square's volume 1.2, at its nodes 1 on the left and 1.4
    Vector const u = nodal(body.mesh, [&](Point const& X) { return Point(0, 0.4 * X.x() * X.y(), 0); });
    auto const stress = cells.stress(view(u)).cauchy;
    for (Eigen::Index node = 0; node < 4; ++node)
      CHECK(stress.row(node).head(3).sum() / 3 == doctest::Approx(bulk * 0.2).epsilon(1e-10));
  }

  TEST_CASE("patch test: a linear displacement gives the law's stress everywhere and no force inside") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = each.body(law, each.dim() == 3 ? 2 : 3);
      Cells const cells(body, each.kinematics);
      Matrix3 const H = gradient_of_patch(each.kinematics, small_strain(law));
      Vector const u = nodal(body.mesh, [&](Point const& X) { return H * X; });
      Vector const f = force(cells, u);
      CHECK(f.cwiseAbs().maxCoeff() > 1);
      CHECK(most_inside(body.mesh, f) <= 2e-12 * f.cwiseAbs().maxCoeff());
      Matrix3 const exact = exact_stress(law, each.sheet ? free_across(law, H) : H);
      Eigen::RowVectorXd row(solid::stress_components(each.kinematics));
      row.head(4) << exact(0, 0), exact(1, 1), exact(2, 2), exact(0, 1);
      if (each.dim() == 3)
        row.tail(2) << exact(1, 2), exact(0, 2);
      auto const stress = cells.stress(view(u));
      REQUIRE(stress.cauchy.cols() == row.size());
      CHECK((stress.cauchy.rowwise() - row).cwiseAbs().maxCoeff() <= 1e-11 * exact.norm());
      double const mises = std::sqrt(1.5) * (exact - exact.trace() / 3 * Matrix3::Identity()).norm();
      CHECK((stress.von_mises.array() - mises).abs().maxCoeff() <= 1e-11 * exact.norm());
    });
  }

  TEST_CASE("force is the derivative of energy and stiffness that of force at second order") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = each.body(law, each.dim() == 3 ? 1 : 2);
      Cells const cells(body, each.kinematics);
      Vector const u = random_vector(each.dim() * body.mesh.node_count(), 0.03);
      Vector const d = random_vector(u.size(), 1, 12);
      Vector const f = force(cells, u);
      Dense const K = stiffness(cells, u, each.dim());
      Vector const here = Vector::Zero(1);
      auto const first =
          rate([&](Vector const& s) { return Vector::Constant(1, energy(cells, u + s[0] * d)).eval(); },
               Dense::Constant(1, 1, f.dot(d)), here, 1e-3, 1e8);
      auto const second =
          rate([&](Vector const& s) { return force(cells, u + s[0] * d); }, Dense(K * d), here, 1e-3);
      CHECK_MESSAGE(first.second_order, "force: " << first.words());
      CHECK_MESSAGE(second.second_order, "stiffness: " << second.words());
      CHECK(first.errors[2] <= 1e-6 * f.cwiseAbs().dot(d.cwiseAbs())); // f . d itself may be near 0
      CHECK(second.errors[2] <= 1e-6 * second.scale);
    });
  }

  TEST_CASE("the stiffness of single entries is symmetric: each column is the derivative by its unknown") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = each.body(law, 1);
      Cells const cells(body, each.kinematics);
      Vector const u = random_vector(each.dim() * body.mesh.node_count(), 0.03);
      Dense const K = stiffness(cells, u, each.dim());
      Dense const differences = jacobian([&](Vector const& at) { return force(cells, at); }, u, 1e-5);
      CHECK((differences - differences.transpose()).norm() <= 1e-7 * K.norm());
      CHECK((differences - K).norm() <= 1e-7 * K.norm());
    });
  }

  TEST_CASE("a rigid motion gives no force and turns the forces of a deformed body with it") {
    each_case_and_law([](Case const& each, material::Material const& law) {
      Body const body = each.body(law, each.dim() == 3 ? 1 : 2);
      Cells const cells(body, each.kinematics);
      Point const shift = each.axisymmetric() ? Point(0, 0.7, 0) : Point(3, 0.7, -1.2);
      CHECK(force(cells, nodal(body.mesh, [&](Point const&) { return shift; })).norm() < 1e-9 * 1e6);
      if (each.axisymmetric() || small_strain(law))
        return;
      Matrix3 const Q = rotation(each.dim());
      Vector const X = nodal(body.mesh, [](Point const& at) { return at; });
      Vector const moved =
          turned(Q, X, each.dim()) - X + nodal(body.mesh, [&](Point const&) { return shift; });
      CHECK(force(cells, moved).norm() < 1e-9 * 1e6);
      CHECK(std::abs(energy(cells, moved)) < 1e-9 * 1e6);
      Vector const u = random_vector(X.size(), 0.03);
      Vector const f = force(cells, u);
      Vector const turned_f = turned(Q, f, each.dim());
      CHECK((force(cells, turned(Q, X + u, each.dim()) - X) - turned_f).norm() <= 1e-11 * f.norm());
    });
  }

  TEST_CASE("finite laws reach linear elasticity at first order as displacements vanish") {
    each_case([](Case const& each) {
      Body const linear = each.body(material::LinearElastic{1e6, 0.25}, 1);
      Vector const d = random_vector(each.dim() * linear.mesh.node_count(), 1);
      Vector const exact = force(Cells(linear, each.kinematics), d);
      for (material::Material const& law : {material::Material(material::StVenantKirchhoff{1e6, 0.25}),
                                            material::Material(material::NeoHookean{1e6, 0.25}),
                                            material::Material(material::BlatzKo{4e5})}) {
        Body const body = each.body(law, 1);
        Cells const cells(body, each.kinematics);
        auto const error = [&](double s) { return (force(cells, s * d) / s - exact).norm() / exact.norm(); };
        CHECK(error(1e-4) < 1e-2);
        CHECK(error(1e-5) / error(1e-4) == doctest::Approx(0.1).epsilon(0.05));
        CHECK((stiffness(cells, Vector::Zero(d.size()), each.dim()) * d - exact).norm() <=
              1e-12 * exact.norm());
      }
    });
  }

  TEST_CASE("mass: its sum is density times volume and its first moment exact") {
    for (Case const& each : all_cases()) {
      CAPTURE(each.words());
      Body const body{"b", distorted(each.kind, {3, 2, 2}), material::BlatzKo{1e6}, 800};
      double total = 0, moment = 0;
      Cells(body, each.kinematics).each_mass([&](std::span<Index const> nodes, Dense const& mass) {
        total += mass.sum();
        for (Eigen::Index a = 0; a < mass.rows(); ++a)
          moment += mass.row(a).sum() * body.mesh.nodes(nodes[static_cast<std::size_t>(a)], 1);
        CHECK((mass - mass.transpose()).norm() <= 1e-15 * mass.norm());
      });
      // [1, 3] x [0, 1.5] (x [0, 1]): 3 m^2 or m^3, or a tube of volume pi (9 - 1) 1.5
      double const volume = each.axisymmetric() ? std::numbers::pi * 12 : 3;
      CHECK(total == doctest::Approx(800 * volume).epsilon(1e-12));
      CHECK(moment == doctest::Approx(800 * volume * 0.75).epsilon(1e-12));
    }
  }

  TEST_CASE("an inverted cell is reported by its number across blocks") {
    Body body{"b", {}, material::BlatzKo{1e6}, 1};
    body.mesh.nodes.resize(8, 2);
    body.mesh.nodes << 0, 0, 1, 0, 2, 0, 3, 0, 0, 1, 1, 1, 2, 1, 3, 1;
    body.mesh.blocks = {{mesh::CellKind::tri3, {0, 1, 4, 1, 5, 4}},
                        {mesh::CellKind::quad4, {1, 2, 6, 5, 2, 3, 7, 6}}};
    Cells const cells(body, Kinematics::plane_strain);
    CHECK(cells.count() == 4);
    auto const inverted = [&](Index node, double dx) {
      Vector u = Vector::Zero(16), f = Vector::Zero(16);
      u[2 * node] = dx;
      return cells.add_force(view(u), view(f)).inverted_cell;
    };
    CHECK(inverted(0, 0) == -1);
    CHECK(inverted(0, 1.5) == 0);
    CHECK(inverted(3, -2.5) == 3);
    CHECK(inverted(2, -2) == 2);
    Vector const flat = nodal(body.mesh, [](Point const& X) { return Point(0, -X.y(), 0); });
    CHECK(std::isnan(force(cells, flat)[0])); // det F = 0 is no state either
  }

  TEST_CASE("a solid turned inside out is reported in 3D with either interpolation") {
    each_case([](Case const& each) {
      if (each.dim() == 2)
        return;
      Body const body = each.body(material::NeoHookean{1e6, 0.3}, 1);
      Vector const u = nodal(body.mesh, [](Point const& X) { return Point(0, 0, -1.5 * X.z()); });
      CHECK(std::isnan(force(Cells(body, each.kinematics), u)[0]));
    });
  }

  TEST_CASE("mean dilatation is refused for cells of constant strain") {
    for (auto const& cell : mesh::cell_table()) {
      Body body{"plate", distorted(cell.kind, {1, 1, 1}), material::BlatzKo{1e6}, 1};
      CHECK_NOTHROW(solid::check_interpolation(body));
      body.interpolation = solid::Interpolation::mean_dilatation;
      if (cell.kind == mesh::CellKind::tri3 || cell.kind == mesh::CellKind::tet4)
        CHECK_THROWS_WITH_AS(solid::check_interpolation(body), doctest::Contains("constant strain"),
                             core::InputError);
      else
        CHECK_NOTHROW(solid::check_interpolation(body));
    }
  }

  TEST_CASE("force and stiffness and damping allocate nothing") {
    each_case([](Case const& each) {
      Body body = each.body(material::NeoHookean{1e6, 0.3}, 2);
      body.damping = material::KelvinVoigt{10, 5};
      auto const at_first = allocations();
      Cells const cells(body, each.kinematics);
      CHECK((allocations() > at_first || !counts_allocations()));
      auto const n = each.dim() * body.mesh.node_count();
      std::vector<double> u(ix(n), 0.001), f(ix(n), 0), values(ix(n) * ix(n), 0);
      auto const map = dense_map(cells, n, each.dim());
      auto const before = allocations();
      static_cast<void>(cells.add_force(u, f));
      cells.add_stiffness(u, 0.5, map, values);
      static_cast<void>(cells.add_damping(u, u, f));
      cells.add_damping_stiffness(u, 0.5, map, values);
      CHECK(allocations() == before);
    });
  }
}
