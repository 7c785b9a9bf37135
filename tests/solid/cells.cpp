// What every cell kind must do: patch test, tangent with its rate, objectivity, mass, inverted cells, no
// allocation.
#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <numbers>

#include "differences.hpp"
#include "solid/allocations.hpp"
#include "solid/helpers.hpp"

using namespace stiction;
using namespace stiction::test;
using solid::Body;
using solid::Cells;
using solid::Kinematics;

namespace {

Vector random_vector(Eigen::Index n, double size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-size, size);
  Vector v(n);
  for (Eigen::Index i = 0; i < n; ++i)
    v[i] = uniform(random);
  return v;
}

Eigen::Matrix2d gradient_of_patch(Kinematics kinematics, bool small) {
  Eigen::Matrix2d H;
  if (kinematics == Kinematics::axisymmetric) // constant stress needs equal radial and hoop stretch, no shear
    H << 0.15, 0, 0, -0.2;
  else
    H << 0.15, 0.3, -0.1, -0.2;
  return small ? Eigen::Matrix2d(1e-3 * H) : H;
}

bool small_strain(material::Material const& law) {
  return std::visit([](auto const& l) { return std::decay_t<decltype(l)>::small_strain; }, law);
}

/// Cauchy stress (11, 22, 33, 12) of the law at the homogeneous gradient H, F33 = 1 + h.
Eigen::RowVector4d exact_stress(material::Material const& law, Eigen::Matrix2d const& H, double h) {
  Matrix3 F = Matrix3::Identity();
  F.topLeftCorner<2, 2>() += H;
  F(2, 2) += h;
  Matrix3 const sigma = std::visit(
      [&](auto const& l) -> Matrix3 {
        if (std::decay_t<decltype(l)>::small_strain) {
          material::Voigt<6> strain = material::Voigt<6>::Zero();
          strain.head<4>() << H(0, 0), H(1, 1), h, H(0, 1) + H(1, 0);
          return tensor(l.template respond<6>(strain).stress);
        }
        return F * tensor(l.template respond<6>(green<6>(F)).stress) * F.transpose() / F.determinant();
      },
      law);
  return {sigma(0, 0), sigma(1, 1), sigma(2, 2), sigma(0, 1)};
}

template<class Act> void each_kind(Act const& act) {
  for (auto const& cell : mesh::cell_table(2))
    for (auto const kinematics : kinematics_list) {
      bool const axisymmetric = kinematics == Kinematics::axisymmetric;
      CAPTURE(axisymmetric);
      CAPTURE(std::string(cell.name));
      act(cell.kind, kinematics);
    }
}

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("patch test: a linear displacement gives the law's stress everywhere and no force inside") {
    each_kind([](mesh::CellKind kind, Kinematics kinematics) {
      for (auto const& [name, law] : sample_materials()) {
        CAPTURE(name);
        Body const body{"b", distorted(kind, 3, 3), law, 1};
        auto const inner = inner_nodes(body.mesh);
        Cells const cells(body, kinematics);
        Eigen::Matrix2d const H = gradient_of_patch(kinematics, small_strain(law));
        Vector const u = nodal(body.mesh, [&](Eigen::Vector2d const& X) -> Eigen::Vector2d { return H * X; });
        Vector const f = force(cells, u);
        double most_inside = 0;
        for (Index i = 0; i < body.mesh.node_count(); ++i)
          if (inner[ix(i)])
            most_inside = std::max(most_inside, f.segment<2>(2 * i).norm());
        CHECK(f.cwiseAbs().maxCoeff() > 1);
        CHECK(most_inside <= 1e-12 * f.cwiseAbs().maxCoeff());
        auto const stress = cells.stress({u.data(), static_cast<std::size_t>(u.size())});
        auto const exact = exact_stress(law, H, kinematics == Kinematics::axisymmetric ? H(0, 0) : 0.0);
        CHECK((stress.cauchy.rowwise() - exact).cwiseAbs().maxCoeff() <= 1e-11 * exact.norm());
        double const mean = exact.head<3>().sum() / 3;
        double const mises =
            std::sqrt(1.5 * (exact.head<3>().array() - mean).square().sum() + 3 * exact[3] * exact[3]);
        CHECK((stress.von_mises.array() - mises).abs().maxCoeff() <= 1e-11 * exact.norm());
      }
    });
  }

  TEST_CASE("force is the derivative of energy and stiffness that of force, at second order") {
    each_kind([](mesh::CellKind kind, Kinematics kinematics) {
      for (auto const& [name, law] : sample_materials()) {
        CAPTURE(name);
        Body const body{"b", distorted(kind, 2, 2), law, 1};
        Cells const cells(body, kinematics);
        Vector const u = random_vector(2 * body.mesh.node_count(), 0.03);
        Vector const d = random_vector(u.size() + 1, 1).tail(u.size()); // another direction
        Vector const f = force(cells, u);
        Dense const K = stiffness(cells, u);
        Vector const here = Vector::Zero(1);
        auto const first =
            rate([&](Vector const& s) { return Vector::Constant(1, energy(cells, u + s[0] * d)).eval(); },
                 Dense::Constant(1, 1, f.dot(d)), here, 1e-3, 1e8);
        auto const second =
            rate([&](Vector const& s) { return force(cells, u + s[0] * d); }, Dense(K * d), here, 1e-3);
        CHECK_MESSAGE(first.second_order, "force: " << first.words());
        CHECK_MESSAGE(second.second_order, "stiffness: " << second.words());
        CHECK(first.errors[2] <= 1e-6 * (1 + first.scale));
        CHECK(second.errors[2] <= 1e-6 * second.scale);
      }
    });
  }

  TEST_CASE("a rigid rotation gives no force, and turns the forces of a deformed body with it") {
    Eigen::Matrix2d const Q = Eigen::Rotation2Dd(2.1).toRotationMatrix();
    for (auto const& cell : mesh::cell_table(2))
      for (auto const& [name, law] : sample_materials()) {
        if (small_strain(law))
          continue;
        INFO(name << ", " << std::string(cell.name));
        Body const body{"b", distorted(cell.kind, 2, 2), law, 1};
        Cells const cells(body, Kinematics::plane_strain);
        Vector const X = nodal(body.mesh, [](Eigen::Vector2d const& at) { return at; });
        auto const turned = [&](Vector const& v) {
          Vector result(v.size());
          for (Eigen::Index i = 0; i < v.size(); i += 2)
            result.segment<2>(i) = Q * v.segment<2>(i);
          return result;
        };
        CHECK(force(cells, turned(X) - X).norm() < 1e-9 * 1e6);
        CHECK(std::abs(energy(cells, turned(X) - X)) < 1e-9 * 1e6);
        Vector const u = random_vector(X.size(), 0.03);
        Vector const f = force(cells, u);
        CHECK((force(cells, turned(X + u) - X) - turned(f)).norm() <= 1e-11 * f.norm());
      }
  }

  TEST_CASE("mass: its sum is density times volume, its first moment exact") {
    each_kind([](mesh::CellKind kind, Kinematics kinematics) {
      Body const body{"b", distorted(kind, 3, 2), material::BlatzKo{1e6}, 800};
      double total = 0, moment = 0;
      Cells(body, kinematics).each_mass([&](std::span<Index const> nodes, Dense const& mass) {
        total += mass.sum();
        for (Eigen::Index a = 0; a < mass.rows(); ++a)
          moment += mass.row(a).sum() * body.mesh.nodes(nodes[static_cast<std::size_t>(a)], 1);
        CHECK((mass - mass.transpose()).norm() <= 1e-15 * mass.norm());
      });
      // [1, 3] x [0, 1.5]: an area of 3 m^2, or a tube of volume pi (9 - 1) 1.5
      double const volume = kinematics == Kinematics::axisymmetric ? std::numbers::pi * 12 : 3;
      CHECK(total == doctest::Approx(800 * volume).epsilon(1e-12));
      CHECK(moment == doctest::Approx(800 * volume * 0.75).epsilon(1e-12));
    });
  }

  TEST_CASE("an inverted cell is reported by its number, across blocks") {
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
      return cells.add_force({u.data(), 16}, {f.data(), 16}).inverted_cell;
    };
    CHECK(inverted(0, 0) == -1);
    CHECK(inverted(0, 1.5) == 0);
    CHECK(inverted(3, -2.5) == 3);
    CHECK(inverted(2, -2) == 2);
    Vector const flat = nodal(body.mesh, [](Eigen::Vector2d const& X) { return Eigen::Vector2d(0, -X.y()); });
    CHECK(std::isnan(force(cells, flat)[0])); // det F = 0 is no state either
  }

  TEST_CASE("force and stiffness allocate nothing") {
    each_kind([](mesh::CellKind kind, Kinematics kinematics) {
      Body const body{"b", distorted(kind, 3, 3), material::NeoHookean{1e6, 0.3}, 1};
      auto const at_first = allocations();
      Cells const cells(body, kinematics);
      CHECK((allocations() > at_first || !counts_allocations));
      auto const n = 2 * body.mesh.node_count();
      std::vector<double> u(ix(n), 0.001), f(ix(n), 0), values(ix(n) * ix(n), 0);
      auto const map = dense_map(cells, n);
      auto const before = allocations();
      static_cast<void>(cells.add_force(u, f));
      cells.add_stiffness(u, 0.5, map, values);
      CHECK(allocations() == before);
    });
  }
}
