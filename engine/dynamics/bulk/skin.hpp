// The cells that contact nodes belong to, whose stress a scheme may take at the end of its steps.
#pragma once
#include "dynamics/model/model.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

class Skin {
public:
  /// on_surface[nodes] marks the contact nodes. The model must outlive it.
  Skin(Model const& model, std::vector<bool> const& on_surface);
  /// Finds the entries of its cells in a matrix of the unknowns; unknown_of[dofs] is -1 where driven.
  void map_entries(linear::Pattern const& pattern, Indices const& unknown_of);
  /// Their part of F_int(u), which must be sound, [dofs], N.
  void internal_force(Vector const& u, Vector& force) const;
  /// values += factor * their part of K(u).
  void add_stiffness(Vector const& u, double factor, std::span<double> values) const;

private:
  template<class Act> void each_body(Vector const& u, Act const& act) const;

  Model const* model_;
  std::vector<std::unique_ptr<solid::Body>> bodies_; ///< with those cells alone
  std::vector<solid::Cells> cells_;                  ///< [bodies]
  std::vector<solid::ScatterMap> maps_;              ///< [bodies]
};

} // namespace stiction::dynamics
