// Numeric Cholesky factorization over the supernodes that CHOLMOD has found, shared by all threads.
#pragma once
#include <atomic>
#include <memory>
#include <span>

#include "linear/pattern.hpp"

struct cholmod_factor_struct;

namespace stiction::linear {

/// Supernodes cut into panels of columns, each of which gathers what those before it do to it, in their
/// order: the numbers are the same however many threads there are, and whoever does what.
class Panels {
public:
  /// symbolic: supernodal, of this pattern; has to outlive this.
  Panels(cholmod_factor_struct const& symbolic, Pattern const& pattern);
  /// x: where the factor's numbers go, as CHOLMOD keeps them; of values[entries] of the lower triangle.
  /// False if the matrix is not positive definite.
  [[nodiscard]] bool factorize(std::span<double const> values, double* x);

private:
  /// Columns of one supernode, with their rows from the first of them on.
  struct Panel {
    Index begin, columns, rows;
    Index const* row;  ///< [rows], numbers of unknowns
    std::ptrdiff_t at; ///< of its first diagonal number among all
    Index stride;      ///< from column to column
  };
  /// Rows `first` to before `last` of a panel are in the columns of the one that it acts on.
  struct Update {
    Index source, first, last;
  };
  struct Scratch;

  void cut(cholmod_factor_struct const& symbolic);
  void find_updates();
  void share_work();
  void place_entries(cholmod_factor_struct const& symbolic, Pattern const& pattern);
  [[nodiscard]] Index parent(Index panel) const;
  [[nodiscard]] double operations(Index panel) const;
  [[nodiscard]] std::span<Update const> updates_of(Index panel) const {
    return {updates_.data() + first_update_[ix(panel)], updates_.data() + first_update_[ix(panel) + 1]};
  }
  void fill(std::span<double const> values, double* x) const;
  [[nodiscard]] bool finish(Index panel, double* x);
  void apply(Update const& update, Panel const& to, Scratch& scratch, double* x) const;
  template<class Visit> void each_update(Visit const& visit) const;

  Index unknowns_ = 0, largest_ = 0; ///< numbers that one update takes at most
  std::size_t numbers_ = 0;          ///< of the factor
  std::vector<Panel> panels_;
  Indices panel_of_; ///< [unknowns]
  std::vector<Update> updates_;
  std::vector<std::size_t> first_update_;     ///< [panels + 1]
  std::vector<Indices> trees_;                ///< panels that need no others, the longest work first
  Indices above_;                             ///< those that need the trees
  Indices place_;                             ///< [entries], where each goes
  std::unique_ptr<std::atomic<bool>[]> done_; ///< [panels]
  std::atomic<bool> failed_{false};
};

} // namespace stiction::linear
