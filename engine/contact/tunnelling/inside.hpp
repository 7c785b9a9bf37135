// Whether a point lies inside a closed surface, and how deep.
#pragma once
#include <span>
#include <vector>

#include "contact/tunnelling/tunnelling.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::contact {

/// The whole boundary of a mesh, straight between the corners of its facets.
template<int D> [[nodiscard]] std::vector<Panel<D>> panels_of(mesh::Mesh const& mesh);

/// Distance of `point` from the nearest panel if it lies inside the closed surface, else 0, m. x: positions
/// of all nodes, [D nodes]. Looks at every panel.
template<int D>
[[nodiscard]] double depth_inside(std::vector<Panel<D>> const& closed, std::span<double const> x,
                                  Vec<D> const& point);

} // namespace stiction::contact
