// The finest level of multigrid over ranks: each has the rows of its own nodes.
#pragma once
#include "linear/multigrid.hpp"
#include "linear/ranks.hpp"
#include "linear/single_level.hpp"
#include "linear/symmetric_product.hpp"

namespace stiction::linear {

/// Vectors are those of own nodes. Every call that is not const is one of all ranks.
class RankMultigrid {
public:
  RankMultigrid(Ranks const& ranks, Indices first);
  /// A: own rows, columns numbered by node; modes as CoarseLevels wants them.
  void set_up(BlockMatrix<3, 3> A, Dense const& modes);
  /// Holds these nodes of all ranks and no others, in ascending order; sooner if they are those of before,
  /// with other stiffnesses, of which some may be 0.
  void hold(std::vector<HeldNode> held);
  /// y = A x
  void product(Vector const& x, Vector& y);
  /// z = about A^-1 r, or (A + held)^-1 r, by one V cycle: symmetric, and positive definite where A is.
  void cycle(Vector const& r, bool held, Vector& z);
  [[nodiscard]] double inner(Vector const& a, Vector const& b) const { return ranks_->sum(a.dot(b)); }
  [[nodiscard]] Matrix3 diagonal(Index own) const { return A_.block(own_block_[ix(own)]); }
  [[nodiscard]] double numbers() const { return static_cast<double>(A_.values.size()); }

private:
  [[nodiscard]] bool own(Index node) const { return node >= begin_ && node < end_; }
  void look_beyond();
  void take_own();
  void invert(SingleLevel<3>& level) const;
  void subtract_beyond(Vector& y) const;
  void gather_diagonals(std::vector<HeldNode> const& held);
  [[nodiscard]] BlockMatrix<3, 3> change_of(std::vector<HeldNode> const& held) const;

  Ranks const* ranks_;
  Indices first_;
  Index begin_, end_;
  BlockMatrix<3, 3> A_; ///< own rows, columns by node
  Indices local_;       ///< [blocks] column among own nodes, or behind them among those beyond
  Indices own_block_;   ///< [own nodes], the diagonal ones
  Indices beyond_;
  Indices bordering_;          ///< own nodes that couple with nodes beyond
  BlockMatrix<3, 3> toward_;   ///< [bordering_] those couplings, columns among beyond_
  std::vector<Matrix3> share_; ///< [bordering_] of them, added to the diagonal in sweeps
  SymmetricProduct within_;    ///< with what couples own nodes
  SingleLevel<3> free_, hold_; ///< sweeps in own rows, without what points hold and with it
  std::vector<HeldNode> held_;
  std::vector<Matrix3> held_own_; ///< [own nodes] stiffness
  std::vector<Matrix3> turns_;    ///< [held_] (own + held)^-1 own
  std::unique_ptr<Ranks::Border> border_;
  std::unique_ptr<CoarseLevels> coarse_;
  Vector at_beyond_, rest_, lifted_, load_;
};

} // namespace stiction::linear
