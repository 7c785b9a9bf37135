// Bodies that relax: their matrix, the frame they are seen from, what cells remember where.
#include <Eigen/Geometry>

#include "differences.hpp"
#include "solid/helpers.hpp"

using namespace stiction;
using namespace stiction::test;
using solid::Body;
using solid::Cells;

namespace {

/// Two terms in shear, of which one relaxes in volume too, and one in volume alone.
Body relaxing(Case const& each, material::Material const& law, int n = 1) {
  Body body = each.body(law, n);
  body.relaxing = {{0.7, 0, 1}, {0, 4e5, 20, 0.6}, {0, 0, 3, 0, 3e5}};
  return body;
}
/// In volume alone.
Body pressed(Case const& each, material::Material const& law, double time) {
  Body body = each.body(law, 1);
  body.relaxing = {{0, 0, time, 0.8}};
  return body;
}

/// What a body remembers after two steps to random places.
Vector remembered(Cells const& cells, Eigen::Index dofs) {
  Vector memory = Vector::Zero(cells.memory_size()), next = memory;
  for (unsigned const seed : {3U, 4U}) {
    Vector const u = random_vector(dofs, 0.04, seed);
    static_cast<void>(cells.relax(view(u), 0.7, view(memory), view(next)));
    memory.swap(next);
  }
  return memory;
}

Vector force_of(Cells const& cells, Vector const& u, solid::Networks const& networks) {
  Vector f = Vector::Zero(u.size());
  REQUIRE(cells.add_force(view(u), view(f), &networks).sound());
  return f;
}

} // namespace

TEST_SUITE_BEGIN("solid");

TEST_CASE("relaxation: the matrix of every cell and law is the derivative of its force") {
  each_case_and_law([](Case const& each, material::Material const& law) {
    if (each.sheet)
      return; // scenes refuse it
    Body const body = relaxing(each, law);
    Cells const cells(body, each.kinematics);
    Vector const u = random_vector(each.dim() * body.mesh.node_count(), 0.03);
    auto const networks = cells.networks(view(remembered(cells, u.size())), 0.5);
    Dense const K = assembled(cells, static_cast<Index>(u.size()), each.dim(),
                              [&](auto const& map, std::span<double> values) {
                                cells.add_stiffness(view(u), 1, map, values, &networks);
                              });
    auto const found = rate([&](Vector const& at) { return force_of(cells, at, networks); }, K, u, 1e-2,
                            1e7 * K.norm() / 1e9);
    INFO(found.words());
    CHECK((found.second_order || found.errors[0] < 1e-9 * found.scale));
    CHECK((K - stiffness(cells, u, each.dim())).norm() > 1e-3 * K.norm());
  });
}

TEST_CASE("relaxation: a network in volume, fresh, holds K_k/2 ln(J)^2 of the mean dilatation") {
  Case const each{mesh::CellKind::quad4, Kinematics::plane_strain, solid::Interpolation::mean_dilatation};
  for (auto const& [name, law] : sample_materials()) {
    if (small_strain(law))
      continue;
    CAPTURE(name);
    Body const body = pressed(each, law, 1e12);
    Cells const cells(body, each.kinematics);
    auto const area = [&](Vector const& u) { // of one cell
      auto const& cell = body.mesh.blocks[0].nodes;
      double sum = 0;
      for (std::size_t a = 0; a < 4; ++a) {
        Index const i = cell[a], j = cell[(a + 1) % 4];
        Point const p = node_position(body.mesh, i) + at_node(u, i, 2),
                    q = node_position(body.mesh, j) + at_node(u, j, 2);
        sum += 0.5 * (p.x() * q.y() - p.y() * q.x());
      }
      return sum;
    };
    Vector const u = random_vector(8, 0.1), rest = Vector::Zero(8);
    double const K = 0.8 * material::moduli(law).bulk(), A0 = area(rest);
    auto const energy = [&](Vector const& at) {
      double const e = std::log(area(at) / A0);
      return Vector::Constant(1, K / 2 * A0 * e * e);
    };
    Vector const memory = Vector::Zero(cells.memory_size());
    Vector own = force_of(cells, u, cells.networks(view(memory), 1)), without = Vector::Zero(8);
    REQUIRE(cells.add_force(view(u), view(without)).sound());
    own -= without;
    auto const found = rate(energy, own.transpose(), u, 1e-2, 100 * own.norm());
    INFO(found.words());
    CHECK(found.second_order);
    CHECK(found.errors[2] < 1e-5 * found.scale);
  }
}

TEST_CASE("relaxation: a network in volume that has relaxed makes no force where it has, in every cell") {
  each_case_and_law([](Case const& each, material::Material const& law) {
    if (each.sheet)
      return;
    Body const body = pressed(each, law, 1e-9);
    Cells const cells(body, each.kinematics);
    Vector const u = random_vector(each.dim() * body.mesh.node_count(), 0.03);
    Vector const rest = Vector::Zero(cells.memory_size());
    Vector memory = rest;
    CHECK(cells.relax(view(u), 1, view(rest), view(memory)).dissipated > 0);
    Vector law_alone = Vector::Zero(u.size());
    REQUIRE(cells.add_force(view(u), view(law_alone)).sound());
    CHECK((force_of(cells, u, cells.networks(view(memory), 0)) - law_alone).norm() < 1e-7 * law_alone.norm());
    CHECK((force_of(cells, u, cells.networks(view(rest), 0)) - law_alone).norm() > 1e-3 * law_alone.norm());
  });
}

TEST_CASE("relaxation: only what there is is remembered") {
  Case const each{mesh::CellKind::hex8, Kinematics::three_dimensional, solid::Interpolation::plain};
  Body body = each.body(sample_materials()[2].second, 1);
  auto const numbers = [&](std::vector<material::PronyTerm> terms) {
    body.relaxing = std::move(terms);
    Cells const cells(body, each.kinematics);
    return cells.by_cell(view(Vector(Vector::Zero(cells.memory_size())))).size() / 8; // points
  };
  CHECK(numbers({{0.7, 0, 1}}) == 12);
  CHECK(numbers({{0.7, 0, 1}, {0.2, 0, 5}}) == 18);
  CHECK(numbers({{0, 0, 1, 0.7}}) == 2);
  CHECK(numbers({{0.7, 0, 1}, {0, 0, 1, 0.7}}) == 14);
  CHECK(numbers({{0.7, 0, 1, 0.7}, {0, 0, 1, 0, 1}}) == 15);
}

TEST_CASE("relaxation: a body that is turned and shifted between its steps makes the same forces, turned") {
  Matrix3 const Q = Eigen::AngleAxisd(1.1, Point(1, 2, -1).normalized()).toRotationMatrix();
  for (auto const& [name, law] : sample_materials()) {
    Case const each{mesh::CellKind::hex8, Kinematics::three_dimensional, solid::Interpolation::plain};
    if (small_strain(law))
      continue;
    CAPTURE(name);
    Body const body = relaxing(each, law);
    Cells const cells(body, each.kinematics);
    auto const turned = [&](Vector const& u, Matrix3 const& by) {
      return nodal(body.mesh, [&](Point const& X) {
        for (Index i = 0; i < body.mesh.node_count(); ++i)
          if ((node_position(body.mesh, i) - X).norm() < 1e-12)
            return Point(by * (X + at_node(u, i, 3)) - X + Point(3, 1, 2));
        return Point(Point::Zero());
      });
    };
    Vector const first = random_vector(3 * body.mesh.node_count(), 0.04),
                 second = random_vector(first.size(), 0.05, 8);
    auto const force_after = [&](Vector const& a, Vector const& b) {
      Vector memory = Vector::Zero(cells.memory_size()), next = memory;
      auto const energy = cells.relax(view(a), 0.7, view(memory), view(next));
      CHECK(energy.dissipated > 0);
      return force_of(cells, b, cells.networks(view(next), 0.3));
    };
    Vector const plain = force_after(first, second),
                 seen = force_after(turned(first, Q.transpose()), turned(second, Q));
    double worst = 0;
    for (Index i = 0; i < body.mesh.node_count(); ++i)
      worst = std::max(worst, (Q * at_node(plain, i, 3) - at_node(seen, i, 3)).norm());
    CHECK(worst < 1e-11 * plain.norm());
  }
}

TEST_CASE("relaxation: cells of several kinds, in slabs, remember all that bodies of one kind do") {
  // quads and triangles: the same forces as those of two bodies of one kind each
  Case const quads{mesh::CellKind::quad4, Kinematics::plane_strain, solid::Interpolation::plain},
      triangles{mesh::CellKind::tri3, Kinematics::plane_strain, solid::Interpolation::plain};
  auto const law = sample_materials()[2].second;
  Body const a = relaxing(quads, law, 3), b = relaxing(triangles, law, 3);
  Body both = a;
  Index const shift = a.mesh.node_count();
  both.mesh.nodes.conservativeResize(shift + b.mesh.node_count(), Eigen::NoChange);
  both.mesh.nodes.bottomRows(b.mesh.node_count()) = b.mesh.nodes;
  for (auto block : b.mesh.blocks) {
    for (Index& node : block.nodes)
      node += shift;
    both.mesh.blocks.push_back(block);
  }
  auto const kinematics = Kinematics::plane_strain;
  Cells const first(a, kinematics), second(b, kinematics), all(both, kinematics);
  Vector const u = random_vector(2 * both.mesh.node_count(), 0.02);
  Vector const ua = u.head(2 * shift), ub = u.tail(u.size() - 2 * shift);
  auto const step = [](Cells const& cells, Vector const& to) {
    Vector const rest = Vector::Zero(cells.memory_size());
    Vector memory = rest;
    auto const energy = cells.relax(view(to), 0.7, view(rest), view(memory));
    CHECK(energy.stored > 0);
    return memory;
  };
  Vector const memory = step(all, u), of_a = step(first, ua), of_b = step(second, ub);
  Vector const by_cell = all.by_cell(view(memory)), a_by_cell = first.by_cell(view(of_a)),
               b_by_cell = second.by_cell(view(of_b));
  REQUIRE(by_cell.size() == a_by_cell.size() + b_by_cell.size());
  CHECK((by_cell.head(a_by_cell.size()) - a_by_cell).norm() == 0);
  CHECK((by_cell.tail(b_by_cell.size()) - b_by_cell).norm() == 0);
  CHECK(b_by_cell.norm() > 0);
  CHECK((all.by_cell(view(all.from_cells(view(by_cell)))) - by_cell).norm() == 0);
  Vector const f = force_of(all, u, all.networks(view(memory), 1));
  CHECK((f.head(2 * shift) - force_of(first, ua, first.networks(view(of_a), 1))).norm() < 1e-13 * f.norm());
}

TEST_CASE("relaxation: processes that share a body remember the parts of what one does") {
  Case const each{mesh::CellKind::hex8, Kinematics::three_dimensional, solid::Interpolation::plain};
  Body const body = relaxing(each, sample_materials()[2].second, 3);
  Vector const u = random_vector(3 * body.mesh.node_count(), 0.02);
  Cells const whole(body, each.kinematics);
  Vector const rest = Vector::Zero(whole.memory_size());
  Vector memory = rest;
  auto const energy = whole.relax(view(u), 0.7, view(rest), view(memory));
  Vector sum = Vector::Zero(whole.by_cell(view(rest)).size());
  Vector const nothing = sum;
  material::NetworkEnergy<double> parts;
  std::vector<Cells> shares;
  for (int const rank : {0, 1}) {
    auto const own = [&](std::span<Index const> nodes) {
      bool const first = body.mesh.nodes(nodes[0], 0) < 2;
      return first == (rank == 0) ? solid::CellPart::all : solid::CellPart::forces;
    };
    auto const& cells = shares.emplace_back(body, each.kinematics, own);
    REQUIRE(cells.memory_size() == sum.size());
    Vector part = nothing;
    auto const found = cells.relax(view(u), 0.7, view(nothing), view(part));
    CHECK(part.norm() > 0);
    sum += part;
    parts.stored += found.stored;
    parts.dissipated += found.dissipated;
  }
  CHECK((sum - whole.by_cell(view(memory))).norm() == 0);
  CHECK(parts.stored == doctest::Approx(energy.stored).epsilon(1e-12));
  CHECK(parts.dissipated == doctest::Approx(energy.dissipated).epsilon(1e-12));
  Vector const stress = whole.stress(view(u), view(memory)).von_mises;
  CHECK((shares[1].stress(view(u), view(sum)).von_mises - stress).norm() == 0);
  CHECK((whole.stress(view(u)).von_mises - stress).norm() > 0.01 * stress.norm());
  Vector const f = force_of(whole, u, whole.networks(view(memory), 0.5));
  Vector ours = Vector::Zero(f.size());
  auto const networks = shares[0].networks(view(sum), 0.5);
  CHECK(shares[0].add_force(view(u), view(ours), &networks).sound());
  CHECK((ours - f).norm() < 1e-12 * f.norm());
}

TEST_SUITE_END();
