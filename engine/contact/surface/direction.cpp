// Of the axes, by the mean normal and by the largest part of any normal along them.
#include "contact/surface/direction.hpp"

namespace stiction::contact {

Vec3 first_direction(std::vector<mesh::Facet> const& facets, Matrix const& reference) {
  Vec3 sum = Vec3::Zero(), across = Vec3::Zero();
  for (auto const& facet : facets) {
    Vec3 const a = reference.row(facet.nodes[0]), b = reference.row(facet.nodes[1]),
               c = reference.row(facet.nodes[2]);
    Vec3 const twice = (b - a).cross(c - a);
    sum += twice;
    across = across.cwiseMax(twice.normalized().cwiseAbs());
  }
  Eigen::Index axis = 0, best = 0;
  sum.cwiseAbs().minCoeff(&axis);
  double const least = across.minCoeff(&best);
  return Vec3::Unit(across[axis] < nearly_parallel || !(least < nearly_parallel) ? axis : best);
}

} // namespace stiction::contact
