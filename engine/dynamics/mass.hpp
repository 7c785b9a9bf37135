// The mass matrix of a model, with the inertia of contact nodes as the scheme wants it.
#pragma once
#include "dynamics/model.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

/// Consistent mass, the same for both components, by node.
struct Mass {
  linear::Pattern pattern; ///< of nodes
  std::vector<double> values;
  Vector weight; ///< M g, [2 nodes], N

  /// y = M x over all degrees of freedom.
  void times(Vector const& x, Vector& y) const;
};

/// on_surface[nodes] marks the contact nodes.
/// none: their mass goes to the other nodes of the same cell; implicit: it is lumped onto their diagonal.
[[nodiscard]] Mass assemble_mass(Model const& model, std::vector<bool> const& on_surface,
                                 ContactInertia inertia);

} // namespace stiction::dynamics
