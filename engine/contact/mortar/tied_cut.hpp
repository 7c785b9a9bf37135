// Where two surfaces of different meshes lie on one another: facets cut on a plane, and points on both.
#pragma once
#include "contact/surface/cell_surface.hpp"

namespace stiction::contact {

/// A point of a facet, its counterpart on another facet, and what it stands for.
struct TiedPoint {
  double weight = 0; ///< m^2 (m in plane strain), with 2 pi r where `around`
  PerNode own = PerNode::Zero(), other = PerNode::Zero(); ///< shape functions of both facets, there
};

/// What a facet has in common with another.
struct TiedPart {
  std::vector<TiedPoint> points;
  double area = 0; ///< on the facet's plane, m^2 (m in the plane)
  double gap = 0;  ///< farthest from one to the other along the normal, m
};

/// One facet of a surface, cut into pieces between its nodes; each is projected on the plane through its
/// middle across its mean normal (Puso 2004), in two dimensions on the line between its ends.
class TiedGround {
public:
  /// Reference positions are used.
  TiedGround(CellFacet const& facet, int dim, bool around);
  /// Points on the pieces of `other` that face this facet within 60 degrees of its normal. Where both facets
  /// are affine images of their domains the products of shape functions are integrated exactly, else with 8
  /// points a direction.
  [[nodiscard]] TiedPart common(CellFacet const& other) const;
  [[nodiscard]] double area() const { return area_; }

private:
  struct Piece {
    Vec3 middle, normal, right, up; ///< up: 0 in two dimensions
    std::vector<Vec2> corners;
    double area = 0;
    [[nodiscard]] Vec2 on(Vec3 const& x) const { return {right.dot(x - middle), up.dot(x - middle)}; }
  };
  void add_points(Piece const& piece, std::vector<Vec2> const& polygon, CellFacet const& other,
                  TiedPart& part) const;
  [[nodiscard]] PerNode shape_at(Piece const& piece, CellFacet const& facet, Vec2 const& point) const;

  CellFacet const* facet_;
  int dim_;
  bool around_;
  std::vector<Piece> pieces_;
  double area_ = 0;
};

} // namespace stiction::contact
