// A half space and what is pressed onto it and moved along it.
#pragma once
#include <array>
#include <optional>

#include "dynamics/model/state.hpp"
#include "dynamics/scheme/path.hpp"
#include "halfspace/green.hpp"
#include "interface/law.hpp"

namespace stiction::halfspace {

/// The half space lies at z <= 0 (in plane strain y <= 0). Along the normal, into it, counts as pressing.
struct Model {
  Grid grid;
  Elastic body;
  std::optional<Elastic> counterpart; ///< none: rigid
  Vector heights;                     ///< gap at the points with the counterpart where it starts, m
  /// Displacement of the counterpart along x, y and off the surface, m. Heights are not carried along.
  std::array<dynamics::Path, 3> shift;
  std::optional<dynamics::Path> force; ///< that presses, N (N/m in plane strain), in place of shift[2]
  interface::Law law;
  double tolerance = 1e-10; ///< of contact, over the largest traction
  /// Of a point: what acts along the surface takes part or not.
  [[nodiscard]] int components() const { return !law.tangential() ? 1 : grid.line ? 2 : 3; }
};

/// All that must survive a step. Components are (n, x, y), as many as the model has.
struct State {
  double t = 0;                     ///< s
  double lift = 0;                  ///< of the counterpart off where it starts, m
  std::array<double, 2> along{};    ///< of the counterpart, along x and y, m
  Vector force;                     ///< on the half space, [components points], N
  Vector u;                         ///< displacements that they make, [components points], m
  Vector gap;                       ///< [points], m
  Vector dry;                       ///< those forces without adhesion, [components points], N
  Vector beta;                      ///< [points]; empty without adhesion
  Vector stretch;                   ///< [2 points], m; empty without adhesion or what acts along the surface
  Vector path;                      ///< slip since the start, [components - 1, points], m
  std::vector<std::uint8_t> status; ///< [points]
  dynamics::Ledger ledger;
  template<class Archive> void visit(Archive& archive) {
    archive(t, lift, along, force, u, gap, dry, beta, stretch, path, status, ledger);
  }
  [[nodiscard]] interface::Status status_of(Index i) const {
    return static_cast<interface::Status>(status[ix(i)]);
  }
  [[nodiscard]] interface::Bond bond_of(Index i) const {
    interface::Bond bond;
    if (beta.size() > 0)
      bond.beta = beta[i];
    if (stretch.size() > 0)
      bond.stretch = stretch.segment<2>(2 * i);
    return bond;
  }
};

} // namespace stiction::halfspace
