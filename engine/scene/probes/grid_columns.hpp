// Columns of probes that are of the points of a grid: half spaces have them, and formulas over one.
#pragma once
#include <algorithm>
#include <cmath>

#include "halfspace/model.hpp"
#include "scene/probes/point_quantities.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

struct GridContext {
  halfspace::Model const& model;
  Columns const& series;
  std::string const& name;
  [[nodiscard]] int dim() const { return model.grid.line ? 2 : 3; }
  [[nodiscard]] char const* force_unit() const { return model.grid.line ? "N/m" : "N"; }
  [[nodiscard]] char const* area_unit() const { return model.grid.line ? "m" : "m^2"; }
  [[nodiscard]] char const* energy_unit() const { return model.grid.line ? "J/m" : "J"; }
  void column(std::string const& column, char const* unit, char const* meaning, int width = 1) const {
    series.add(name, column, unit, meaning, width);
  }
  /// Components x, y [, z] of a vector.
  void vector(char const* what, char const* unit, char const* meaning) const {
    for (int c = 0; c < dim(); ++c)
      column(std::string(what) + '_' + "xyz"[c], unit, meaning);
  }
  void quantities(int width) const {
    for (auto const& quantity : scene::quantities(dim()))
      column(quantity.name, quantity.unit != nullptr ? quantity.unit : area_unit(), quantity.meaning, width);
  }
};

/// Columns of a point, and which it is.
[[nodiscard]] inline Index add_point(PointProbe const& probe, GridContext const& context) {
  auto const& grid = context.model.grid;
  auto const cell = [&](std::size_t c, double step, Index count) {
    double const at = c < probe.near.size() ? probe.near[c] : 0;
    return std::clamp<Index>(static_cast<Index>(std::floor(at / step + 0.5 * count)), 0, count - 1);
  };
  Index const point = cell(0, grid.dx(), grid.nx) + (grid.line ? 0 : grid.nx * cell(1, grid.dy(), grid.ny));
  context.series.set_attribute(context.name, "X", grid.x(point));
  context.series.set_attribute(context.name, "Y", grid.y(point));
  context.quantities(1);
  return point;
}

/// Columns of all points.
inline void add_line(GridContext const& context) {
  Index const n = context.model.grid.size();
  context.column("X", "m", "reference coordinate of the points", n);
  context.column("Y", "m", "reference coordinate of the points", n);
  context.column("count", "1", "contact points of the pair");
  context.quantities(n);
}

/// at(i): the state of a point.
template<class At>
void push_point(halfspace::Grid const& grid, At const& at, Index point, std::vector<double>& row) {
  dynamics::ContactState const here = at(point);
  for (auto const& quantity : quantities(grid.line ? 2 : 3))
    row.push_back(quantity.value(here));
}

template<class At> void push_line(halfspace::Grid const& grid, At const& at, std::vector<double>& row) {
  Index const n = grid.size();
  for (Index i = 0; i < n; ++i)
    row.push_back(grid.x(i));
  row.insert(row.end(), ix(n), 0.0);
  row.push_back(n);
  auto const chosen = quantities(grid.line ? 2 : 3);
  std::size_t const begin = row.size();
  row.resize(begin + chosen.size() * ix(n));
  for (Index i = 0; i < n; ++i) {
    dynamics::ContactState const here = at(i);
    for (std::size_t q = 0; q < chosen.size(); ++q)
      row[begin + q * ix(n) + ix(i)] = chosen[q].value(here);
  }
}

} // namespace stiction::scene
