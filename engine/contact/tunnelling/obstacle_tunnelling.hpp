// Whether a step carried a point through a rigid obstacle, told from where both were at its start and at its
// end.
#pragma once
#include "contact/node_to_segment/kinematics.hpp"

namespace stiction::contact {

/// A point's way through a step, as an obstacle sees it that moves and turns steadily.
template<int D> class RelativeWay {
public:
  /// from, to: positions of the point, m; the obstacle is at `first`, then at `last`.
  RelativeWay(Vec<D> const& from, Vec<D> const& to, Pose<D> const& first, Pose<D> const& last);
  /// In the obstacle's frame a part t of the step, m.
  [[nodiscard]] Vec<D> at(double t) const;
  /// No part of the way is longer than this times that part of the step, m.
  [[nodiscard]] double length() const { return length_; }

private:
  Vec<D> arm_, move_; ///< from the obstacle's position to the point at the start, and how that changes, m
  Pose<D> first_;
  Vec3 axis_ = Vec3::UnitZ();
  double angle_ = 0; ///< rad
  double length_ = 0;
};

/// Depths, in parts of a pair's reach: less is not told from lying on the surface; a start, or a point that
/// comes in past a border, may be so deep; more is no contact any longer.
inline constexpr double least_depth = 0.1, most_overlap = 0.2, most_depth = 6;

/// What contact says of the ends of a way.
struct WayEnds {
  double reach = 0;  ///< of the pair, m
  bool held = false; ///< contact or a bond acts on the point at the end: it may have slid round the surface
  Foot first, last;  ///< where to start looking; not found if unknown
};

/// True if the way enters the obstacle from outside and leaves it elsewhere, or ends in it out of contact.
template<int D>
[[nodiscard]] bool passes(Obstacle const& obstacle, RelativeWay<D> const& way, WayEnds const& ends);

} // namespace stiction::contact
