// How far a half space in place of a block under a rigid counterpart is off: a bound from leading terms.
#pragma once

namespace stiction::scene {

/// A round block on a rigid base, sides free, pressed without friction by what is round about the same axis.
struct Reach {
  double contact = 0;   ///< its largest radius a, m
  double slope = 0;     ///< depth / a, of a sphere a/R; of adhesion its traction over E* where that is more
  double thickness = 0; ///< h, m
  double width = 0;     ///< radius L of the block, m
  double poisson = 0;
  bool stuck = false;        ///< does the base hold it along, too?
  bool small_strain = false; ///< is its law without large strains?
  double softening = 0;      ///< what its law loses of its stiffness in compression, 1
  double balance = 1; ///< sum of what presses and what pulls over the larger of force and pull-off; 1: dry
};

/// By how much the block's force is larger or smaller than the half space's at the same approach, over it; of
/// adhesion the pull-off, too, over the larger of the two. Each at most about.
struct ReachError {
  double base = 0;                ///< larger, by the base below
  double sides = 0;               ///< smaller, by sides that give way; not beside the base
  double larger = 0, smaller = 0; ///< by strains and slopes
  [[nodiscard]] double total() const;
};

/// int_0^inf 1 - M(t) dt, M the compliance of a layer under waves of length 2 pi h / t over that of the half
/// space: what a rigid base at h takes from the depth of a point load P is c P / (pi E* h) (Johnson 1985,
/// 5.8). 1.17 without friction at the base; where it is stuck 1.21 at nu = 0 and 1.77 at 0.5.
[[nodiscard]] double base_number(double poisson, bool stuck);

[[nodiscard]] ReachError error_of(Reach const& reach);

/// a of a sphere on a half space under JKR's adhesion at this approach, m; without work Hertz's. The largest
/// for any range of the same work.
[[nodiscard]] double contact_radius(double depth, double radius, double work_over_modulus);

} // namespace stiction::scene
