// Linear least squares: the normal from the covariance, the circle as |x|^2 = 2 c.x + d (Kasa 1976).
#include "scene/build/fit.hpp"

#include "linear/decompositions.hpp"

namespace stiction::scene {

namespace {

constexpr double flat_within = 1e-3, round_within = 1e-2;

ShapeFit fit_flat(Matrix const& x, Vector const& middle) {
  Matrix const from = x.rowwise() - middle.transpose();
  Dense const covariance = from.transpose() * from;
  Eigen::SelfAdjointEigenSolver<Dense> const axes(covariance);
  ShapeFit fit;
  fit.kind = ShapeFit::flat;
  fit.centre.head(x.cols()) = middle;
  fit.normal.head(x.cols()) = axes.eigenvectors().col(0);
  fit.error = (from * axes.eigenvectors().col(0)).cwiseAbs().maxCoeff();
  return fit;
}

ShapeFit fit_round(Matrix const& x, Vector const& middle) {
  Matrix const from = x.rowwise() - middle.transpose();
  Dense system(x.rows(), x.cols() + 1);
  system << 2 * from, Vector::Ones(x.rows());
  Vector const squares = from.rowwise().squaredNorm();
  Vector const found = system.colPivHouseholderQr().solve(squares);
  Vector const centre = found.head(x.cols());
  ShapeFit fit;
  double const square = found[x.cols()] + centre.squaredNorm();
  if (!(square > 0))
    return fit;
  fit.kind = ShapeFit::round;
  fit.radius = std::sqrt(square);
  fit.centre.head(x.cols()) = middle + centre;
  fit.error = ((from.rowwise() - centre.transpose()).rowwise().norm().array() - fit.radius).abs().maxCoeff();
  return fit;
}

} // namespace

ShapeFit fit_shape(Matrix const& points) {
  if (points.rows() < 2)
    return {};
  Vector const middle = points.colwise().mean();
  double const extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  auto const flat = fit_flat(points, middle);
  if (flat.error <= flat_within * extent)
    return flat;
  if (points.rows() < points.cols() + 2)
    return {};
  auto const round = fit_round(points, middle);
  return round.error <= round_within * round.radius ? round : ShapeFit{};
}

} // namespace stiction::scene
