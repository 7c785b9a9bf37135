// Loads that follow the deformed surface: pressures, gas in cavities, surface stresses.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "dynamics/scheme/path.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::dynamics {

/// Pressure on a surface as it is deformed, against its outward normal.
struct Pressure {
  std::vector<mesh::Facet> facets; ///< of model nodes, outward
  Path path;                       ///< Pa
};

/// Energy per present area of a surface.
struct SurfaceStress {
  std::vector<mesh::Facet> facets; ///< of model nodes, outward
  double gamma = 0;                ///< J/m^2 = N/m
};

/// A plane through a cavity's centre that its wall stands on without being held there. Where the wall has
/// been lifted the cavity reaches down to the plane along its normal.
struct Seal {
  Indices rim;                           ///< nodes of the wall's end
  std::vector<std::vector<int>> sides{}; ///< [facets]: those of each that are on it
  Point normal = Point::Zero();          ///< of unit length
  double leaks_at = 0;                   ///< m off the plane, from which on gas leaks for good
};

/// A displacement of a node and its part in how a point that is carried moves in a component.
struct Carrier {
  int component = 0;
  Index dof = -1;
  double part = 1;
};

/// Gas in a cavity: p (V / V0)^n = P along a path of P, over the pressure outside; or whatever pressure gives
/// the cavity the volumes of a path.
struct Gas {
  std::string set;                 ///< the cavity's wall
  std::vector<mesh::Facet> facets; ///< of model nodes, outward from the body: into the cavity
  Indices nodes;                   ///< of these
  Point centre = Point::Zero();    ///< planes of symmetry that the wall ends at go through it, m
  std::vector<Carrier> carriers;   ///< of the centre, where the motions that hold the wall's end move
  Path path;                       ///< P over the pressure outside, Pa; or V / V0
  bool by_volume = false;
  double outside = 0, exponent = 1; ///< Pa, n
  double volume = 0;                ///< V0, m^3 (m^2 in plane strain)
  /// Of given volumes: pressure that a correction adds per volume that lacks, Pa/m^3.
  double stiffness = 0;
  std::optional<Seal> seal;
};

/// What a cavity's gas has come to.
struct GasState {
  double pressure = 0;  ///< over that outside, Pa
  bool leaking = false; ///< and so it stays: its pressure is that outside
  double share = 1;     ///< of the amount that the path says, as some went out under a seal
};
using Gases = std::vector<GasState>; ///< [gases]

} // namespace stiction::dynamics
