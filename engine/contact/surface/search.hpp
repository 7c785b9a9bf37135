// Finding the part of a primary surface that is near a point.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "contact/surface/own_side.hpp"

namespace stiction::contact {

/// New feet on one primary, which must outlive it. Positions may move by half a facet from `update` to the
/// queries.
template<int D> class Search {
public:
  using Primary = typename OwnSide<D>::Primary;
  /// Looks as far as `reach` (m) and at least a few facets; beyond that nothing is found.
  Search(Primary const& primary, double reach);

  /// The primary may touch itself: its nodes look for it elsewhere only, and one of two that meet. reference:
  /// positions [D nodes] in which it does not cross itself. guided: nodes that motions hold or drive; or
  /// empty.
  void allow_self(std::span<double const> reference, std::vector<bool> const& guided = {});

  /// Takes the boxes of all facets at x; call at the start of a step.
  void update(std::span<double const> x);
  /// A foot near the nearest one, for Curve::project and Surface::project; `node`: whose point this is.
  /// `visits` goes up by the facets looked at.
  [[nodiscard]] Foot nearest(Vec<D> const& point, std::span<double const> x, Index node = -1,
                             long* visits = nullptr) const;
  /// The foot of a node's point; starts anew where `guess` leads out of reach or to what the node must not
  /// take.
  [[nodiscard]] Foot project(Index node, Vec<D> const& point, Foot guess, std::span<double const> x,
                             Overhang overhang = Overhang::found) const;

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] Primary const& primary() const { return *primary_; }

private:
  [[nodiscard]] bool allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const;

  Primary const* primary_;
  Grid<D> grid_;
  std::vector<Box<D>> boxes_;
  std::optional<OwnSide<D>> own_;
  double size_ = 0, radius_ = 0; ///< of a facet, of the search, m
};

} // namespace stiction::contact
