// What a run will take, counted before its first step as the run counts it: factorizations, solves, contact.
#pragma once
#include "dynamics/bulk/bulk_system.hpp"
#include "scene/explain/facts.hpp"
#include "scene/explain/fill.hpp"
#include "scene/explain/passes.hpp"

namespace stiction::scene {

/// The contact problems of a run, on average.
struct ContactForecast {
  double points = 0;                         ///< near contact
  double rows = 0;                           ///< of a problem
  double used = 0;                           ///< surface unknowns that they move
  double support = 0;                        ///< of these those that normals which turn make stiff
  bool sweeps = false;                       ///< answered by sweeps, or by factorizations or cycles
  double iterations = 0;                     ///< of the solver, a problem
  double operations = 0;                     ///< of the solver, a problem
  double columns = 0, column_operations = 0; ///< of the compliance, a factorization
  double elimination = 0;                    ///< operations that make a problem
};

/// Bytes of the program itself.
inline constexpr double program_bytes = 30e6;

struct Forecast {
  Fill fill;
  PassOperations pass;
  ContactForecast contact;
  double steps = 0, iterations = 0, factorizations = 0; ///< of the run
  /// Operations, as the counter `work` of a run.
  [[nodiscard]] double work() const;
  /// Bytes at the peak, of the program and all that it reads too.
  [[nodiscard]] double memory() const;
  double cells_bytes = 0, factor_bytes = 0, matrix_bytes = 0, contact_bytes = 0, base_bytes = 0;
};

/// start: the state at t = 0; bulk: of the model, for any purpose.
[[nodiscard]] Forecast forecast(Facts const& facts, dynamics::State const& start,
                                dynamics::BulkSystem const& bulk);

} // namespace stiction::scene
