// Memory from the analysed pattern, time from one force, one assembly and one factorization at rest.
#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "dynamics/bulk/timer.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

/// Of a step: Newton iterations, and how often the matrix is assembled and factored anew; about what the
/// studies of this repository take (3.8 and 0.35 in section, 4.3 and 0.25 in space, 5.8 and 0.07 with
/// inertia).
constexpr double iterations = 4, factorizations = 1.0 / 3;
constexpr Index most_columns =
    480; // of the surface's compliance that are timed: few are near contact if many

/// Seconds of one pass each.
struct Passes {
  double force = 0, assembly = 0, factorization = 0, inverse = 0, solve = 0;
  bool regular = false; ///< did the factorization at rest succeed?
};

/// The first call warms caches and takes memory; the second is timed.
template<class Call> double seconds_of(Call&& call) {
  call();
  double seconds = 0;
  {
    dynamics::Timer const timer(seconds);
    call();
  }
  return seconds;
}

Passes measure(Facts const& facts, dynamics::BulkSystem& bulk) {
  auto const& model = *facts.scene->model;
  Vector const u = Vector::Zero(model.dofs());
  auto const weights = dynamics::weights(model.scheme);
  Passes passes;
  Vector force, rhs = Vector::Ones(bulk.unknowns());
  passes.force = seconds_of([&] { static_cast<void>(bulk.internal_force(u, force)); });
  dynamics::Cost cold, cost;
  passes.regular = bulk.factorize(u, weights, facts.longest_step, cold) &&
                   bulk.factorize(u, weights, facts.longest_step, cost);
  passes.assembly = cost.assembly;
  passes.factorization = cost.factorization;
  if (!passes.regular)
    return passes;
  {
    dynamics::Timer const timer(passes.inverse);
    Indices all(ix(std::min(bulk.factor().surface(), most_columns)));
    std::iota(all.begin(), all.end(), 0);
    Dense compliance;
    bulk.factor().compliance(all, compliance);
  }
  passes.solve = seconds_of([&] { bulk.factor().solve(rhs); });
  return passes;
}

/// Gradients and volumes at the quadrature points, as solid::PreparedBlock keeps them, bytes.
double cell_memory(Facts const& facts) {
  double numbers = 0;
  int const width = facts.scene->part.kinematics == solid::Kinematics::three_dimensional ? 3 : 2;
  for (auto const& body : facts.bodies)
    for (auto const& block : body.body->mesh.blocks) {
      auto const nodes = static_cast<double>(mesh::info(block.kind).nodes);
      auto const cells = static_cast<double>(block.nodes.size()) / nodes;
      auto const points = static_cast<double>(mesh::stiffness_rule(block.kind).weights.size());
      numbers += cells * (points * (width * nodes + 1) + nodes * (nodes + 1) / 4 * width * width);
    }
  return 8 * numbers;
}

void add(Section& section, Line line) {
  section.lines.push_back(std::move(line));
}

void add_memory(Facts const& facts, dynamics::BulkSystem& bulk, Section& section) {
  auto const effort = bulk.factor().effort();
  auto const entries = static_cast<double>(bulk.factor().pattern().entries());
  Index const trailing = bulk.factor().surface();
  double const columns =
      static_cast<double>(std::min(trailing, most_columns)) * static_cast<double>(trailing);
  double const factor = 8 * effort.entries, cells = cell_memory(facts),
               dense = 8 * (bulk.factor().surface_numbers() + columns);
  double const matrix = entries * (4 + 8 + (facts.dynamic() ? 8 : 0));
  add(section, {"unknowns", counted(bulk.unknowns()), static_cast<double>(bulk.unknowns()), "1", "free"});
  add(section, {"contact unknowns", counted(trailing), static_cast<double>(trailing), "1",
                "of contact surfaces; what they give way is found for those near contact"});
  add(section,
      {"factor", counted(effort.entries), effort.entries, "1",
       fmt::format("numbers of the Cholesky factor; {:.2g} Gflop to make it", effort.operations * 1e-9)});
  double const total = factor + matrix + dense + cells;
  add(section,
      {"memory", human(total, "B"), total, "B",
       fmt::format("factor {}, matrix {}, contact surfaces {}, cells {}; runs peak at about 1.5 times "
                   "that, and 25 MB for the program",
                   human(factor, "B"), human(matrix, "B"), human(dense, "B"), human(cells, "B"))});
}

} // namespace

void describe_cost(Facts const& facts, dynamics::BulkSystem& bulk, Explanation& explanation) {
  Section section{"Cost", {}};
  add_memory(facts, bulk, section);
  auto const passes = measure(facts, bulk);
  auto const steps = static_cast<double>(facts.steps);
  add(section, {"steps", counted(steps), steps, "1", "if none is halved"});
  if (!passes.regular) {
    add(section, {"time", "not known", std::numeric_limits<double>::quiet_NaN(), "s",
                  "the stiffness at rest is singular, so that no factorization could be timed"});
    explanation.sections.push_back(std::move(section));
    return;
  }
  double const passed = bulk.linear() ? 1 : iterations, // explicit schemes: the matrix is M alone
      renewed = bulk.linear() ? 0 : factorizations;
  double const step = passes.force + passed * (passes.force + passes.solve) +
                      renewed * (passes.assembly + passes.factorization + passes.inverse);
  add(section,
      {"one step", human(step, "s"), step, "s",
       fmt::format("Newton iterations {} times force {} and solve {}; {} assembly {}, factorization {} and "
                   "compliance of the surface {}",
                   passed, human(passes.force, "s"), human(passes.solve, "s"),
                   renewed > 0 ? "in every third step" : "once in the run", human(passes.assembly, "s"),
                   human(passes.factorization, "s"), human(passes.inverse, "s"))});
  add(section, {"time", human(steps * step, "s"), steps * step, "s",
                "measured at rest on this machine as busy as it is; the numbers of iterations and "
                "factorizations are guesses, contact solver and output are not counted"});
  explanation.sections.push_back(std::move(section));
}

} // namespace stiction::scene
