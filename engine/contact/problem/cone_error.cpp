// The error of an answer over all points together: the natural map with rho = 1 in scaled units.
#include "contact/problem/cone_error.hpp"

#include <algorithm>

namespace stiction::contact {

namespace {

bool plain(ProblemPoint const& point) {
  return point.adhesion < 0 && point.friction < 0;
}

double mean_diagonal(Problem const& problem) {
  double sum = 0;
  for (Index row = 0; row < problem.free.size(); ++row)
    sum += problem.W.diagonal(row);
  return sum / static_cast<double>(problem.free.size());
}

/// Sum of squares over the points of r - Proj(r - (u + mu |u_t| n)).
template<int D> double squares(Problem const& problem, Vector const& r, Vector const& u, double unit) {
  double sum = 0;
  for (Index k = 0; k < problem.size(); ++k) {
    auto const& point = problem.points[ix(k)];
    Local<D> const force = r.segment<D>(D * k);
    Local<D> y = u.segment<D>(D * k) - point.shift.head<D>() / unit;
    y[0] += point.mu * y.template tail<D - 1>().norm();
    sum += (force - interface::project<D>(force - y, point.mu).value).squaredNorm();
  }
  return sum;
}

} // namespace

std::optional<double> cone_error(Problem const& problem, Vector const& force, Vector const& x) {
  if (problem.size() == 0 || !std::all_of(problem.points.begin(), problem.points.end(), plain))
    return {};
  double const unit = problem.free.lpNorm<Eigen::Infinity>(), compliance = mean_diagonal(problem);
  if (!(unit > 0 && compliance > 0))
    return {};
  Vector const r = force * (compliance / unit), u = x / unit;
  double const sum = by_dimension(problem.dim, [&]<int D> { return squares<D>(problem, r, u, unit); });
  return std::sqrt(sum) / (problem.free.norm() / unit);
}

} // namespace stiction::contact
