// Points that give way a little more than they do, and their stiffness without what pushes.
#include "linear/held_points.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace stiction::linear {

namespace {
constexpr double softness = 0.15; ///< of a point's compliance, which the preconditioner adds to it
} // namespace

std::vector<std::vector<SurfaceEntry>> by_point(SurfaceRows const& rows, Index components) {
  std::vector<std::vector<SurfaceEntry>> of(ix(rows.count / components));
  for (auto const& h : rows.H)
    of[ix(h.row / components)].push_back(h);
  return of;
}

Dense softened(PointLaws const& laws, Dense const& compliance) {
  Index const C = static_cast<Index>(laws.A.cols());
  Dense all(laws.A.rows(), C);
  for (Index row = 0; row < laws.A.rows(); row += C) {
    double const extra = softness * compliance.middleRows(row, C).trace() / C;
    all.middleRows(row, C) =
        SmallBlock(laws.A.middleRows(row, C) + extra * laws.B.middleRows(row, C)).inverse();
  }
  return all;
}

SmallBlock holding(SmallBlock const& S) {
  Eigen::JacobiSVD<SmallBlock, Eigen::NoQRPreconditioner> const parts(S, Eigen::ComputeFullU |
                                                                             Eigen::ComputeFullV);
  SmallBlock D = SmallBlock::Zero(S.rows(), S.cols());
  for (Index k = 0; k < S.cols(); ++k) {
    Eigen::Vector<double, Eigen::Dynamic> const v = parts.matrixV().col(k);
    if (v.dot(S * v) > 0)
      D += parts.singularValues()[k] * v * v.transpose();
  }
  return D;
}

Vector by_blocks(Dense const& blocks, Vector const& v) {
  Index const C = static_cast<Index>(blocks.cols());
  Vector w(v.size());
  for (Index row = 0; row < v.size(); row += C)
    w.segment(row, C).noalias() = blocks.middleRows(row, C) * v.segment(row, C);
  return w;
}

} // namespace stiction::linear
