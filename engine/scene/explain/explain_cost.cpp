// Memory and time of a run: what it is forecast to count, at the speeds that this machine shows now.
#include <algorithm>
#include <fmt/format.h>

#include "dynamics/bulk/bulk_choice.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "scene/explain/forecast.hpp"
#include "scene/explain/machine.hpp"

namespace stiction::scene {

namespace {

// Parts of the speed of large dense products: small fronts of a factor, and what is no product at all.
constexpr double front = 200;           // columns of a front at which a factorization has half of it
constexpr double part_of_blocks = 0.11; // of sparse matrices, three by three
constexpr double part_of_solver = 0.3, part_of_columns = 0.3, part_of_elimination = 0.4;
// What takes as long as so many operations of dense products.
constexpr double started = 1e9, frame_node = 1e5, pattern_entry = 1.2e4, factor_unknown = 2e4,
                 solve_unknown = 8e3, solve_diagonal = 25, one_point = 3e4, step_written = 6e6;
constexpr double part_of_stream = 0.5,
                 part_of_cache = 1.5; // what is read not in a row, from memory or caches
constexpr double cache = 4e6;         // bytes
constexpr double vector_passes = 30;  // over all degrees of freedom, an iteration
constexpr double small_unknowns = 2e4, small_operations = 1e9; // of a factor that takes no time worth telling
constexpr double gathered = 20; // passes over the compliance that make a problem of it

/// Seconds of the run by what they go into.
struct Seconds {
  double once = 0;                                     ///< ordering and patterns
  double assembly = 0, factorization = 0, columns = 0; ///< of one factor
  double force = 0, solve = 0, contact = 0;            ///< of one iteration
  double step = 0;                                     ///< beside its iterations
  [[nodiscard]] double iteration() const { return force + solve + contact; }
  [[nodiscard]] double factor() const { return assembly + factorization + columns; }
};

double read(Machine const& machine, double bytes) {
  return bytes / (machine.stream * (bytes < cache ? part_of_cache : part_of_stream));
}

double contact_seconds(Machine const& machine, Fill const& fill, ContactForecast const& contact) {
  if (fill.multigrid)
    return contact.operations / (part_of_blocks * machine.products);
  double const r = contact.rows;
  double const solver = contact.sweeps ? contact.iterations * read(machine, 4 * r * r)
                                       : contact.operations / (part_of_solver * machine.products);
  return solver + contact.elimination / (part_of_elimination * machine.products) +
         read(machine, 8 * gathered * contact.used * contact.used);
}

Seconds seconds_of(Facts const& facts, Forecast const& all) {
  auto const machine = measure_machine();
  auto const passes = measure_passes(*facts.scene->model);
  auto const& fill = all.fill;
  double const dofs = static_cast<double>(facts.scene->model->dofs());
  auto const as_products = [&](double operations) { return operations / machine.products; };
  Seconds time;
  auto const& part = facts.scene->part;
  auto const frames =
      static_cast<double>(part.output.frames) * static_cast<double>(part.schedule.stages.size()) + 1;
  double const nodes = facts.scene->model->node_count();
  time.once =
      1.5 * fill.seconds + as_products(started + pattern_entry * fill.entries + frame_node * frames * nodes);
  time.assembly = passes.stiffness + read(machine, all.cells_bytes + 8 * fill.entries);
  double const columns = fill.factor.operations / std::max(1.0, fill.factor.entries);
  time.factorization = as_products(fill.factor.operations * (1 + front / std::max(1.0, columns)) +
                                   factor_unknown * fill.unknowns) +
                       read(machine, 16 * fill.factor.entries);
  time.columns = as_products(all.contact.column_operations / part_of_columns);
  time.force = passes.force + read(machine, 0.5 * all.cells_bytes + 8 * vector_passes * dofs);
  bool const diagonal = dynamics::weights(facts.scene->model->scheme).explicit_forces;
  time.solve = read(machine, 16 * fill.factor.entries) +
               as_products((diagonal ? solve_diagonal : solve_unknown) * fill.unknowns);
  double points = 0;
  for (auto const& pair : facts.pairs)
    points += pair.pair->size();
  time.contact = contact_seconds(machine, fill, all.contact) + as_products(one_point * points);
  time.step = as_products(step_written) + time.force;
  return time;
}

void add(Section& section, Line line) {
  section.lines.push_back(std::move(line));
}
void add(Section& section, char const* name, double count, std::string meaning) {
  add(section, {name, counted(count), count, "1", std::move(meaning)});
}

void add_sizes(Forecast const& all, Section& section) {
  auto const& [fill, contact] = std::pair{all.fill, all.contact};
  add(section, "unknowns", fill.unknowns, "free");
  add(section, "contact unknowns", fill.surface,
      "of contact surfaces; what they give way is found for those near contact");
  add(section, fill.multigrid ? "multigrid" : "factor", fill.factor.entries,
      fmt::format("numbers of {}; {:.2g} Gflop to make it",
                  fill.multigrid ? "the matrix and its coarser levels, instead of a factor"
                                 : "the Cholesky factor",
                  fill.factor.operations * 1e-9));
  if (contact.rows > 0)
    add(section, "contact rows", contact.rows,
        fmt::format("of a contact problem, about {:.0f} points near contact at once; about {:.0f} {} each",
                    contact.points, contact.iterations,
                    fill.multigrid   ? "cycles of multigrid"
                    : contact.sweeps ? "sweeps"
                                     : "factorizations"));
  double const total = all.memory();
  add(section,
      {"memory", human(total, "B"), total, "B",
       fmt::format("at the peak: factor {}, matrix {}, contact surfaces {}, cells {}, the program {}",
                   human(all.factor_bytes, "B"), human(all.matrix_bytes, "B"), human(all.contact_bytes, "B"),
                   human(all.cells_bytes, "B"), human(all.base_bytes, "B"))});
}

void add_time(Forecast const& all, Seconds const& time, Section& section) {
  double const each = all.iterations / all.steps;
  double const step = time.step + each * time.iteration();
  double const total = time.once + all.steps * time.step + all.iterations * time.iteration() +
                       all.factorizations * time.factor();
  add(section, "steps", all.steps, "if none is halved");
  add(section, "iterations", all.iterations, "of Newton's method, as studies of this kind take them");
  add(section, "factorizations", all.factorizations, "as studies of this kind take them");
  add(section, {"operations", fmt::format("{:.2g}", all.work()), all.work(), "1", "of the whole run"});
  add(section, {"once", human(time.once, "s"), time.once, "s", "ordering of the unknowns, patterns, frames"});
  add(section,
      {"one factor", human(time.factor(), "s"), time.factor(), "s",
       fmt::format("assembly {}, factorization {}, compliance of the surface {}", human(time.assembly, "s"),
                   human(time.factorization, "s"), human(time.columns, "s"))});
  add(section, {"one step", human(step, "s"), step, "s",
                fmt::format("{:.2g} iterations of force {}, solve {} and contact {}", each,
                            human(time.force, "s"), human(time.solve, "s"), human(time.contact, "s"))});
  add(section, {"time", human(total, "s"), total, "s",
                "at the speed of this machine as busy as it is; steps that are cut come on top"});
}

} // namespace

bool describe_cost(Facts const& facts, dynamics::State const& start, dynamics::BulkSystem const& bulk,
                   Explanation& explanation) {
  auto const all = forecast(facts, start, bulk);
  auto const time = seconds_of(facts, all);
  Section section{"Cost", {}};
  add_sizes(all, section);
  if (auto const why = dynamics::kept_from_multigrid(*facts.scene->model); !why.empty())
    add(section, {"multigrid", "not taken", std::numeric_limits<double>::quiet_NaN(), "1",
                  "it would be quicker for bodies of this size, but " + why});
  add_time(all, time, section);
  bool const cheap = all.fill.unknowns < small_unknowns && all.fill.factor.operations < small_operations;
  if (!cheap)
    add(section, {"advice", "not sought", std::numeric_limits<double>::quiet_NaN(), "1",
                  "whether a body may be rigid or the run quasi-static takes a factorization at rest; ask "
                  "`explain` of a coarser mesh"});
  explanation.sections.push_back(std::move(section));
  return cheap;
}

} // namespace stiction::scene
