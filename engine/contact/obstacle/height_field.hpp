// A smooth surface over a plane through heights on a regular grid, and its nearest point.
#pragma once
#include <utility>
#include <vector>

#include "contact/surface/foot.hpp"

namespace stiction::contact {

/// Where heights are given: in the middles of nx x ny rectangles, from 0 on; of one row they are the same for
/// every v.
struct HeightGrid {
  Index nx = 4, ny = 1;
  double dx = 1, dy = 1; ///< m
  bool periodic = true;  ///< repeated for ever; else it goes on for half a rectangle past its rim
};

/// A height with its derivatives by u and v.
struct HeightJet {
  double h = 0;                  ///< m
  double u = 0, v = 0;           ///< 1
  double uu = 0, uv = 0, vv = 0; ///< 1/m
  double uuu = 0;                ///< 1/m^2
};

/// The bicubic spline through heights (two continuous derivatives). Where it is not periodic its third
/// differences vanish at the rim, which parabolas have too.
class HeightField {
public:
  /// heights: [nx ny], along u first, m.
  HeightField(HeightGrid const& grid, Vector const& heights);

  [[nodiscard]] HeightJet at(double u, double v) const;
  /// Along u: where the spline's cells begin, m, and how many there are; from one given height to the next.
  [[nodiscard]] double start() const { return u0_; }
  [[nodiscard]] Index cells() const { return nu_; }

  struct Foot {
    int cell = -1; ///< -1: past the rim
    double u = 0, v = 0;
  };
  /// The point of the surface nearest to (u, v, w), m, whatever lies between; of a periodic one the image
  /// near it.
  [[nodiscard]] Foot nearest(Vec3 const& point) const;

private:
  /// Least and largest height of blocks of 2^level x 2^level cells, level >= 1.
  struct Level {
    Index nx = 0, ny = 0;
    std::vector<double> low, high; ///< m
  };
  struct Block {
    std::size_t level = 0;
    Index i = 0, j = 0;
    double bound = 0; ///< no point of it is nearer, m^2
  };
  struct Best {
    double u = 0, v = 0, distance2 = 0; ///< m, m, m^2
  };
  struct Slope {
    Vec2 gradient;
    Mat<2> hessian;
    bool convex;
  };
  struct Range {
    double u_low, u_high, v_low, v_high; ///< m
  };

  void make_levels();
  [[nodiscard]] std::pair<double, double> bounds(std::size_t level, Index i, Index j) const;
  [[nodiscard]] std::pair<double, double> bounds_of_four(std::size_t level, Index i, Index j) const;
  [[nodiscard]] Block block(std::size_t level, Index i, Index j, Vec3 const& point) const;
  void look_into(Block const& block, Vec3 const& point, Best& best) const;
  void look_at_cell(Index i, Index j, Vec3 const& point, Best& best) const;
  [[nodiscard]] double distance2(double u, double v, Vec3 const& point) const;
  [[nodiscard]] Slope slope(double u, double v, Vec3 const& point) const;
  [[nodiscard]] bool step(Range const& range, Vec3 const& point, Best& best) const;

  HeightGrid grid_;
  Index nu_ = 0, nv_ = 0;     ///< cells of the spline, from one given height to the next
  double u0_ = 0, v0_ = 0;    ///< where they begin, m
  bool round_v_ = true;       ///< repeated along v
  Dense coefficients_;        ///< of B-splines, [nu + 3, nv + 3], m
  std::vector<Level> levels_; ///< levels_[k]: level k + 1
};

} // namespace stiction::contact
