// The way along a surface in space from one foot to another, and the slip that it makes.
#pragma once
#include <utility>

#include "contact/surface/surface.hpp"

namespace stiction::contact {

/// A point of a way and the surface's normal there.
struct Station {
  Vec3 x, n;
  int facet = -1, side = -1; ///< leaves the facet across that side; side -1: an end of the way
  double part = 0;           ///< of the side
};

/// Where the plane through both ends and the mean of their normals meets the facets between. The normals are
/// those of the field, so that the way changes steadily as its ends pass sides and vertices.
class SurfacePath {
public:
  /// Facets that a way may pass; a longer one is straight through space.
  static constexpr int longest = 64;

  /// `to` with the normal n there, which the field has not in the wedge of an edge.
  SurfacePath(Surface const& surface, Foot from, std::pair<Foot, Vec3> const& to, std::span<double const> x);

  /// The vectors from station to station, each along the surface midway between its ends, turned with the
  /// normals to the end of the way and added up there, m. Across whole facets of a cylinder: their length.
  [[nodiscard]] Vec3 slip() const;

  /// How slip changes with a station and the normal there.
  struct Change {
    Eigen::Matrix<double, 2, 3> by_x, by_n;
  };
  using Changes = std::array<Change, 2 * longest + 2>;
  /// Of the slip's components along `tangents`: the first changes as there are stations. Those at sides are
  /// then material points: where the plane meets the sides is in the changes with both ends.
  void differentiate(Eigen::Matrix<double, 2, 3> const& tangents, Changes& changes) const;

  [[nodiscard]] std::span<Station const> stations() const { return {stations_.data(), ix(count_)}; }

private:
  [[nodiscard]] bool walk(Foot const& from, Foot const& to);
  [[nodiscard]] bool holds(int facet, Foot const& foot) const;
  [[nodiscard]] Station first_exit(Foot const& from, Foot const& to) const;
  [[nodiscard]] Station exit(int facet, int entry) const;
  void pass(Station const& crossing);
  void add(Station const& station) { stations_[ix(count_++)] = station; }
  void follow_sides(Changes& changes) const;

  Surface const* surface_;
  std::span<double const> x_;
  Vec3 from_, chord_, plane_; ///< start, way through space, normal of the plane
  std::array<Station, 2 * longest + 2> stations_;
  int count_ = 0;
};

} // namespace stiction::contact
