// Contact points on nodes that move as one, like the two ends of a periodic side.
#pragma once
#include "contact/node_to_segment/kinematics.hpp"
#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

/// A point and a later one of the same pair, or of one with the same law, both numbered through all points of
/// the model.
struct Twin {
  Index first, second;
};

/// Two points with one motion between them could share a reaction in any way: their problem is singular. As
/// long as they are alike one of them acts for both.
class Twins {
public:
  explicit Twins(Model const& model);
  /// By the later one, then by the first.
  [[nodiscard]] std::vector<Twin> const& all() const { return all_; }
  /// The first node that moves as this one does, each component by constraints or, of both, by motions, which
  /// may be unlike; not all by motions.
  [[nodiscard]] Index moves_as(Index node) const { return moves_as_.empty() ? node : moves_as_[ix(node)]; }
  /// Do the same unknowns move gap and slip of both, by the same rows H, and are these equal to `off`, m?
  template<int D>
  [[nodiscard]] bool alike(contact::PointKinematics<D> const& a, contact::PointKinematics<D> const& b,
                           double off) const;

private:
  Indices moves_as_; ///< [nodes] the first that moves as each; empty: none but itself
  std::vector<Twin> all_;
};

} // namespace stiction::dynamics
