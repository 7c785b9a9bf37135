// Whether a step carried a node through a surface, told from where both were at its start and at its end.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/surface/cell_surface.hpp"
#include "contact/surface/curve.hpp"
#include "contact/surface/surface.hpp"

namespace stiction::contact {

/// Corners of a flat piece of a surface: a segment with the body to its left, a triangle with the body
/// behind.
template<int D> using Panel = std::array<Index, D>;

[[nodiscard]] std::vector<Panel<2>> panels_of(Curve const& curve);
[[nodiscard]] std::vector<Panel<3>> panels_of(Surface const& surface);
/// Sides of quadratic facets are taken as straight.
template<int D> [[nodiscard]] std::vector<Panel<D>> panels_of(CellSurface const& surface);

/// Positions of all nodes at the start and the end of a step, [D nodes], m.
struct StepPath {
  std::span<double const> from, to;
};

/// True if the node, all going straight, goes from the outer to the inner side of a panel that is not its
/// own, and, where asked, this far behind it, m.
template<int D>
[[nodiscard]] bool passes(std::vector<Panel<D>> const& panels, Index node, StepPath path, double deep = 0);

} // namespace stiction::contact
