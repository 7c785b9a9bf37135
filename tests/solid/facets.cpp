// Integrals over deformed facets: their derivatives, closed surfaces, volumes.
#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <random>

#include "differences.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/topology/mesh.hpp"
#include "solid/facets.hpp"

using namespace stiction;
using solid::FacetOrder;
using solid::Kinematics;

namespace {

Point const centre(0.3, -0.2, 0.1);

Matrix shaped(Vector const& x, Eigen::Index dim) {
  return Eigen::Map<Matrix const>(x.data(), x.size() / dim, dim);
}

/// Nodes of a facet that is bent and not too odd; r > 0.
Vector bent(std::size_t nodes, int dim) {
  std::mt19937 engine(7);
  auto const off = [&] { return 0.15 * (static_cast<double>(engine() % 2001) / 1000 - 1); };
  static constexpr double corners[8][2] = {{0, 0},  {1, 0},  {1, 1},  {0, 1},
                                           {.5, 0}, {1, .5}, {.5, 1}, {0, .5}};
  static constexpr double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {.5, 0}, {.5, .5}, {0, .5}};
  static constexpr double line[3][2] = {{0, 0}, {0.2, 1}, {0.1, 0.5}};
  auto const& table = dim == 2 ? line : nodes == 3 || nodes == 6 ? triangle : corners;
  Vector x(static_cast<Eigen::Index>(nodes) * dim);
  for (std::size_t i = 0; i < nodes; ++i)
    for (int c = 0; c < dim; ++c)
      x[static_cast<Eigen::Index>(i) * dim + c] = (c == 0 ? 1.0 : 0.0) + (c < 2 ? table[i][c] : 0.0) + off();
  return x;
}

struct Kind {
  Kinematics kinematics;
  std::size_t nodes;
  [[nodiscard]] int dim() const { return solid::dimension(kinematics); }
};

std::vector<Kind> const kinds = {
    {Kinematics::plane_strain, 2},      {Kinematics::plane_strain, 3},
    {Kinematics::axisymmetric, 2},      {Kinematics::axisymmetric, 3},
    {Kinematics::three_dimensional, 3}, {Kinematics::three_dimensional, 4},
    {Kinematics::three_dimensional, 6}, {Kinematics::three_dimensional, 8},
};

/// Sums over the whole boundary of a mesh whose nodes are at x.
struct Whole {
  double volume = 0;
  Vector normals;
  Dense normals_by_x;
};
Whole whole(mesh::Mesh const& mesh, Kinematics kinematics, Vector const& x, Point const& about) {
  Whole sum{0, Vector::Zero(x.size()), Dense::Zero(x.size(), x.size())};
  int const dim = mesh.dim;
  for (auto const& facet : mesh::boundary(mesh)) {
    Indices dofs;
    Matrix own(static_cast<Eigen::Index>(facet.nodes.size()), dim);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i) {
      own.row(static_cast<Eigen::Index>(i)) = x.segment(dim * facet.nodes[i], dim).transpose();
      for (int c = 0; c < dim; ++c)
        dofs.push_back(dim * facet.nodes[i] + c);
    }
    auto const terms = solid::facet_terms(kinematics, own, about, FacetOrder::second);
    sum.volume += terms.volume;
    sum.normals(dofs) += terms.normals;
    sum.normals_by_x(dofs, dofs) += terms.normals_by_x;
  }
  return sum;
}

/// Nodes of a mesh, shaken by a tenth of its cells.
Vector shaken(mesh::Mesh const& mesh, Kinematics kinematics) {
  std::mt19937 engine(3);
  Vector x(mesh.nodes.size());
  for (Eigen::Index i = 0; i < x.size(); ++i)
    x[i] =
        mesh.nodes.reshaped<Eigen::RowMajor>()[i] + 0.05 * (static_cast<double>(engine() % 2001) / 1000 - 1);
  for (Index node = 0; kinematics == Kinematics::axisymmetric && node < mesh.node_count(); ++node)
    if (mesh.nodes(node, 0) == 0)
      x[2 * node] = 0;
  return x;
}

std::vector<std::pair<Kinematics, mesh::Mesh>> closed_meshes() {
  std::vector<std::pair<Kinematics, mesh::Mesh>> all;
  for (auto const kind : {mesh::CellKind::quad4, mesh::CellKind::tri6, mesh::CellKind::quad8})
    for (auto const kinematics : {Kinematics::plane_strain, Kinematics::axisymmetric}) {
      mesh::BlockOptions options;
      options.size = {1, 1};
      options.cells = {2, 2};
      options.kind = kind;
      all.emplace_back(kinematics, mesh::block(options));
    }
  for (auto const kind :
       {mesh::CellKind::tet4, mesh::CellKind::tet10, mesh::CellKind::hex8, mesh::CellKind::hex20}) {
    mesh::BoxOptions options;
    options.size = {1, 1, 1};
    options.cells = {1, 2, 1};
    options.kind = kind;
    all.emplace_back(Kinematics::three_dimensional, mesh::box(options));
  }
  return all;
}

} // namespace

TEST_CASE("every facet: area and normals have the derivatives that are claimed") {
  for (auto const& kind : kinds) {
    CAPTURE(static_cast<int>(kind.kinematics));
    CAPTURE(kind.nodes);
    Vector const x = bent(kind.nodes, kind.dim());
    auto const at = [&](Vector const& y) {
      return solid::facet_terms(kind.kinematics, shaped(y, kind.dim()), centre, FacetOrder::second);
    };
    auto const terms = at(x);
    auto const first = test::rate([&](Vector const& y) { return Vector::Constant(1, at(y).area).eval(); },
                                  Dense(terms.area_by_x.transpose()), x, 1e-2);
    INFO(first.words());
    CHECK(first.second_order);
    auto const second =
        test::rate([&](Vector const& y) { return Vector(at(y).area_by_x); }, terms.area_by_x2, x, 1e-2);
    INFO(second.words());
    CHECK(second.second_order);
    CHECK(terms.area_by_x2.isApprox(terms.area_by_x2.transpose(), 1e-13));
    auto const normals =
        test::rate([&](Vector const& y) { return Vector(at(y).normals); }, terms.normals_by_x, x, 1e-2);
    INFO(normals.words());
    CHECK(normals.second_order);
  }
}

TEST_CASE("closed surfaces: normals sum to nothing, with their moments, and are how the volume grows") {
  for (auto const& one : closed_meshes()) {
    auto const kinematics = one.first;
    auto const& mesh = one.second;
    CAPTURE(static_cast<int>(kinematics));
    CAPTURE(mesh::info(mesh.blocks[0].kind).name);
    Vector const x = shaken(mesh, kinematics);
    auto const sum = whole(mesh, kinematics, x, centre);
    int const dim = mesh.dim;
    Point force = Point::Zero(), moment = Point::Zero();
    for (Index i = 0; i < mesh.node_count(); ++i) {
      Point N = Point::Zero(), X = Point::Zero();
      N.head(dim) = sum.normals.segment(dim * i, dim);
      X.head(dim) = x.segment(dim * i, dim);
      force += N;
      moment += X.cross(N);
    }
    if (kinematics == Kinematics::axisymmetric)
      CHECK(std::abs(force.y()) < 1e-13);
    else
      CHECK(std::max(force.norm(), moment.norm()) < 1e-13);
    Vector way = sum.normals;
    for (Eigen::Index i = 0; i < way.size(); ++i) // nodes on the axis stay there
      way[i] = kinematics == Kinematics::axisymmetric && i % 2 == 0 && x[i] == 0 ? 0 : way[i];
    double const h = 1e-4, exact = sum.normals.dot(way),
                 grown = (whole(mesh, kinematics, x + h * way, centre).volume -
                          whole(mesh, kinematics, x - h * way, centre).volume) /
                         (2 * h);
    CHECK(grown == doctest::Approx(exact).epsilon(1e-7));
    if (kinematics != Kinematics::axisymmetric) // there the axis is an edge, held
      CHECK(sum.normals_by_x.isApprox(sum.normals_by_x.transpose(), 1e-12));
  }
}

TEST_CASE(
    "a facet with skirts at its sides: its volume over the plane has the derivatives that are claimed") {
  for (auto const& kind : kinds) {
    CAPTURE(static_cast<int>(kind.kinematics));
    CAPTURE(kind.nodes);
    int const dim = kind.dim();
    solid::Plane plane{centre, Point(0, 1, 0)};
    if (kind.kinematics != Kinematics::axisymmetric)
      plane.normal.head(dim) = Point(0.6, -0.48, 0.64).head(dim).normalized();
    auto const at = [&](Vector const& y) {
      Matrix const x = shaped(y, dim);
      auto terms = solid::facet_terms(kind.kinematics, x, centre, FacetOrder::second);
      for (int side = 0; side < solid::sides_of(kind.nodes, dim); ++side)
        solid::add_skirt(kind.kinematics, x, side, plane, terms);
      return terms;
    };
    Vector const x = bent(kind.nodes, dim);
    auto const terms = at(x);
    auto const first = test::rate([&](Vector const& y) { return Vector::Constant(1, at(y).volume).eval(); },
                                  Dense(terms.normals.transpose()), x, 1e-2);
    INFO(first.words());
    CHECK(first.second_order);
    auto const second =
        test::rate([&](Vector const& y) { return Vector(at(y).normals); }, terms.normals_by_x, x, 1e-2);
    INFO(second.words());
    CHECK(second.second_order);
    CHECK(terms.normals_by_x.isApprox(terms.normals_by_x.transpose(), 1e-12));
  }
}
