// Finding the part of a primary surface that is near a point, and the part that a node of its own may touch.
#pragma once
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "contact/surface/curve.hpp"
#include "contact/surface/surface.hpp"

namespace stiction::contact {

/// What a node of a curve must not take for its counterpart on that same curve: its own neighbourhood along
/// the curve, what it faces through the body, and what does not face it.
class OwnSide {
public:
  /// reference: positions [2 nodes] in which the curve does not cross itself.
  OwnSide(Curve const& curve, std::span<double const> reference, double radius);
  [[nodiscard]] bool allows(Index node, Vec2 const& point, Foot foot, std::span<double const> x) const;

private:
  struct Own {
    Foot foot;        ///< where the node lies on the curve
    double depth = 0; ///< how far it may have gone through its counterpart, m
  };
  [[nodiscard]] bool faces(Own const& own, Foot foot, std::span<double const> x) const;

  Curve const* curve_;
  std::vector<Own> of_node_; ///< by node; not found for nodes elsewhere
};

/// New feet on one primary, which must outlive it. Positions may move by half a facet from `update` to the
/// queries.
template<int D> class Search {
public:
  using Primary = std::conditional_t<D == 2, Curve, Surface>;
  /// Looks as far as `reach` (m) and at least a few facets; beyond that nothing is found.
  Search(Primary const& primary, double reach);

  /// Plane curves that may touch themselves: nodes of the curve look for it elsewhere only. In space a bug.
  void allow_self(std::span<double const> reference);

  /// Takes the boxes of all facets at x; call at the start of a step.
  void update(std::span<double const> x);
  /// A foot near the nearest one, for Curve::project and Surface::project; `node`: whose point this is.
  /// `visits` goes up by the facets looked at.
  [[nodiscard]] Foot nearest(Vec<D> const& point, std::span<double const> x, Index node = -1,
                             long* visits = nullptr) const;
  /// The foot of a node's point; starts anew where `guess` leads out of reach or to what the node must not
  /// take.
  [[nodiscard]] Foot project(Index node, Vec<D> const& point, Foot guess, std::span<double const> x) const;

  [[nodiscard]] double radius() const { return radius_; }
  [[nodiscard]] Primary const& primary() const { return *primary_; }

private:
  [[nodiscard]] bool allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const;

  Primary const* primary_;
  Grid<D> grid_;
  std::vector<Box<D>> boxes_;
  std::optional<OwnSide> own_;
  double size_ = 0, radius_ = 0; ///< of a facet, of the search, m
};

} // namespace stiction::contact
