// Prescribed displacements of nodes: along a path, and about an axis.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "core/types.hpp"
#include "dynamics/scheme/path.hpp"

namespace stiction::dynamics {

/// A component of a node's way about an axis: u = across (cos a - 1) + along sin a. With the arm s from the
/// axis to the node, across = s_c and along = (axis x s)_c, m.
struct Turn {
  std::shared_ptr<Path const> angle; ///< a, rad
  double across = 0, along = 0;
  [[nodiscard]] double value(double t) const;
  [[nodiscard]] double rate_before(double t) const;
  /// Largest |u| up to the largest |a|, at most: of the chord in the plane of the turn.
  [[nodiscard]] double farthest() const;
  /// Largest |du/dt|, at most.
  [[nodiscard]] double fastest() const;
};

/// A displacement component of some nodes driven along a path and, of one node, about an axis.
struct Motion {
  Indices nodes; ///< model numbers
  int component = 0;
  Path path;                     ///< m; rad for the turn of a rigid body
  std::string set = {};          ///< for messages: what it moves
  std::optional<Turn> turn = {}; ///< besides
  [[nodiscard]] double value(double t) const { return path.value(t) + (turn ? turn->value(t) : 0.0); }
  /// Just before t, as Path has it.
  [[nodiscard]] double rate_before(double t) const {
    return path.rate_before(t) + (turn ? turn->rate_before(t) : 0.0);
  }
  /// Largest displacement, at most.
  [[nodiscard]] double farthest() const { return path.farthest() + (turn ? turn->farthest() : 0.0); }
  [[nodiscard]] double fastest() const { return path.fastest() + (turn ? turn->fastest() : 0.0); }
};

} // namespace stiction::dynamics
