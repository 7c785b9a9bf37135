// Products of Gauss rules, and symmetric rules on simplices by their orbits.
#include "mesh/cells/quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "linear/decompositions.hpp"

namespace stiction::mesh {

namespace {

/// All points whose barycentric coordinates are permutations of `coordinates`, each with this share of the
/// simplex.
struct Orbit {
  std::vector<double> coordinates; ///< [dim + 1], sum to 1
  double weight;
};

Rule simplex_rule(std::vector<Orbit> orbits, double measure) {
  auto const dim = static_cast<Eigen::Index>(orbits.front().coordinates.size()) - 1;
  std::vector<double> points, weights;
  for (auto& [coordinates, weight] : orbits) {
    std::sort(coordinates.begin(), coordinates.end());
    do {
      points.insert(points.end(), coordinates.begin() + 1, coordinates.end());
      weights.push_back(weight * measure);
    } while (std::next_permutation(coordinates.begin(), coordinates.end()));
  }
  auto const count = static_cast<Eigen::Index>(weights.size());
  return {Eigen::Map<Matrix>(points.data(), count, dim), Eigen::Map<Vector>(weights.data(), count)};
}

Rule triangle_rule(std::vector<Orbit> const& orbits) {
  return simplex_rule(orbits, 1.0 / 2);
}

Rule tetrahedron_rule(std::vector<Orbit> const& orbits) {
  return simplex_rule(orbits, 1.0 / 6);
}

Orbit three_equal(double a, double weight) {
  return {{1 - 3 * a, a, a, a}, weight};
}

struct GaussLine {
  std::vector<double> points, weights;
};

GaussLine gauss_line(int n) {
  if (n == 2)
    return {{-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}, {1, 1}};
  if (n == 3)
    return {{-std::sqrt(0.6), 0, std::sqrt(0.6)}, {5.0 / 9, 8.0 / 9, 5.0 / 9}};
  core::expect(n == 4, "Gauss rules have 2, 3 or 4 points a direction");
  double const spread = 2.0 / 7 * std::sqrt(1.2), far = std::sqrt(3.0 / 7 + spread),
               near = std::sqrt(3.0 / 7 - spread), heavy = 0.5 + std::sqrt(30.0) / 36;
  return {{-far, -near, near, far}, {1 - heavy, heavy, heavy, 1 - heavy}};
}

} // namespace

Rule cube_rule(int dim, int n) {
  auto const [x, w] = gauss_line(n);
  auto const count = static_cast<Eigen::Index>(std::lround(std::pow(n, dim)));
  Rule rule{Matrix(count, dim), Vector::Ones(count)};
  for (Eigen::Index i = 0; i < count; ++i) { // the first direction runs fastest
    Eigen::Index rest = i;
    for (Eigen::Index d = 0; d < dim; ++d, rest /= n) {
      auto const k = static_cast<std::size_t>(rest % n);
      rule.points(i, d) = x[k];
      rule.weights[i] *= w[k];
    }
  }
  return rule;
}

Rule line_rule(int n) {
  Dense recurrence = Dense::Zero(n, n);
  for (int k = 1; k < n; ++k)
    recurrence(k, k - 1) = k / std::sqrt(4.0 * k * k - 1);
  Eigen::SelfAdjointEigenSolver<Dense> const solver(recurrence);
  return {solver.eigenvalues(), 2 * solver.eigenvectors().row(0).transpose().array().square()};
}

Rule triangle_1() {
  return triangle_rule({{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 1.0}});
}

Rule triangle_3() {
  return triangle_rule({{{2.0 / 3, 1.0 / 6, 1.0 / 6}, 1.0 / 3}});
}

Rule triangle_6() {
  double const b1 = (8 - std::sqrt(10.0) + std::sqrt(38 - 44 * std::sqrt(0.4))) / 18;
  double const b2 = (8 - std::sqrt(10.0) - std::sqrt(38 - 44 * std::sqrt(0.4))) / 18;
  double const spread = std::sqrt(213125 - 53320 * std::sqrt(10.0));
  return triangle_rule({{{1 - 2 * b1, b1, b1}, (620 + spread) / 3720}, //
                        {{1 - 2 * b2, b2, b2}, (620 - spread) / 3720}});
}

Rule tetrahedron_1() {
  return tetrahedron_rule({{{0.25, 0.25, 0.25, 0.25}, 1.0}});
}

Rule tetrahedron_4() {
  return tetrahedron_rule({three_equal((5 - std::sqrt(5.0)) / 20, 0.25)});
}

Rule tetrahedron_14() {
  constexpr double a = 0.045503704125649649492, b = 0.5 - a;
  return tetrahedron_rule({three_equal(0.31088591926330060980, 0.11268792571801585080),
                           three_equal(0.092735250310891226402, 0.073493043116361949544),
                           {{a, a, b, b}, 0.042546020777081466438}});
}

} // namespace stiction::mesh
