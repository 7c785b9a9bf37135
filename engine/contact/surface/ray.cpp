// Newton's method for the foot of a ray on one facet, and the walk across sides.
#include "contact/surface/ray.hpp"

#include <Eigen/LU>
#include <cmath>

#include "contact/surface/facet.hpp"

namespace stiction::contact {

namespace {

/// Cosine between a facet's normal and the ray below which it does not face it.
constexpr double least_facing = 0.1;
/// Local coordinates at which a search has left a facet.
constexpr double left = 5;

template<int D>
bool faces(CellSurface const& surface, int facet, Vec2 const& at, Ray<D> const& ray, Positions x) {
  Vec<D> const normal = surface.normal<D>(facet, at, x);
  return normal.dot(ray.along) > least_facing * normal.norm();
}

/// The side to leave by: the one farthest behind, if it leads to a facet that faces the ray; borders come
/// last.
struct Leave {
  int side = -1; ///< -1: none, the point is on the facet
  bool border = false;
};

template<int D>
Leave leave(CellSurface const& surface, int number, Vec2 const& at, Ray<D> const& ray, Positions x) {
  auto const& facet = surface.facet(number);
  Leave inner, outer{-1, true};
  double least_inner = -on_side, least_outer = -on_side;
  for (int k = 0; k < facet.corners(); ++k) {
    double const here = inside_of(facet.kind, k, at);
    if (here >= -on_side)
      continue;
    int const next = facet.neighbour[ix(k)];
    bool const open =
        next < 0 || !faces(surface, next,
                           coordinates_on_side(surface.facet(next).kind, facet.across[ix(k)],
                                               1 - std::clamp(part_of_side(facet.kind, k, at), 0.0, 1.0)),
                           ray, x);
    double& least = open ? least_outer : least_inner;
    if (here < least) {
      least = here;
      (open ? outer : inner).side = k;
    }
  }
  return inner.side >= 0 ? inner : outer;
}

} // namespace

template<int D>
bool meet_facet(FacetKind kind, FacetNodes<D> const& nodes, Ray<D> const& ray, Vec2& at, double& gap) {
  double last = 1e300;
  double const rounding = rounding_step(ray.from.cwiseAbs().maxCoeff(), (nodes.col(1) - nodes.col(0)).norm());
  for (int iteration = 0; iteration < 30; ++iteration) {
    auto const shape = facet_shape(kind, at);
    Mat<D> J;
    J << tangents_of<D>(nodes, shape), ray.along;
    Vec<D> const solution = J.inverse() * (ray.from - nodes * shape.N);
    double const size = solution.template head<D - 1>().norm();
    if (!std::isfinite(size))
      return false;
    gap = solution[D - 1];
    double const part = size > 2 ? 2 / size : 1;
    at.template head<D - 1>() += part * solution.template head<D - 1>();
    if (size < 1e-13 || (size < rounding && size > 0.5 * last) || at.norm() > left)
      return true;
    last = size;
  }
  return false;
}

template<int D>
Foot meet(CellSurface const& surface, Ray<D> const& ray, Foot start, double overhang, Positions x) {
  if (!start.found())
    return {};
  int number = start.segment;
  Vec2 at(start.xi, start.eta);
  for (int walked = 0; walked < 200; ++walked) {
    auto const& facet = surface.facet(number);
    double gap = 0;
    if (!meet_facet<D>(facet.kind, surface.positions<D>(number, x), ray, at, gap))
      return {};
    auto const [side, border] = leave(surface, number, at, ray, x);
    if (side < 0 || border) {
      bool const near = side < 0 || inside_of(facet.kind, side, at) >= -overhang;
      return near && faces(surface, number, at, ray, x) ? Foot{number, at.x(), at.y()} : Foot{};
    }
    int const next = facet.neighbour[ix(side)];
    double const part = std::clamp(part_of_side(facet.kind, side, at), 0.0, 1.0);
    at = coordinates_on_side(surface.facet(next).kind, facet.across[ix(side)], 1 - part);
    number = next;
  }
  return {};
}

template bool meet_facet<2>(FacetKind, FacetNodes<2> const&, Ray<2> const&, Vec2&, double&);
template bool meet_facet<3>(FacetKind, FacetNodes<3> const&, Ray<3> const&, Vec2&, double&);
template Foot meet<2>(CellSurface const&, Ray<2> const&, Foot, double, Positions);
template Foot meet<3>(CellSurface const&, Ray<3> const&, Foot, double, Positions);

} // namespace stiction::contact
