// Multigrid: iterations that do not follow the size, whatever is held; loads and contact solved with it
// against dense algebra.
#include <Eigen/LU>
#include <doctest/doctest.h>
#include <numeric>
#include <random>

#include "linear/hexahedra.hpp"
#include "linear/krylov.hpp"
#include "linear/multigrid.hpp"
#include "linear/multigrid_factor.hpp"
#include "linear/symmetric_product.hpp"
#include "threads.hpp"

using namespace stiction;
using namespace stiction::linear;
using namespace stiction::test;

namespace {

Vector noise(Index n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Vector::NullaryExpr(n, [&] { return uniform(random); });
}

/// Nodes of the bottom up to x = part: those beyond a third of that held along z alone.
std::vector<HeldNode> held_bottom(Hexahedra const& block, double part, double stiffness) {
  std::vector<HeldNode> held;
  for (Index k = 0; k < block.side() * block.side(); ++k)
    if (double const x = block.at(k)[0]; x <= part) {
      Matrix3 S = Matrix3::Zero();
      S(2, 2) = stiffness / block.cells;
      held.push_back({k, x < part / 3 ? Matrix3(Matrix3::Identity() * S(2, 2)) : S});
    }
  return held;
}

/// Conjugate gradients to 1e-8 with the matrix and what is held.
int iterations(BlockMatrix<3, 3> const& A, Dense const& modes, Waves const& waves,
               std::vector<HeldNode> const& held) {
  Multigrid multigrid;
  multigrid.set_up(A, modes, waves);
  multigrid.hold(held);
  auto const apply = [&](Vector const& x, Vector& y) {
    y.setZero(x.size());
    add_product(A, x, y);
    for (auto const& [node, stiffness] : held)
      y.segment<3>(3 * node) += stiffness * x.segment<3>(3 * node);
  };
  Vector x = Vector::Zero(3 * A.rows());
  auto const end = conjugate_gradients(apply, [&](Vector const& r, Vector& z) { multigrid.cycle(r, z); },
                                       noise(3 * A.rows(), 1), x, {1e-8, 100});
  CHECK(end.converged);
  return end.iterations;
}
int iterations(Hexahedra const& block, std::vector<HeldNode> const& held) {
  auto const A = block.matrix();
  return iterations(A, block.modes(), Waves::one_by_one(A.rows()), held);
}

/// The lower triangle in columns, unknowns as the nodes number them; the bottom last.
struct Assembled {
  Pattern pattern;
  std::vector<double> values;
  Index surface;
  NodesOfUnknowns nodes;
  Dense all;
};

Assembled assembled(Hexahedra const& block) {
  auto const A = block.matrix();
  Index const n = 3 * block.nodes(), surface = 3 * block.side() * block.side();
  auto const number = [&](Index dof) { return (dof + n - surface) % n; };
  std::vector<Indices> pairs;
  Assembled made{{}, {}, surface, {Indices(ix(n)), block.modes()}, Dense::Zero(n, n)};
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
      for (Index a = 0; a < 3; ++a)
        for (Index b = 0; b < 3; ++b) {
          Index const row = number(3 * i + a), column = number(3 * A.column[ix(k)] + b);
          pairs.push_back({row, column});
          made.all(row, column) = A.block(k)(a, b);
        }
  for (Index dof = 0; dof < n; ++dof)
    made.nodes.place[ix(number(dof))] = dof;
  made.pattern = pattern_of(n, pairs);
  for (Index j = 0; j < n; ++j)
    for (Index k = made.pattern.columns[ix(j)]; k < made.pattern.columns[ix(j) + 1]; ++k)
      made.values.push_back(made.all(made.pattern.rows[ix(k)], j));
  return made;
}

} // namespace

TEST_CASE("iterations of multigrid follow neither the size nor what is held") {
  for (double const stiffness : {0.0, 10.0, 1e5})
    for (double const part : {0.3, 1.0}) {
      int const small = iterations({8}, held_bottom({8}, part, stiffness)),
                large = iterations({24}, held_bottom({24}, part, stiffness));
      CHECK(small <= 13);
      CHECK(large <= small + 3);
    }
}

TEST_CASE("nodes in waves: iterations as one by one, and the same bits whatever the threads") {
  Hexahedra const block{16};
  auto const natural = block.matrix();
  auto const made = waves_of(natural, {300, 2});
  REQUIRE(made.waves.first > 1);
  auto const& number = made.waves.number;
  auto const A = renumbered(natural, &made.order, number);
  Dense const old = block.modes();
  Dense modes = old;
  for (Index k = 0; k < A.rows(); ++k)
    modes.middleRows<3>(3 * k) = old.middleRows<3>(3 * made.order[ix(k)]);
  auto held = held_bottom(block, 0.7, 3);
  for (auto& one : held)
    one.node = number[ix(one.node)];
  std::ranges::sort(held, {}, &HeldNode::node);
  same_by_threads([&] {
    Multigrid multigrid;
    multigrid.set_up(A, modes, made.waves);
    multigrid.hold(held);
    Vector z;
    multigrid.cycle(noise(3 * A.rows(), 1), z);
    return z;
  });
  int const in_waves = iterations(A, modes, made.waves, held),
            one_by_one = iterations(block, held_bottom(block, 0.7, 3));
  CHECK(in_waves <= one_by_one + 1);
}

TEST_CASE("a cycle of multigrid is symmetric and positive, and holding anew is holding at once") {
  Hexahedra const block{10};
  auto const A = block.matrix();
  Multigrid once;
  once.set_up(A, block.modes());
  Multigrid anew = once;
  once.hold(held_bottom(block, 0.4, 100));
  for (double const part : {1.0, 0.2, 0.0, 0.6})
    anew.hold(held_bottom(block, part, 1e3 * (1 + part)));
  anew.hold(held_bottom(block, 0.4, 100));
  Vector const a = noise(3 * block.nodes(), 2), b = noise(3 * block.nodes(), 3);
  Vector za, zb, again;
  once.cycle(a, za);
  once.cycle(b, zb);
  anew.cycle(a, again);
  constexpr double rounding = 6e-8; // in single precision
  CHECK(std::abs(a.dot(zb) - b.dot(za)) <= 2 * rounding * a.norm() * zb.norm());
  CHECK(a.dot(za) > 0);
  CHECK((again - za).norm() <= 10 * rounding * za.norm());
}

TEST_CASE("a product that reads half of a symmetric matrix is the product with all of it") {
  Hexahedra const block{6};
  auto const A = block.matrix();
  Vector const x = noise(3 * block.nodes(), 9);
  Vector whole = Vector::Zero(x.size()), half;
  add_product(A, x, whole);
  SymmetricProduct product;
  product.take(A, Waves::one_by_one(A.rows()));
  product(x, half);
  CHECK((half - whole).norm() <= 1e-15 * whole.norm());
}

TEST_CASE("a cycle does not mind how large a load is") {
  Hexahedra const block{6};
  auto const A = block.matrix();
  Multigrid multigrid;
  multigrid.set_up(A, block.modes());
  Vector const load = noise(3 * block.nodes(), 10);
  Vector z, scaled;
  multigrid.cycle(load, z);
  for (double const size : {0x1p-200, 0x1p200}) { // beyond single precision
    multigrid.cycle(size * load, scaled);
    CHECK(scaled == size * z);
  }
}

TEST_CASE("loads by multigrid are those of dense algebra") {
  auto made = assembled({4});
  auto const factor = make_multigrid_factor(made.pattern, made.surface, made.nodes);
  REQUIRE(factor->factorize(made.values));
  Index const n = made.pattern.size(), m = made.surface;
  Dense const inverse = made.all.inverse();
  Vector b = noise(n, 4);
  Vector const load = noise(m, 5), alone = inverse * b;
  Vector all = b;
  all.tail(m) += load;
  CHECK((factor->condense(b) - alone.tail(m)).norm() <= 1e-10 * alone.norm());
  factor->expand(load, b);
  CHECK((b - inverse * all).norm() <= 1e-10 * b.norm());
  Dense C;
  Indices const used{0, 7, 30};
  factor->compliance(used, C);
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j)
      CHECK(C(i, j) == doctest::Approx(inverse(n - m + used[ix(i)], n - m + used[ix(j)])).epsilon(1e-9));
  CHECK(factor->spent().operations > 0);
}

TEST_CASE("a matrix that is not positive definite gives no motion") {
  auto made = assembled({4});
  for (Index j = 0; j < made.pattern.size(); ++j)
    made.values[ix(made.pattern.columns[ix(j)])] -= 0.3 / 4;
  auto const factor = make_multigrid_factor(made.pattern, made.surface, made.nodes);
  Vector b = noise(made.pattern.size(), 6);
  if (factor->factorize(made.values))
    CHECK_FALSE(factor->condense(b).allFinite());
  for (Index j = 0; j < made.pattern.size(); ++j)
    made.values[ix(made.pattern.columns[ix(j)])] = -1;
  CHECK_FALSE(make_multigrid_factor(made.pattern, 0, made.nodes)->factorize(made.values));
}

TEST_CASE("points that stick, slip, are open and are bonded, solved together with the bulk") {
  Hexahedra const block{4};
  auto made = assembled(block);
  auto const factor = make_multigrid_factor(made.pattern, made.surface, made.nodes);
  REQUIRE(factor->factorize(made.values));
  auto& together = *factor->coupled();
  Index const m = made.surface, n = made.pattern.size();
  SurfaceRows rows{{}, m, 0.7};
  Dense H = Dense::Zero(m, m);
  PointLaws laws{Dense::Zero(m, 3), Dense::Zero(m, 3), noise(m, 7)};
  Dense A = Dense::Zero(m, m), B = Dense::Zero(m, m);
  for (Index point = 0; 3 * point < m; ++point) {
    for (Index i = 0; i < 3; ++i) { // (n, t1, t2) is (z, x, y)
      rows.H.push_back({3 * point + i, 3 * point + (i + 2) % 3, 1.0});
      H(3 * point + i, 3 * point + (i + 2) % 3) = 1;
    }
    Matrix3 a = Matrix3::Zero(), b = Matrix3::Zero();
    if (point % 4 == 0) { // sticks
      b.setIdentity();
      b(0, 1) = 0.3;
    } else if (point % 4 == 1) { // slips: p_t = 0.3 p_n
      b(0, 0) = 1;
      a(1, 0) = -0.3;
      a(1, 1) = a(2, 2) = 1;
    } else { // is open, with a bond or none
      a.setIdentity();
      b.diagonal().setConstant(point % 4 == 2 ? 0 : 0.1);
    }
    laws.A.middleRows<3>(3 * point) = A.block<3, 3>(3 * point, 3 * point) = a;
    laws.B.middleRows<3>(3 * point) = B.block<3, 3>(3 * point, 3 * point) = b;
  }
  Dense const W = 0.7 * H * made.all.inverse().bottomRightCorner(m, m) * H.transpose();
  Vector const p = noise(m, 8);
  together.couple(rows);
  Vector x = Vector::Zero(m), dp, dx;
  together.add_motion(p, x);
  CHECK((x - W * p).norm() <= 1e-10 * x.norm());
  REQUIRE(together.solve(laws, p, 1e-10, dp, dx));
  Vector const known = (A + B * W).fullPivLu().solve(laws.right);
  CHECK((dp - known).norm() <= 1e-7 * known.norm());
  CHECK((dx - W * known).norm() <= 1e-7 * (W * known).norm());
  together.advance(0.5);
  REQUIRE(together.solve(laws, p + 0.5 * dp, 1e-10, dp, dx));
  CHECK((dp - known).norm() <= 1e-7 * known.norm());
  CHECK(n > m);
}

namespace {

/// GMRES with points of the whole bottom, a third each that stick, slip and are open, to 1e-8 of what is
/// wrong.
double iterations_with_contact(Hexahedra const& block) {
  auto made = assembled(block);
  auto const factor = make_multigrid_factor(made.pattern, made.surface, made.nodes);
  REQUIRE(factor->factorize(made.values));
  Index const m = made.surface;
  SurfaceRows rows{{}, m, 1};
  PointLaws laws{Dense::Zero(m, 3), Dense::Zero(m, 3), noise(m, 11)};
  for (Index point = 0; 3 * point < m; ++point) {
    for (Index i = 0; i < 3; ++i) // (n, t1, t2) is (z, x, y)
      rows.H.push_back({3 * point + i, 3 * point + (i + 2) % 3, 1.0});
    double const x = block.at(point)[0];
    auto a = laws.A.middleRows<3>(3 * point), b = laws.B.middleRows<3>(3 * point);
    if (x < 1.0 / 3) {
      b.setIdentity();
    } else if (x < 2.0 / 3) {
      b(0, 0) = 1;
      a(1, 0) = -0.3;
      a(1, 1) = a(2, 2) = 1;
    } else {
      a.setIdentity();
    }
  }
  factor->coupled()->couple(std::move(rows));
  Vector dp, dx;
  REQUIRE(factor->coupled()->solve(laws, Vector::Zero(m), 1e-8, dp, dx));
  auto const numbers = 9 * static_cast<double>(block.matrix().column.size());
  return factor->spent().operations / (cycle_passes * 2 * numbers);
}

} // namespace

TEST_CASE("contact takes at most half as many iterations again as the bodies alone") {
  for (Index const cells : {8, 14}) {
    CAPTURE(cells);
    CHECK(iterations_with_contact({cells}) <= 1.5 * iterations({cells}, {}));
  }
}
