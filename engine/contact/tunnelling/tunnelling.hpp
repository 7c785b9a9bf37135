// Whether a step carried a node through a surface, told from where both were at its start and at its end.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/surface/cell_surface.hpp"
#include "contact/surface/curve.hpp"
#include "contact/surface/grid.hpp"
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

/// The panels of a surface and what each sweeps over in a step, for questions in n log n.
template<int D> class SweptPanels {
public:
  /// Both must outlive it.
  SweptPanels(std::vector<Panel<D>> const& panels, StepPath path);
  /// True if the node, all going straight, goes from the outer to the inner side of a panel that is not its
  /// own, and, where asked, this far behind it, m. `visits` goes up by the panels looked at.
  [[nodiscard]] bool passed_by(Index node, double deep = 0, long* visits = nullptr) const;

private:
  std::vector<Panel<D>> const* panels_;
  StepPath path_;
  Grid<D> grid_;
};

} // namespace stiction::contact
