// What a node of a surface must not take for its counterpart on that same surface.
#pragma once
#include <span>
#include <type_traits>
#include <vector>

#include "contact/surface/curve.hpp"
#include "contact/surface/surface.hpp"

namespace stiction::contact {

/// A node of a surface that may touch itself looks away from its own neighbourhood along the surface, from
/// what it faces through the body, from what does not face it, and from what is to look for it: of two parts
/// that meet one has the points and the other the facets, so that every couple counts once, with its area,
/// its friction and its bond. Which one is a matter of a fixed order of material points: last is what stands
/// out, as ends and corners of the surface, before it all goes along a direction in which no mesh is likely
/// to be symmetric.
template<int D> class OwnSide {
public:
  using Primary = std::conditional_t<D == 2, Curve, Surface>;
  /// reference: positions [D nodes] in which the surface does not cross itself. radius: of the search, m.
  /// guided: nodes that motions hold or drive, as on planes of symmetry, where nothing stands out; may be
  /// empty.
  OwnSide(Primary const& primary, std::span<double const> reference, double radius,
          std::vector<bool> const& guided);
  /// May the node at `point` have its counterpart at `foot`? x: positions [D nodes].
  [[nodiscard]] bool allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const;

private:
  /// What a node sees through its body in the reference.
  struct Behind {
    Foot foot;            ///< the nearest; not found: nothing within the radius
    double thickness = 0; ///< of the body along the normals there, the least, m; or the radius
    double way = 0;       ///< from the node to the foot, m; or the radius
  };
  [[nodiscard]] std::span<Foot const> feet_of(Index node) const;
  void gather_feet(std::size_t nodes);
  [[nodiscard]] bool stands_out(Index node, std::span<double const> reference) const;
  [[nodiscard]] std::vector<bool> outstanding(std::span<double const> reference,
                                              std::vector<bool> const& guided) const;
  void order_nodes(std::span<double const> reference);
  void look_through(std::span<double const> reference, double radius);
  void look_behind(Index node, int facet, std::span<double const> reference);
  [[nodiscard]] bool sees_through(Index node, Vec<D> const& point, Foot foot,
                                  std::span<double const> x) const;
  [[nodiscard]] bool comes_after(Index node, Foot foot) const;
  [[nodiscard]] bool faces(Index node, Foot foot, std::span<double const> x) const;

  Primary const* primary_;
  double longest_ = 0;              ///< facet, m; 0 of curves
  std::vector<std::size_t> starts_; ///< where the feet of a node stand, [nodes + 1]
  std::vector<Foot> feet_;          ///< where nodes lie on the surface, one in each of their facets
  std::vector<double> order_;       ///< of the nodes, m
  std::vector<bool> last_;          ///< [nodes] do they come after all others?
  std::vector<Behind> behind_;      ///< [nodes]
  double tie_ = 0;                  ///< what two places in the order must differ by, m
};

} // namespace stiction::contact
