// The least of several repetitions, as other work on the machine only ever adds.
#include "scene/run/alone.hpp"

#include <algorithm>
#include <limits>

#include "dynamics/bulk/timer.hpp"

namespace stiction::scene {

namespace {

constexpr double enough = 0.2; // s for each, or `most_times` it, at least `fewest_times`
constexpr int most_times = 1000, fewest_times = 3;

template<class Work> double least_of(Work const& work) {
  double best = std::numeric_limits<double>::infinity(), spent = 0;
  for (int k = 0; k < most_times && (k < fewest_times || spent < enough); ++k) {
    double const seconds = work();
    best = std::min(best, seconds);
    spent += seconds;
  }
  return best;
}

template<class Work> double timed(Work const& work) {
  double seconds = 0;
  {
    dynamics::Timer const timer(seconds);
    work();
  }
  return seconds;
}

} // namespace

std::map<std::string, double> alone(halfspace::Surface const& surface) {
  Vector const one = Vector::Ones(surface.rows());
  Vector other = one;
  std::map<std::string, double> found;
  found["product"] = least_of([&] { return timed([&] { surface.add_product(one, other); }); });
  found["preconditioning"] = least_of([&] { return timed([&] { surface.solve(0, one, other); }); });
  return found;
}

std::map<std::string, double> alone(dynamics::Stepper& stepper, dynamics::Model const& model,
                                    dynamics::State const& state, double dt) {
  auto& bulk = stepper.bulk();
  auto const weights = dynamics::weights(model.scheme);
  Vector force;
  std::map<std::string, double> found;
  found["force_pass"] =
      least_of([&] { return timed([&] { static_cast<void>(bulk.internal_force(state.u, force)); }); });
  double stiffness = std::numeric_limits<double>::infinity();
  found["factorization"] = least_of([&] {
    dynamics::Cost cost;
    static_cast<void>(bulk.factorize(state.u, weights, dt, cost));
    stiffness = std::min(stiffness, cost.assembly);
    return cost.factorization / static_cast<double>(cost.factorizations);
  });
  found["stiffness_pass"] = stiffness;
  Vector b = Vector::Ones(bulk.unknowns());
  found["solve"] = least_of([&] { return timed([&] { bulk.factor().solve(b); }); });
  return found;
}

} // namespace stiction::scene
