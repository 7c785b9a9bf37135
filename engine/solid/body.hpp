// A body: mesh, material, density and the kinematics that reduce it to the plane.
#pragma once
#include <string>

#include "material/material.hpp"
#include "mesh/mesh.hpp"

namespace stiction::solid {

/// plane_strain: per metre of depth. axisymmetric: coordinates (r, z), integrals over the full turn.
enum class Kinematics { plane_strain, axisymmetric };

struct Body {
  std::string name;
  mesh::Mesh mesh;
  material::Material material;
  double density = 0; ///< kg/m^3
};

} // namespace stiction::solid
