// What gap, slip and forces of a mortar sample depend on, and how its foot, normal and frame move with that.
#pragma once
#include <algorithm>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "contact/mortar/mortar_sample.hpp"

namespace stiction::contact {

/// In this order: the sample's position, the sum of its normals, its counterpart's position and tangents at
/// fixed local coordinates, and the first tangent's direction (3D).
template<int D> inline constexpr int input_count = D == 2 ? 8 : 18;
enum Input : std::uint8_t {
  own_position = 0,
  normal_sum = 1,
  other_position = 2,
  other_tangents = 3,
  carried = 5
};
template<int D> using By = Eigen::Matrix<double, D, input_count<D>>;
template<int D> using ByLess = Eigen::Matrix<double, D - 1, input_count<D>>;
template<int D> using Tangents = Eigen::Matrix<double, D, D - 1>;

/// The unit derivative of one vector input.
template<int D> By<D> unit_input(int number) {
  By<D> E = By<D>::Zero();
  E.template middleCols<D>(D * number).setIdentity();
  return E;
}

/// Of the averaged normals at the corners of the facet, by their hats at a point.
template<int D>
Vec<D> sum_of_normals(CellFacet const& facet, PerNode const& hats, FanNormals<D> const& normals) {
  Vec<D> sum = Vec<D>::Zero();
  for (int k = 0; k < facet.corners(); ++k)
    sum += hats[k] * normals.unit[ix(facet.fan[ix(k)])];
  return sum;
}

template<int D> Vec<D> normal_sum_of(Faced<D> const& faced, Sample const& sample) {
  return sum_of_normals<D>(faced.secondary.facet(sample.facet), sample.hats, faced.normals);
}

template<int D> Vec<D> carried_direction(Faced<D> const& faced, Sample const& sample) {
  return faced.secondary.template positions<D>(sample.facet, faced.x) * sample.material;
}

inline Mat<3> cross_matrix(Vec3 const& a) {
  Mat<3> A;
  A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return A;
}

/// The primary facet at the foot, and the forces along n that balance a tangential force: at node k, sum_b
/// c_b N_k,b n with (t_a . x2_b) c_b = gap f_a.
template<int D> struct Opposite {
  CellFacet const& facet;
  FacetNodes<D> nodes;
  FacetShape shape;
  Tangents<D> tangents;
  Mat<D - 1> lever; ///< (t_a . x2_b)^-1

  Opposite(Faced<D> const& faced, SamplePairing<D> const& pairing)
      : facet(faced.primary.facet(pairing.foot.segment)),
        nodes(faced.primary.template positions<D>(pairing.foot.segment, faced.x)),
        shape(facet_shape(facet.kind, {pairing.foot.xi, pairing.foot.eta})),
        tangents(tangents_of<D>(nodes, shape)),
        lever((pairing.frame.template rightCols<D - 1>().transpose() * tangents).inverse()) {}
};

/// Derivatives by the inputs.
template<int D> struct Moving {
  By<D> normal, foot_and_gap;    ///< the latter of the foot's local coordinates, then of the gap
  std::array<By<D>, D> of_frame; ///< of n, t1 [, t2]

  Moving(Faced<D> const& faced, Sample const& sample, SamplePairing<D> const& pairing,
         Opposite<D> const& other) {
    Vec<D> const n = pairing.frame.col(0);
    Mat<D> const across_n = Mat<D>::Identity() - n * n.transpose();
    normal = -across_n / normal_sum_of(faced, sample).norm() * unit_input<D>(normal_sum);
    Mat<D> J;
    J << other.tangents, n;
    foot_and_gap =
        J.inverse() * (unit_input<D>(own_position) - unit_input<D>(other_position) - pairing.gap * normal);
    of_frame = turn(pairing.frame, carried_direction(faced, sample));
  }
  [[nodiscard]] ByLess<D> foot() const { return foot_and_gap.template topRows<D - 1>(); }

private:
  [[nodiscard]] std::array<By<D>, D> turn(Mat<D> const& frame, Vec<D> const& direction) const {
    if constexpr (D == 2) {
      static_cast<void>(frame), static_cast<void>(direction);
      Mat<2> right;
      right << 0, 1, -1, 0;
      return {normal, By<2>(right * normal)};
    } else {
      Vec3 const n = frame.col(0), t1 = frame.col(1);
      By<3> const dc = unit_input<3>(carried);
      double const along = n.dot(direction);
      By<3> const dq = dc - along * normal - n * (direction.transpose() * normal + n.transpose() * dc);
      double const length = (direction - along * n).norm();
      By<3> const dt1 = (Mat<3>::Identity() - t1 * t1.transpose()) * dq / length;
      return {normal, dt1, By<3>(cross_matrix(n) * dt1 - cross_matrix(t1) * normal)};
    }
  }
};

/// Where a sample's way along the primary begins, and where it ends.
template<int D> struct WayEnd {
  CellFacet const& facet;
  FacetNodes<D> nodes;
  FacetShape shape, hats; ///< of the facet and of its corners
  Vec<D> position, sum;   ///< the latter of averaged normals

  WayEnd(Faced<D> const& faced, Foot foot)
      : facet(faced.primary.facet(foot.segment)),
        nodes(faced.primary.template positions<D>(foot.segment, faced.x)),
        shape(facet_shape(facet.kind, {foot.xi, foot.eta})),
        hats(facet_shape(linear_kind(facet.kind), {foot.xi, foot.eta})), position(nodes * shape.N),
        sum(sum_of_normals<D>(facet, hats.N, faced.opposite)) {}
  [[nodiscard]] Way<D> way_to(WayEnd const& end) const {
    return {end.position - position, sum.normalized(), end.sum.normalized(), ChordEnds::on_facets};
  }
};

/// Blocks of derivatives by what is numbered, in the order in which it was met.
template<int D> class BlocksOf {
public:
  [[nodiscard]] Mat<D>& operator()(Index number) {
    auto const found = std::ranges::find(numbers_, number);
    if (found != numbers_.end())
      return blocks_[static_cast<std::size_t>(found - numbers_.begin())];
    numbers_.push_back(number);
    return blocks_.emplace_back(Mat<D>::Zero());
  }
  [[nodiscard]] Indices const& numbers() const { return numbers_; }
  [[nodiscard]] std::vector<Mat<D>> const& blocks() const { return blocks_; }

private:
  Indices numbers_;
  std::vector<Mat<D>> blocks_;
};

} // namespace stiction::contact
