// The mass matrix of a model, with the inertia of contact nodes as the scheme wants it.
#pragma once
#include "dynamics/model.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

/// Consistent mass, the same for all components, by node; of free rigid bodies mass and inertia.
struct Mass {
  linear::Pattern pattern; ///< of nodes
  std::vector<double> values;
  Vector weight; ///< M g and the constant forces on rigid bodies, [dim nodes], N
  int dim = 2;

  /// y = M x over all degrees of freedom.
  void times(Vector const& x, Vector& y) const;
};

/// on_surface[nodes] marks the contact nodes.
/// none: their mass goes to the other nodes of the same cell; implicit: it is lumped onto their diagonal.
[[nodiscard]] Mass assemble_mass(Model const& model, std::vector<bool> const& on_surface,
                                 ContactInertia inertia);

} // namespace stiction::dynamics
