// Probes as columns of a series: what each records and how its row is filled.
#pragma once
#include <functional>

#include "record/series.hpp"
#include "scene/build/build.hpp"

namespace stiction::dynamics {
struct StepError;
}

namespace stiction::scene {

/// Appends the probe's values of one state to a row.
using Sampler = std::function<void(dynamics::State const&, std::vector<double>&)>;

/// Adds the columns "step/..." that every run has.
void add_step_columns(Scene const& scene, record::Series& series);
/// The last of them, of a run that chooses its steps.
void add_step_error(dynamics::StepError const& error, std::vector<double>& row);

/// Where probes declare what they record.
struct Columns {
  /// group, column, unit, meaning, width
  std::function<void(std::string const&, std::string const&, std::string const&, std::string const&, int)>
      add;
  std::function<void(std::string const&, std::string const&, double)> set_attribute;
};
/// The columns of a series, which outlives them.
[[nodiscard]] Columns columns_of(record::Series& series);

[[nodiscard]] std::vector<Sampler> add_probes(Scene const& scene, Columns const& columns);

/// Adds the columns of every probe of the scene, in the order of their names, and returns their samplers.
[[nodiscard]] std::vector<Sampler> add_probes(Scene const& scene, record::Series& series);

/// The part of add_probes that a momentum probe called `name` takes.
[[nodiscard]] Sampler add_momentum(MomentumProbe const& probe, Scene const& scene, Columns const& series,
                                   std::string const& name);

/// The same of a gas probe.
[[nodiscard]] Sampler add_gas(GasProbe const& probe, Scene const& scene, Columns const& series,
                              std::string const& name);

/// The same of a spring probe.
[[nodiscard]] Sampler add_spring(SpringProbe const& probe, Scene const& scene, Columns const& series,
                                 std::string const& name);

} // namespace stiction::scene
