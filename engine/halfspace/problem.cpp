// A half space's problem as it begins, as a list, and its judge.
#include "halfspace/problem.hpp"

#include <limits>

namespace stiction::halfspace {

Problem::Problem(Surface const& surface, interface::Law const& law) : area(surface.grid().area()) {
  using interface::Status;
  shared.dim = surface.components();
  shared.W = surface.delassus();
  shared.free = Vector::Zero(surface.rows());
  if (law.adhesion)
    shared.adhesions.push_back(*law.adhesion);
  if (law.mu_follows())
    shared.frictions.push_back(*law.friction);
  mu = {law.mu(Status::open), law.mu(Status::stick), law.mu(Status::slip)};
  closed.assign(ix(surface.grid().size()), 0);
}

contact::Problem Problem::listed() const {
  contact::Problem problem = shared;
  for (Index i = 0; i < size(); ++i)
    problem.points.push_back(point(i));
  if (!has_start())
    return problem;
  problem.start = Vector::Zero(problem.free.size());
  for (Index i = 0; i < size(); ++i)
    problem.start[problem.dim * i] = old->gap[i];
  return problem;
}

contact::Verdict judge(Problem const& problem, Vector const& force, Vector const& x, double lift) {
  if (!x.allFinite() || !force.allFinite())
    return {std::numeric_limits<double>::infinity(), 0};
  contact::Verdict verdict;
  double const rho = contact::natural_scale(problem.shared, 0);
  contact::by_dimension(problem.shared.dim, [&]<int D>() {
    for (Index i = 0; i < problem.size(); ++i)
      contact::judge_point<D>(
          problem.shared, problem.point(i), rho,
          {force.segment<D>(D * i), x.segment<D>(D * i), problem.shared.free[D * i] + lift}, verdict);
  });
  return verdict;
}

} // namespace stiction::halfspace
