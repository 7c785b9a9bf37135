// Problems and the list of all solvers, for the tests of contact solvers.
#pragma once
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "contact/solvers/solver.hpp"

namespace stiction::test {

using contact::Problem;
using contact::Solution;

namespace detail {
template<class... T>
std::vector<std::pair<std::string, contact::SolverChoice>> all(double tolerance, std::variant<T...> const*) {
  std::vector<std::pair<std::string, contact::SolverChoice>> list;
  auto const add = [&](auto solver) {
    solver.tolerance = tolerance;
    list.emplace_back(solver.schema().name, solver);
  };
  (add(T{}), ...);
  return list;
}
} // namespace detail

/// Every solver with this tolerance, by name.
inline std::vector<std::pair<std::string, contact::SolverChoice>> all_solvers(double tolerance = 1e-10) {
  return detail::all(tolerance, static_cast<contact::SolverChoice const*>(nullptr));
}

inline Solution solve(contact::SolverChoice const& choice, Problem const& problem) {
  return contact::make_solver(choice)->solve(problem, Vector::Zero(problem.free.size()));
}

/// One dry point in the plane.
inline Problem one_point(Dense const& W, Vector const& free, double mu) {
  Problem problem;
  problem.W = W;
  problem.free = free;
  problem.points = {{1, mu, -1, {}}};
  return problem;
}

/// n points with W = B B^T / columns + shift I; areas about `area`.
inline Problem random_problem(int dim, int n, unsigned seed, double shift) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  int const size = dim * n;
  Dense B(size, size);
  for (Eigen::Index i = 0; i < B.size(); ++i)
    B.data()[i] = normal(random);
  Problem problem;
  problem.dim = dim;
  problem.W = 1e-6 * (B * B.transpose() / size + shift * Dense::Identity(size, size));
  problem.free.resize(size);
  for (int i = 0; i < size; ++i)
    problem.free[i] = 1e-4 * (normal(random) - (i % dim == 0 ? 0.5 : 0.0));
  for (int i = 0; i < n; ++i)
    problem.points.push_back({1e-4 * (0.5 + uniform(random)), 0.6 * uniform(random), -1, {}});
  return problem;
}

/// Gives every second point a bond that may grow, weaken or break, softening at most by `softness` = W C A.
inline void add_adhesion(Problem& problem, double softness, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  interface::Rcc law;
  double const stiffness = softness * contact::natural_scale(problem, 0) / problem.points[0].area;
  double const length = 5e-5; // u0
  law.C_n = law.C_t = law.C_t2 = stiffness;
  law.w = stiffness * length * length;
  law.b = law.w * 1e-3;
  auto damaged = law;
  damaged.friction = interface::BondFriction::damage;
  problem.adhesions = {law, damaged};
  for (std::size_t i = 0; i < problem.points.size(); i += 2) {
    auto& point = problem.points[i];
    point.adhesion = static_cast<int>(i / 2 % 2);
    point.bond = {{0.3 + 0.7 * uniform(random), {0, 0}}, 2e-4, uniform(random) < 0.5};
    for (int k = 0; k < problem.dim - 1; ++k)
      point.bond.old.stretch[k] = length * (uniform(random) - 0.5);
  }
}

} // namespace stiction::test
