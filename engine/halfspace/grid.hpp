// The points of a half space: the middles of equal rectangles, or of equal stretches of a line in plane
// strain.
#pragma once
#include "core/types.hpp"

namespace stiction::halfspace {

struct Grid {
  Index nx = 1, ny = 1;  ///< points; ny = 1 on a line
  double Lx = 1, Ly = 1; ///< m; Ly counts for nothing on a line
  bool line = false;     ///< plane strain: what is m^2 elsewhere is m
  bool periodic = true;  ///< repeated for ever; else the surface is free around the points
  [[nodiscard]] Index size() const { return nx * ny; }
  /// Points of the transforms along x and along y: those of free surfaces are padded.
  [[nodiscard]] Index px() const { return periodic ? nx : 2 * nx; }
  [[nodiscard]] Index py() const { return line || periodic ? ny : 2 * ny; }
  [[nodiscard]] double dx() const { return Lx / nx; }
  [[nodiscard]] double dy() const { return Ly / ny; }
  /// Of the piece of surface that belongs to a point, m^2 (m on a line).
  [[nodiscard]] double area() const { return line ? dx() : dx() * dy(); }
  /// Of point `i`, counted along x first; the middle of all is the origin.
  [[nodiscard]] double x(Index i) const { return (i % nx + 0.5) * dx() - 0.5 * Lx; }
  [[nodiscard]] double y(Index i) const {
    Index const row = i / nx;
    return line ? 0 : (row + 0.5) * dy() - 0.5 * Ly;
  }
};

} // namespace stiction::halfspace
