// Forces, and displacements times rho, to the last digits of double precision.
#include "contact/solvers/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction::contact {

namespace {
constexpr double no_answer =
    1e-8; ///< relative: so much is not rounding's, whatever it may do to a point that hardly gives way
constexpr double left_undone = 0.4; ///< of the forces there without any: half of two gaps, if nothing gives
constexpr double unfelt = 1e9;      ///< times the forces there are: displacements have no digits left
constexpr double large = 10;        ///< times those without any: forces that may hide what they leave undone
constexpr double hidden = 1e-6;     ///< of the forces there without any, beside the largest

/// Where nothing can move a point, is it pressed in by more than rounding beside the tractions elsewhere? Its
/// own force may be any.
bool jams(Problem const& problem, Vector const& force) {
  double deepest = 0, elsewhere = 0; // Pa
  double const last_digits = 1e-12 * problem.free.lpNorm<Eigen::Infinity>();
  for (Index i = 0; i < problem.size(); ++i) {
    auto const& point = problem.points[ix(i)];
    Index const row = problem.dim * i;
    double const pressed = point.shift[0] - problem.free[row];
    if (problem.W.diagonal(row) == 0)
      deepest =
          std::max(deepest, pressed > last_digits ? natural_scale(problem, i) * pressed / point.area : 0.0);
    else
      elsewhere = std::max(elsewhere, force.segment(row, problem.dim).norm() / point.area);
  }
  return deepest > no_answer * elsewhere;
}
/// By which the force of a point's bond follows where it is, N/m.
double bond_stiffness(Problem const& problem, Index i, Vector const& x) {
  auto const& point = problem.points[ix(i)];
  if (point.adhesion < 0)
    return 0;
  return by_dimension(problem.dim, [&]<int D>() {
    Local<D> const at = x.segment<D>(D * i);
    return point.area *
           interface::adhere<D>(problem.adhesions[ix(point.adhesion)], point.bond, at).traction_by_x.norm();
  });
}
} // namespace

double forces_there(Problem const& problem, Vector const& guess) {
  double there = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    auto const& point = problem.points[ix(i)];
    auto const size = [&](Vector const& v) { return v.segment(problem.dim * i, problem.dim).norm(); };
    double const given = natural_scale(problem, i) * (size(problem.free) + std::abs(point.shift[0]));
    double const bond =
        point.adhesion < 0 ? 0 : interface::scales(problem.adhesions[ix(point.adhesion)]).strength;
    there = std::max({there, (size(guess) + given) / point.area, bond});
  }
  return there > 0 ? there : std::numeric_limits<double>::infinity();
}

double residual_felt(Problem const& problem, Vector const& force) {
  double const there = forces_there(problem, Vector::Zero(force.size()));
  double largest = 0;
  for (Index i = 0; i < problem.size(); ++i)
    largest =
        std::max(largest, force.segment(problem.dim * i, problem.dim).norm() / problem.points[ix(i)].area);
  return there * std::max(hidden, left_undone / (1 + std::pow(largest / (large * there), 2)));
}

bool felt(Problem const& problem, Solution const& solution, double there) {
  if (jams(problem, solution.force))
    return false;
  if (solution.verdict.residual > residual_felt(problem, solution.force))
    return false;
  for (Index i = 0; i < problem.size(); ++i)
    if (solution.force.segment(problem.dim * i, problem.dim).norm() >
        unfelt * there * problem.points[ix(i)].area)
      return false;
  return true;
}

bool within_rounding(Problem const& problem, Solution const& solution) {
  if (!(solution.verdict.relative() <= no_answer))
    return false;
  Vector const x = displacement(problem, solution.force);
  double largest = 0; // Pa
  for (Index i = 0; i < problem.size(); ++i) {
    auto const of = [&](Vector const& v) { return v.segment(problem.dim * i, problem.dim).norm(); };
    double const stiffness = natural_scale(problem, i) + bond_stiffness(problem, i, x);
    double const size = of(solution.force) + stiffness * (of(x) + of(problem.free));
    largest = std::max(largest, size / problem.points[ix(i)].area);
  }
  double const terms = std::sqrt(static_cast<double>(problem.free.size()));
  return solution.verdict.residual <= 2 * std::numeric_limits<double>::epsilon() * terms * largest;
}

} // namespace stiction::contact
