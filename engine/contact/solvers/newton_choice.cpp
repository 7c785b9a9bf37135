// What a script may say of the bi-potential Newton solver.
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

core::Schema const& BipotentialNewton::schema() {
  static auto const made =
      core::Describe<BipotentialNewton>{"newton",
                                        "bi-potential Newton (semismooth), all points at once; after mixed "
                                        "sweeps where many without bonds touch",
                                        "(27)-(29)"}
          .number("tolerance", &BipotentialNewton::tolerance, "1", {1e-16, 1, false, true},
                  core::Need::optional, "natural-map residual over the largest traction")
          .integer("iterations", &BipotentialNewton::iterations, {1, 1e6, false, false}, core::Need::optional,
                   "Newton iterations at most")
          .build();
  return made;
}

} // namespace stiction::contact
