// What links between displacement components do to vectors and to the matrix: u = T q, F_q = T^T F, K_q = T^T
// K T.
#pragma once
#include <map>
#include <span>

#include "dynamics/model/link.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

struct Model;

class Links {
public:
  explicit Links(Model const& model);
  [[nodiscard]] bool empty() const { return links_->empty(); }
  /// Displacements or rates of followers from those of their masters, [degrees of freedom].
  void follow(Vector& u) const;
  /// Forces on followers go to their masters, N.
  void gather(Vector& force) const;
  /// Does this degree of freedom follow others?
  [[nodiscard]] bool follows(Index dof) const { return !empty() && follows_[ix(dof)]; }
  /// Forces of the links, N: from those on followers those on masters for which taken(master) does not hold,
  /// so that no link does work.
  template<class Taken> void react(Vector& force, Taken const& taken) const {
    for (auto const& link : *links_)
      for (auto const& [master, weight] : link.masters)
        if (!taken(master))
          force[master] -= weight * force[link.dof];
  }

  /// Numbers followers: -2, -3, ... in place of the unknowns that they have not.
  void number(Indices& unknown_of) const;
  /// Instead of followers their masters' unknowns.
  void expand(Indices const& unknown_of, Indices& clique) const;
  /// The unknown that moves as this follower does; -1 if there is none, or if it is a sum.
  [[nodiscard]] Index carrier(Index number, Indices const& unknown_of) const;

  /// Makes room beside the matrix for the entries between these, of which some may be followers.
  void add_slots(std::span<Index const> numbers);
  /// Entry (i, j) where one at least is a follower: its place after the matrix' own; -1 where there is none.
  [[nodiscard]] Index slot(linear::Pattern const& pattern, Index i, Index j) const;
  /// Where entries beside the matrix go, once they all are there.
  void settle(linear::Pattern const& pattern, Indices const& unknown_of);
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  /// values[entries + slots]: adds what stands beside the matrix to it.
  void fold(std::span<double> values) const;
  /// visit(entry, part): where the entry (i, j) of K goes, given by numbers.
  template<class Visit>
  void each_entry(linear::Pattern const& pattern, Indices const& unknown_of, std::pair<Index, Index> numbers,
                  Visit&& visit) const {
    auto const [a, b] = numbers;
    auto const first = parts(a, unknown_of), second = parts(b, unknown_of);
    for (std::size_t i = 0; i < first.size(); ++i)
      for (std::size_t j = 0; j < (a == b ? i + 1 : second.size()); ++j) {
        auto const [row, left] = first[i];
        auto const [column, right] = second[j];
        visit(pattern.find(row, column), left * right * (a != b && row == column ? 2 : 1));
      }
  }

private:
  using Parts = std::vector<std::pair<Index, double>>; ///< unknowns and weights
  [[nodiscard]] Parts parts(Index number, Indices const& unknown_of) const;
  struct Fold {
    Index slot, entry;
    double part;
  };
  std::vector<Link> const* links_;
  std::vector<bool> follows_;                      ///< [degrees of freedom]; empty without links
  std::map<std::pair<Index, Index>, Index> slots_; ///< of numbers, the larger first
  std::vector<Fold> folds_;
};

/// Where entries are by the numbers of their unknowns: in the matrix, or beside it.
struct Places {
  linear::Pattern const& pattern;
  Links const& links;
  /// -1 of an unknown that there is not.
  [[nodiscard]] Index operator()(Index i, Index j) const {
    return i >= 0 && j >= 0 ? pattern.find(i, j) : links.empty() ? -1 : links.slot(pattern, i, j);
  }
};

} // namespace stiction::dynamics
