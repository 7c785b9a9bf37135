// Processes that share one case, as what they compute with sees them; a component that is loaded has the only
// kind.
#pragma once
#include <memory>
#include <span>

#include "linear/block_matrix.hpp"

namespace stiction::linear {

/// How nodes are numbered so that those of each rank follow each other.
struct RankNodes {
  Indices first;  ///< [ranks + 1], of each rank
  Indices beyond; ///< nodes of other ranks that own rows of the matrix couple with, ascending
};

/// What multigrid does below its finest level, over all ranks together. Every call is one of all ranks.
class CoarseLevels {
public:
  virtual ~CoarseLevels() = default;
  /// Prolongators and coarse matrices of A, of which a rank hands in its own rows, columns numbered by node.
  /// modes: motions that take no energy where nothing is held, of own nodes, [3 nodes, 6].
  virtual void set_up(BlockMatrix<3, 3> const& A, Dense const& modes) = 0;
  /// The coarse matrices of A + change from now on, with the same prolongators.
  virtual void change(BlockMatrix<3, 3> const& change) = 0;
  /// z = P (about (P^T A P)^-1) P^T r for own nodes; with what was changed, or without.
  virtual void correct(Vector const& r, bool changed, Vector& z) = 0;
};

/// Every call is one of all ranks.
class Ranks {
public:
  virtual ~Ranks() = default;
  [[nodiscard]] virtual int rank() const = 0;
  [[nodiscard]] virtual int count() const = 0;
  /// Each number summed over the ranks, the same to the last bit on all.
  virtual void sum(std::span<double> numbers) const = 0;
  [[nodiscard]] virtual double largest(double number) const = 0;
  /// The numbers of all ranks one behind the other: of rank r those from first[r] to before first[r + 1].
  virtual void gather(Vector const& own, Indices const& first, Vector& all) const = 0;
  /// What fills `beyond` (three numbers a node) with what their ranks have.
  class Border {
  public:
    virtual ~Border() = default;
    virtual void exchange(Vector const& own, Vector& beyond) = 0;
  };
  [[nodiscard]] virtual std::unique_ptr<Border> border(RankNodes const& nodes) const = 0;
  [[nodiscard]] virtual std::unique_ptr<CoarseLevels> coarse_levels(Indices const& first) const = 0;

  [[nodiscard]] double sum(double number) const {
    sum({&number, 1});
    return number;
  }

  /// Have all come here within so many seconds? The last call of all.
  [[nodiscard]] virtual bool part(double seconds) const = 0;
  /// Ends the processes of all ranks.
  [[noreturn]] virtual void abort(int code) const = 0;
};

/// The function that a component has to have, by this name: joins the ranks that were started together.
using JoinRanks = Ranks& (*)();
inline constexpr char const* join_ranks_name = "stiction_join_ranks";

} // namespace stiction::linear
