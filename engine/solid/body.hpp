// A body: mesh, material, density, and the kinematics its displacement is limited to.
#pragma once
#include <optional>
#include <string>

#include "material/kelvin_voigt.hpp"
#include "material/material.hpp"
#include "material/prony.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::solid {

/// plane_strain: per metre of depth, or of the thickness of a sheet in plane stress. axisymmetric:
/// coordinates (r, z), integrals over the full turn.
enum class Kinematics { plane_strain, axisymmetric, three_dimensional };

/// Displacement components per node, which is the dimension of the mesh too.
[[nodiscard]] constexpr int dimension(Kinematics kinematics) {
  return kinematics == Kinematics::three_dimensional ? 3 : 2;
}
/// Components of a stress: 11, 22, 33, 12 [, 23, 13].
[[nodiscard]] constexpr int stress_components(Kinematics kinematics) {
  return kinematics == Kinematics::three_dimensional ? 6 : 4;
}

/// What strain the law sees: that of the displacement, or with its volume change averaged over the cell
/// (Simo, Taylor and Pister 1985), which does not lock where the law
/// hardly changes volume.
enum class Interpolation { plain, mean_dilatation };

struct Body {
  std::string name;
  mesh::Mesh mesh;
  material::Material material; ///< of all cells, or the most compliant of `laws`
  double density = 0;          ///< kg/m^3
  Interpolation interpolation = Interpolation::plain;
  std::optional<material::KelvinVoigt> damping{}; ///< viscous stress beside the law's; none by default
  std::vector<material::Material> laws{};         ///< of each block of the mesh; empty: `material` of all
  bool plane_stress = false; ///< a thin sheet, S_33 = 0 and E_33 free; with plane_strain and plain alone
  std::vector<material::PronyTerm> relaxing{}; ///< networks beside the law; none by default
  [[nodiscard]] material::Material const& law_of(std::size_t block) const {
    return laws.empty() ? material : laws.at(block);
  }
};

/// Are the forces of all cells linear in the displacement?
[[nodiscard]] bool linear(Body const& body);

/// Throws InputError where mean dilatation cannot help: cells whose strain is constant.
void check_interpolation(Body const& body);

} // namespace stiction::solid
