// The bodies of a scene at rest, each held by its own motions alone: what gives way how much, and how fast it
// swings.
#pragma once
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::scene {

class Statics {
public:
  /// Assembles and factors once.
  explicit Statics(dynamics::Model const& model);
  /// Is every body held, and stiff as it stands?
  [[nodiscard]] bool regular() const { return regular_; }
  /// Mean displacement of nodes along a unit direction for a unit force spread over them, m/N.
  [[nodiscard]] double compliance(Indices const& nodes, contact::Vec3 const& direction);
  /// Slowest natural period, s: Rayleigh's quotient of the displacements under the weight along each axis.
  [[nodiscard]] double period();

private:
  Vector solve(Vector const& force);

  dynamics::Model const* model_;
  dynamics::BulkSystem bulk_;
  bool regular_ = false;
};

} // namespace stiction::scene
