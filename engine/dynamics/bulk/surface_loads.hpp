// The loads of a model that follow its surfaces: nodal forces, energy, entries of the effective stiffness.
#pragma once
#include <algorithm>

#include "dynamics/bulk/links.hpp"
#include "dynamics/model/model.hpp"
#include "solid/facets.hpp"

namespace stiction::dynamics {

class SurfaceLoads {
public:
  explicit SurfaceLoads(Model const& model) : model_(&model) {}
  [[nodiscard]] bool empty() const { return !pressed() && !stressed(); }
  [[nodiscard]] bool pressed() const { return !model_->pressures.empty() || !model_->gases.empty(); }
  [[nodiscard]] bool stressed() const { return !model_->surface_stresses.empty(); }
  /// Is a volume given? Its stiff pressure, of a surface that has moved since, leads an older factor astray.
  [[nodiscard]] bool stiff() const { return std::ranges::any_of(model_->gases, &Gas::by_volume); }

  /// Of a cavity, m^3 (m^2 in plane strain).
  [[nodiscard]] double volume(Gas const& gas, Vector const& u) const;
  /// Of every gas; known: at the step's start.
  [[nodiscard]] Gases gas_pressures(Vector const& u, double t, Gases const& known) const;
  /// Of every cavity.
  [[nodiscard]] std::vector<double> volumes(Vector const& u) const;
  /// Where a correction has led from `before` to `now`: given volumes have then the pressure that the matrix
  /// balanced, on which the next one adds what the volume still lacks. gas: as it was; before may be empty.
  [[nodiscard]] Gases balanced(Gases gas, std::vector<double> const& before,
                               std::vector<double> const& now) const;
  /// What the rounding of given volumes alone makes of forces, N.
  [[nodiscard]] double rounding(Vector const& u) const;
  /// At a step's end: those leak too whose wall has left its seal, and what was more than the pressure
  /// outside bears has gone out under it.
  [[nodiscard]] Gases leaked(Vector const& u, double t, Gases gas) const;
  /// Those that the matrix turns with the surface: of given volumes the ones known, as those on the way to
  /// the volume have no bound.
  [[nodiscard]] Gases steady(Gases const& now, Gases const& known) const;
  /// Adds -p int N n da of every pressure and gas, N.
  void add_pressures(Vector const& u, double t, Gases const& gas, Vector& force) const;
  /// Adds the gradient of the energy of the surface stresses, N; returns that energy, J.
  double add_stresses(Vector const& u, Vector& force) const;

  /// The unknowns that gases couple, wall by wall.
  void add_cliques(Indices const& unknown_of, std::vector<Indices>& cliques) const;
  /// Finds the entries of its facets and walls; unknown_of[dofs] is negative where driven or
  /// following.
  void map_entries(Places const& places, Indices const& unknown_of);
  /// The degrees of freedom that each facet couples.
  [[nodiscard]] std::vector<Indices> facets() const;
  /// Those that each gas does.
  [[nodiscard]] std::vector<Indices> walls() const;
  /// values += factor times what stresses add, the symmetric part of what pressures take, and what gases
  /// resist; gas: as above.
  void add_stiffness(Vector const& u, double t, Gases const& gas, double factor,
                     std::span<double> values) const;
  /// Largest eigenvalue that these loads add to that of M^-1 K, at most, 1/s^2; inverse_mass: [dim nodes].
  [[nodiscard]] double stiffest(Vector const& u, double t, Vector const& inverse_mass) const;

private:
  [[nodiscard]] Matrix places(mesh::Facet const& facet, Vector const& u) const;
  [[nodiscard]] Vector normals(std::vector<mesh::Facet> const& facets, Vector const& u) const;
  [[nodiscard]] Vector wall_normals(Gas const& gas, Vector const& u) const;
  [[nodiscard]] solid::FacetTerms wall_terms(Gas const& gas, std::size_t facet, Vector const& u,
                                             solid::FacetOrder order) const;
  [[nodiscard]] double thicker(Gas const& gas, Vector const& u) const;
  [[nodiscard]] double resistance(Gas const& gas, GasState const& now, double volume) const;
  template<class Visit>
  void each_stiffness(Vector const& u, double t, Gases const& gas, Visit const& visit) const;

  Model const* model_;
  std::vector<Indices> maps_;  ///< per facet, pressures first: entries of the lower triangle, row by row
  std::vector<Indices> walls_; ///< per gas, of all its unknowns
};

} // namespace stiction::dynamics
