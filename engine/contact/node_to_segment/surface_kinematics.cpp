// Gap, slip, rows of H and geometric stiffness of a point against a surface in space.
#include <Eigen/LU>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "contact/node_to_segment/kinematics.hpp"
#include "contact/surface/surface_path.hpp"

namespace stiction::contact {

namespace {

/// On an edge this near (in facets) the direction to the point says nothing; the facet's own normal is taken.
constexpr double on_edge = 1e-6;

/// At a gap of so many facets the couple of a tangential force is rounding, and what it turns by is nothing.
constexpr double no_couple = 1e-12, no_turn = 1e-6;

/// Derivatives by the point (3), the facet's nodes, their normals and their two tangents (12 each); padded.
constexpr int inputs_of_point = 51;
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 52, 1>>;

/// All that the forces of one point depend on.
template<class T> struct Inputs {
  Vec3Of<T> point;
  std::array<Vec3Of<T>, 4> x, normals, first, second;
};

/// Two material directions at a corner, as sums over nodes around it: they are carried along with the surface
/// and, like the normals, the same for all facets that meet there.
struct Carrier {
  struct Part {
    Index node;
    Vec2 factors; ///< 1/m, of the first and the second; each sums to zero
  };
  std::vector<Part> parts;

  void add(Index node, Vec2 const& factors) {
    for (auto& part : parts)
      if (part.node == node) {
        part.factors += factors;
        return;
      }
    parts.push_back({node, factors});
  }
  [[nodiscard]] Vec3 direction(int which, std::span<double const> x) const {
    Vec3 sum = Vec3::Zero();
    for (auto const& part : parts)
      sum += part.factors[which] * Eigen::Map<Vec3 const>(&x[3 * ix(part.node)]);
    return sum;
  }
};

/// Adds a facet's share at its corner `at`: the parts along the facet of `direction` and across it.
void add_facet(Facet const& facet, int at, Vec3 const& direction, Carrier& carrier) {
  Vec2 const at_node = node_coordinates(facet.count, at);
  auto const N = shape(facet.count, at_node.x(), at_node.y());
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << combine<double>(N.by_xi, facet.reference, facet.count),
      combine<double>(N.by_eta, facet.reference, facet.count);
  Eigen::Matrix<double, 3, 2> wanted;
  wanted << direction, tangents.col(0).cross(tangents.col(1)).normalized().cross(direction);
  double const area = area_vector(facet.reference, facet.count).norm();
  Mat<2> const parts =
      area * (tangents.transpose() * tangents).inverse() * (tangents.transpose() * wanted); // contravariant
  for (int j = 0; j < facet.count; ++j)
    carrier.add(facet.nodes[ix(j)],
                parts.row(0).transpose() * N.by_xi[ix(j)] + parts.row(1).transpose() * N.by_eta[ix(j)]);
}

/// Of a facet's corners.
std::array<Carrier, 4> carriers(Surface const& surface, int number) {
  auto const& facet = surface.facets()[ix(number)];
  std::array<Carrier, 4> all;
  for (int k = 0; k < facet.count; ++k) {
    double area = 0;
    for (int const f : surface.fan(facet.corner[ix(k)])) {
      auto const& other = surface.facets()[ix(f)];
      auto const* end = other.nodes.data() + other.count;
      auto const* own = std::find(other.nodes.data(), end, facet.nodes[ix(k)]);
      add_facet(other, static_cast<int>(own - other.nodes.data()), facet.direction, all[ix(k)]);
      area += area_vector(other.reference, other.count).norm();
    }
    for (auto& part : all[ix(k)].parts)
      part.factors /= area;
  }
  return all;
}

template<class T> T dot(Vec3Of<T> const& a, Vec3Of<T> const& b) {
  T sum = a[0] * b[0];
  sum += a[1] * b[1];
  sum += a[2] * b[2];
  return sum;
}
template<class T> Vec3Of<T> cross(Vec3Of<T> const& a, Vec3Of<T> const& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}
/// sum of scaled vectors
template<class T> Vec3Of<T> sum(T const& u, Vec3Of<T> const& a, T const& v, Vec3Of<T> const& b) {
  return {T(u * a[0] + v * b[0]), T(u * a[1] + v * b[1]), T(u * a[2] + v * b[2])};
}
template<class T> Vec3Of<T> unit(Vec3Of<T> const& a) {
  using std::sqrt;
  T const scale = T(1.0) / T(sqrt(dot(a, a)));
  return {T(a[0] * scale), T(a[1] * scale), T(a[2] * scale)};
}

double value(double x) {
  return x;
}
double value(Dual const& x) {
  return x.value();
}

template<class T> struct Local2 { T xi, eta; };

/// The pairing at one foot.
template<class T> struct Pairing {
  Shape<T> N;
  Vec3Of<T> d, first, second; ///< x1 - x2; material directions
  Vec3Of<T> n, t1, t2;
  T gap;
};

template<class T> Vec3Of<T> normal_of(Facet const& facet, Inputs<T> const& in, std::array<T, 4> const& N) {
  return unit(combine<T>(N, in.normals, facet.count));
}

/// Normal and gap. In the wedge of an edge the normal points along x1 - x2, outward.
template<class T>
void point_normal(Facet const& facet, Inputs<T> const& in, FootFeature const& kind, Pairing<T>& p) {
  p.n = normal_of(facet, in, p.N.N);
  p.gap = dot(p.n, p.d);
  T const distance2 = dot(p.d, p.d);
  double const size2 = area_vector(facet.reference, facet.count).norm();
  if (kind.kind == FootFeature::face || value(distance2) < on_edge * on_edge * size2)
    return;
  using std::sqrt;
  double const side = value(p.gap) < 0 ? -1 : 1;
  p.gap = T(side * T(sqrt(distance2)));
  T const scale = T(1.0) / p.gap;
  p.n = {T(p.d[0] * scale), T(p.d[1] * scale), T(p.d[2] * scale)};
}

/// t1 is the first material direction in the plane across n.
template<class T> void turn_tangents(Pairing<T>& p) {
  p.t1 = unit(sum(T(1.0), p.first, T(-dot(p.n, p.first)), p.n));
  p.t2 = cross(p.n, p.t1);
}

template<class T>
Pairing<T> pair_at(Facet const& facet, Inputs<T> const& in, FootFeature const& kind, Local2<T> const& at) {
  Pairing<T> p;
  p.N = shape<T>(facet.count, at.xi, at.eta);
  p.d = sum(T(1.0), in.point, T(-1.0), combine<T>(p.N.N, in.x, facet.count));
  p.first = combine<T>(p.N.N, in.first, facet.count);
  p.second = combine<T>(p.N.N, in.second, facet.count);
  point_normal(facet, in, kind, p);
  turn_tangents(p);
  return p;
}

/// H^T f: forces on the point and on each node of the facet, and of both material directions at each node
/// the force along n that their parts share. A tangential force at a distance makes a moment, which the
/// surface bears by forces along n: c_b with (a_b . t_a) c_b = g f_a for the directions a_b.
template<class T> struct NodalForces {
  std::array<Vec3Of<T>, 5> own;
  std::array<std::array<Vec3Of<T>, 4>, 2> shared;
};
template<class T> NodalForces<T> nodal_forces(Pairing<T> const& p, int count, Vec3 const& f) {
  Vec3Of<T> const tangential = sum(T(f[1]), p.t1, T(f[2]), p.t2);
  Vec3Of<T> const force = sum(T(f[0]), p.n, T(1.0), tangential);
  T const a1 = dot(p.first, p.t1), a2 = dot(p.first, p.t2), b1 = dot(p.second, p.t1),
          b2 = dot(p.second, p.t2);
  T const scale = p.gap / T(a1 * b2 - b1 * a2);
  T const c1 = scale * T(f[1] * b2 - f[2] * b1), c2 = scale * T(f[2] * a1 - f[1] * a2);
  NodalForces<T> forces;
  forces.own[0] = force;
  for (std::size_t k = 0; k < ix(count); ++k) {
    T const N = p.N.N[k], first = N * c1, second = N * c2;
    for (int c = 0; c < 3; ++c) {
      forces.own[k + 1][c] = -N * force[c];
      forces.shared[0][k][c] = first * p.n[c];
      forces.shared[1][k][c] = second * p.n[c];
    }
  }
  return forces;
}

Inputs<double> inputs(Surface const& surface, Foot const& foot, Index node,
                      std::array<Carrier, 4> const& carried, std::span<double const> x) {
  auto const now = surface.now(foot.segment, x);
  Inputs<double> in{Eigen::Map<Vec3 const>(&x[3 * ix(node)]), now.x, now.normals, {}, {}};
  for (std::size_t k = 0; k < 4; ++k) {
    in.first[k] = carried[k].direction(0, x);
    in.second[k] = carried[k].direction(1, x);
  }
  return in;
}

Inputs<Dual> with_derivatives(Inputs<double> const& in) {
  auto const dual = [](Vec3 const& v, int first) -> Vec3Of<Dual> {
    return {Dual(v[0], 52, first), Dual(v[1], 52, first + 1), Dual(v[2], 52, first + 2)};
  };
  Inputs<Dual> result;
  result.point = dual(in.point, 0);
  for (int k = 0; k < 4; ++k) {
    result.x[ix(k)] = dual(in.x[ix(k)], 3 + 3 * k);
    result.normals[ix(k)] = dual(in.normals[ix(k)], 15 + 3 * k);
    result.first[ix(k)] = dual(in.first[ix(k)], 27 + 3 * k);
    result.second[ix(k)] = dual(in.second[ix(k)], 39 + 3 * k);
  }
  return result;
}

/// d(x2 + g n) by (xi, eta, g).
Matrix3 pairing_jacobian(Facet const& facet, Inputs<double> const& in, Foot const& foot, double gap) {
  auto const N = shape(facet.count, foot.xi, foot.eta);
  Vec3 const sum = combine<double>(N.N, in.normals, facet.count), n = sum.normalized();
  Matrix3 const across = (Matrix3::Identity() - n * n.transpose()) * (gap / sum.norm());
  Matrix3 J;
  J.col(0) = combine<double>(N.by_xi, in.x, facet.count) +
             across * combine<double>(N.by_xi, in.normals, facet.count);
  J.col(1) = combine<double>(N.by_eta, in.x, facet.count) +
             across * combine<double>(N.by_eta, in.normals, facet.count);
  J.col(2) = n;
  return J;
}

/// The foot with its derivatives: on a facet by one Newton step from where the residual vanishes, on an edge
/// as the foot of the perpendicular.
Local2<Dual> foot_with_derivatives(Facet const& facet, Inputs<Dual> const& in, Foot const& foot,
                                   Matrix3 const& J) {
  auto const kind = FootFeature::of(foot);
  Local2<Dual> at{Dual(foot.xi), Dual(foot.eta)};
  if (kind.kind == FootFeature::vertex)
    return at;
  if (kind.kind == FootFeature::edge) {
    auto const first = ix(kind.side), last = ix((kind.side + 1) % facet.count);
    Vec3Of<Dual> const along = sum(Dual(1.0), in.x[last], Dual(-1.0), in.x[first]);
    Vec3Of<Dual> const d = sum(Dual(1.0), in.point, Dual(-1.0), in.x[first]);
    Dual const part = dot(d, along) / dot(along, along);
    Vec2 const from = node_coordinates(facet.count, kind.side),
               step = node_coordinates(facet.count, (kind.side + 1) % facet.count) - from;
    return {Dual(from.x() + part * step.x()), Dual(from.y() + part * step.y())};
  }
  auto const N = shape<Dual>(facet.count, at.xi, at.eta);
  Vec3Of<Dual> const n = normal_of(facet, in, N.N);
  Vec3Of<Dual> const d = sum(Dual(1.0), in.point, Dual(-1.0), combine<Dual>(N.N, in.x, facet.count));
  Vec3Of<Dual> const rest = sum(Dual(1.0), d, Dual(-value(dot(n, d))), n);
  Matrix3 const inverse = J.inverse();
  at.xi.derivatives() = inverse(0, 0) * rest[0].derivatives() + inverse(0, 1) * rest[1].derivatives() +
                        inverse(0, 2) * rest[2].derivatives();
  at.eta.derivatives() = inverse(1, 0) * rest[0].derivatives() + inverse(1, 1) * rest[1].derivatives() +
                         inverse(1, 2) * rest[2].derivatives();
  return at;
}

/// Which a node is among the point's, the first being its own.
int slot_of(Indices const& nodes, Index node) {
  return static_cast<int>(std::find(nodes.begin() + 1, nodes.end(), node) - nodes.begin());
}

/// From the foot at the step's start to the present one.
SurfacePath path_of(Surface const& surface, PointKinematics<3> const& point, Foot start,
                    std::span<double const> x) {
  return {surface, start, {point.foot, point.normal()}, x};
}

PointKinematics<3> kinematics_at(Surface const& surface, Index node, Foot start, Foot foot,
                                 std::span<double const> x) {
  PointKinematics<3> point;
  point.foot = foot;
  point.found = foot.found();
  if (!point.found)
    return point;
  auto const& facet = surface.facets()[ix(foot.segment)];
  auto const carried = carriers(surface, foot.segment);
  auto const in = inputs(surface, foot, node, carried, x);
  auto const pairing = pair_at<double>(facet, in, FootFeature::of(foot), {foot.xi, foot.eta});
  point.gap = pairing.gap;
  point.frame << pairing.n, pairing.t1, pairing.t2;
  if (start.found())
    point.slip = point.frame.rightCols<2>().transpose() * path_of(surface, point, start, x).slip();
  auto const stencil = surface.stencil(foot.segment);
  point.count = 1 + static_cast<int>(stencil.size());
  point.nodes.assign(1, node);
  point.nodes.insert(point.nodes.end(), stencil.begin(), stencil.end());
  point.H.setZero(3, point.unknowns());
  for (int row = 0; row < 3; ++row) {
    auto const forces = nodal_forces(pairing, facet.count, Vec3::Unit(row));
    for (int k = 0; k <= facet.count; ++k)
      point.H.block<1, 3>(row, 3 * k) = forces.own[ix(k)].transpose();
    if (row == 0 || std::abs(point.gap) < no_couple * surface.facet_size())
      continue;
    for (int k = 0; k < facet.count; ++k)
      for (auto const& [other, factors] : carried[ix(k)].parts)
        point.H.block<1, 3>(row, 3 * slot_of(point.nodes, other)) +=
            factors[0] * forces.shared[0][ix(k)].transpose() +
            factors[1] * forces.shared[1][ix(k)].transpose();
  }
  return point;
}

/// Derivatives by the positions of nodes, row by row, to be added to.
struct Columns {
  Surface const& surface;
  std::span<double const> x;
  Indices const& nodes;
  Eigen::Ref<Dense> by_x;

  void add_node(Index node, Eigen::Ref<Dense const> const& by) {
    by_x.block(0, 3 * slot_of(nodes, node), by.rows(), 3) += by;
  }
  /// What the motion of nodes does through the nodal normal of a corner.
  void add_normal(int corner, Eigen::Ref<Dense const> const& by_normal) {
    auto const fan = surface.fan(corner);
    Vec3 area = Vec3::Zero();
    for (int const f : fan)
      area += area_vector(surface.positions(f, x), surface.facets()[ix(f)].count);
    Vec3 const n = area.normalized();
    Eigen::Matrix<double, Eigen::Dynamic, 3> const by_area =
        by_normal * (Matrix3::Identity() - n * n.transpose()) * (0.5 / area.norm());
    for (int const f : fan) {
      auto const& facet = surface.facets()[ix(f)];
      auto const at = surface.positions(f, x);
      for (int i = 0; i < facet.count; ++i) { // area = 1/2 sum_i x_i x x_{i+1}
        Vec3 const e = at[ix((i + 1) % facet.count)] - at[ix((i + facet.count - 1) % facet.count)];
        Matrix3 turn;
        turn << 0, e.z(), -e.y(), -e.z(), 0, e.x(), e.y(), -e.x(), 0; // dx x e
        add_node(facet.nodes[ix(i)], by_area * turn);
      }
    }
  }
};

/// By the inputs, row by row.
using ByInputs = Eigen::Matrix<double, Eigen::Dynamic, inputs_of_point>;

/// Deals the derivatives by the inputs of a facet out to the nodes.
void add_inputs(Facet const& facet, std::array<Carrier, 4> const& carried, ByInputs const& by_input,
                Columns columns) {
  int const own = 3 * (1 + facet.count);
  columns.by_x.topLeftCorner(by_input.rows(), own) += by_input.leftCols(own);
  for (int k = 0; k < facet.count; ++k) {
    columns.add_normal(facet.corner[ix(k)], by_input.middleCols<3>(15 + 3 * k));
    for (auto const& [node, factors] : carried[ix(k)].parts)
      columns.add_node(node, factors[0] * by_input.middleCols<3>(27 + 3 * k) +
                                 factors[1] * by_input.middleCols<3>(39 + 3 * k));
  }
}

/// The forces' derivatives by the inputs, those that several nodes share dealt out to them where `couples`.
ByInputs by_inputs(PointKinematics<3> const& point, NodalForces<Dual> const& forces, int count,
                   std::array<Carrier, 4> const* couples) {
  auto const derivatives = [](Vec3Of<Dual> const& force) {
    Eigen::Matrix<double, 3, inputs_of_point> by;
    for (int c = 0; c < 3; ++c)
      by.row(c) = force[c].derivatives().head<inputs_of_point>().transpose();
    return by;
  };
  ByInputs by = ByInputs::Zero(couples != nullptr ? point.unknowns() : 3 * (1 + count), inputs_of_point);
  for (int k = 0; k <= count; ++k)
    by.middleRows<3>(3 * k) = derivatives(forces.own[ix(k)]);
  for (int k = 0; couples != nullptr && k < count; ++k)
    for (int which = 0; which < 2; ++which) {
      auto const shared = derivatives(forces.shared[ix(which)][ix(k)]);
      for (auto const& [node, factors] : (*couples)[ix(k)].parts)
        by.middleRows<3>(3 * slot_of(point.nodes, node)) += factors[which] * shared;
    }
  return by;
}

} // namespace

PointKinematics<3> kinematics(Surface const& surface, Index node, Foot start, Foot guess,
                              std::span<double const> x) {
  Vec3 const p1 = Eigen::Map<Vec3 const>(&x[3 * ix(node)]);
  return kinematics_at(surface, node, start, surface.project(p1, guess, x), x);
}

PointKinematics<3> kinematics(Search<3> const& search, Index node, Start const& start, Foot guess,
                              std::span<double const> x) {
  Vec3 const p1 = Eigen::Map<Vec3 const>(&x[3 * ix(node)]);
  return kinematics_at(search.primary(), node, start.foot, search.project(node, p1, guess, x, start.overhang),
                       x);
}

Block<3> geometric_stiffness(Surface const& surface, PointKinematics<3> const& point,
                             std::span<double const> x, Vec3 const& force_ntt) {
  auto const& facet = surface.facets()[ix(point.foot.segment)];
  auto const carried = carriers(surface, point.foot.segment);
  auto const in = inputs(surface, point.foot, point.nodes[0], carried, x);
  auto const dual = with_derivatives(in);
  auto const at =
      foot_with_derivatives(facet, dual, point.foot, pairing_jacobian(facet, in, point.foot, point.gap));
  auto const forces =
      nodal_forces(pair_at<Dual>(facet, dual, FootFeature::of(point.foot), at), facet.count, force_ntt);
  bool const couples = !force_ntt.tail<2>().isZero(0) && std::abs(point.gap) > no_turn * surface.facet_size();
  auto const by_input = by_inputs(point, forces, facet.count, couples ? &carried : nullptr);
  int const n = point.unknowns();
  Dense K = Dense::Zero(n, n);
  add_inputs(facet, carried, by_input, {surface, x, point.nodes, K});
  return K;
}

namespace {

/// Derivatives of a vector by the inputs.
Eigen::Matrix<double, 3, inputs_of_point> derivatives(Vec3Of<Dual> const& v) {
  Eigen::Matrix<double, 3, inputs_of_point> by;
  for (int c = 0; c < 3; ++c)
    by.row(c) = v[c].derivatives().head<inputs_of_point>().transpose();
  return by;
}

/// Adds what a station at a side, or at the start of the way, does to the slip.
void add_station(Station const& station, Foot start, SurfacePath::Change const& change, Columns columns) {
  bool const at_start = station.side < 0;
  auto const& surface = columns.surface;
  int const number = at_start ? start.segment : station.facet;
  auto const& facet = surface.facets()[ix(number)];
  Vec2 const at =
      at_start ? Vec2(start.xi, start.eta) : side_coordinates(facet.count, station.side, station.part);
  auto const N = shape(facet.count, at.x(), at.y()).N;
  auto const normals = surface.now(number, columns.x).normals;
  Vec3 const sum = combine<double>(N, normals, facet.count), n = sum.normalized();
  Eigen::Matrix<double, 2, 3> const by_sum =
      change.by_n * (Matrix3::Identity() - n * n.transpose()) / sum.norm();
  Columns slip{surface, columns.x, columns.nodes, columns.by_x.bottomRows(2)};
  for (int k = 0; k < facet.count; ++k) {
    if (N[ix(k)] == 0)
      continue;
    slip.add_node(facet.nodes[ix(k)], N[ix(k)] * change.by_x);
    slip.add_normal(facet.corner[ix(k)], N[ix(k)] * by_sum);
  }
}

/// The point's, and those that make facets and normals along the way.
Indices nodes_along(Surface const& surface, PointKinematics<3> const& point, Foot start,
                    SurfacePath const& path) {
  Indices nodes(point.nodes.begin(), point.nodes.begin() + point.count);
  auto const add = [&](int facet) {
    for (Index const node : surface.stencil(facet))
      if (slot_of(nodes, node) == static_cast<int>(nodes.size()))
        nodes.push_back(node);
  };
  add(start.segment);
  for (auto const& station : path.stations())
    if (station.side >= 0)
      add(station.facet);
  return nodes;
}

} // namespace

MotionRows motion_rows(Surface const& surface, PointKinematics<3> const& point, Foot start,
                       std::span<double const> x) {
  auto const& facet = surface.facets()[ix(point.foot.segment)];
  auto const carried = carriers(surface, point.foot.segment);
  auto const in = inputs(surface, point.foot, point.nodes[0], carried, x);
  auto const dual = with_derivatives(in);
  auto const at =
      foot_with_derivatives(facet, dual, point.foot, pairing_jacobian(facet, in, point.foot, point.gap));
  auto const pairing = pair_at<Dual>(facet, dual, FootFeature::of(point.foot), at);
  ByInputs by_input = ByInputs::Zero(3, inputs_of_point);
  by_input.row(0) = pairing.gap.derivatives().head<inputs_of_point>().transpose();
  MotionRows rows;
  if (!start.found())
    start = point.foot; // no way yet
  auto const path = path_of(surface, point, start, x);
  SurfacePath::Changes changes;
  path.differentiate(point.frame.rightCols<2>().transpose(), changes);
  auto const stations = path.stations();
  auto const& end = changes[stations.size() - 1];
  Vec3 const slip = path.slip();
  auto const by_foot = derivatives(combine<Dual>(pairing.N.N, dual.x, facet.count));
  by_input.bottomRows<2>() = end.by_x * by_foot + end.by_n * derivatives(pairing.n);
  by_input.row(1) += slip.transpose() * derivatives(pairing.t1);
  by_input.row(2) += slip.transpose() * derivatives(pairing.t2);
  rows.nodes = nodes_along(surface, point, start, path);
  Dense by_x = Dense::Zero(3, 3 * static_cast<Index>(rows.nodes.size()));
  Columns columns{surface, x, rows.nodes, by_x};
  add_inputs(facet, carried, by_input, columns);
  for (std::size_t k = 0; k + 1 < stations.size(); ++k)
    add_station(stations[k], start, changes[k], columns);
  rows.by_x = by_x;
  return rows;
}

} // namespace stiction::contact
