// The mass matrix of a model, with the inertia of contact nodes as the scheme wants it.
#pragma once
#include "dynamics/model/model.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

/// Consistent mass, the same for all components, by node; of free rigid bodies mass and inertia.
struct Mass {
  linear::Pattern pattern; ///< of nodes
  std::vector<double> values;
  Vector dead_load; ///< M g and the constant forces on rigid bodies, [dim nodes], N
  int dim = 2;

  /// y = M x over all degrees of freedom.
  void times(Vector const& x, Vector& y) const;
  /// The diagonal over all degrees of freedom, kg.
  [[nodiscard]] Vector diagonal() const;
  /// x with (M x)_i = f_i where held[i] is false and x_i = 0 where it is true or nothing has mass; by
  /// conjugate gradients, to rounding.
  [[nodiscard]] Vector solve(Vector const& f, std::vector<bool> const& held) const;
};

/// Masses of the nodes of a cell from its consistent mass [nodes, nodes]; positive, of the same sum.
[[nodiscard]] Vector lumped(Dense const& consistent);

/// on_surface[nodes] marks the contact nodes.
/// none: their mass goes to the other nodes of the same cell; implicit, cells: it is lumped onto their
/// diagonal.
[[nodiscard]] Mass assemble_mass(Model const& model, std::vector<bool> const& on_surface,
                                 ContactInertia inertia);

} // namespace stiction::dynamics
