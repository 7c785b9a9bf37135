// Description of the bounds.
#include "dynamics/adaptivity/accuracy.hpp"

#include <fmt/format.h>

namespace stiction::dynamics {

core::Schema const& Accuracy::schema() {
  using core::Need;
  static auto const made =
      core::Describe<Accuracy>{
          "accuracy",
          "steps chosen as the run goes, from an estimate of their local error; with inertia a "
          "stage's step halved or doubled; steps.csv tells every cut, growth and aim at an event",
          "Hairer, Norsett, Wanner, Solving ODE I, II.4"}
          .number(
              "tolerance", &Accuracy::tolerance, "1", {0, 1, true, false}, Need::optional,
              "local error of a step: of u (if there is inertia) over the largest u so far, and of any beta")
          .number("beta_change", &Accuracy::beta_change, "1", {0, 1, true, false}, Need::optional,
                  "largest change of any beta in a step")
          .number("events", &Accuracy::events, "s", core::non_negative, Need::optional,
                  "time within which touch, separation and the ends of beta are located; 0: they are not")
          .integer("factors", &Accuracy::factors, {2, 20, false, false}, Need::optional,
                   "step sizes whose factor is kept, with inertia; each takes the memory of one")
          .number("smallest", &Accuracy::smallest, "s", core::non_negative, Need::optional,
                  "step that is taken whatever its error; 0: a stage's step halved `halvings` times")
          .number("largest", &Accuracy::largest, "s", core::non_negative, Need::optional,
                  "no step is longer; 0: ten of a stage's steps")
          .build();
  return made;
}

core::Complaints Accuracy::check() const {
  if (largest == 0 || smallest <= largest)
    return {};
  return {{"", "smallest",
           fmt::format("= {:g} s is above largest = {:g} s; give a smaller one", smallest, largest)}};
}

} // namespace stiction::dynamics
