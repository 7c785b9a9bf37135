// What the ranks that share a case do together as it runs; one process that has it alone is all of them.
#pragma once
#include "linear/ranks.hpp"

namespace stiction::scene {

class AllRanks {
public:
  /// Null: this process alone.
  explicit AllRanks(linear::Ranks const* ranks) : ranks_(ranks) {}
  [[nodiscard]] bool several() const { return ranks_ != nullptr; }
  [[nodiscard]] int count() const { return several() ? ranks_->count() : 1; }
  /// Of several ranks the first writes the case's files.
  [[nodiscard]] bool writes() const { return !several() || ranks_->rank() == 0; }

  /// The largest of what each says. Every call is one of all, as that of the next two.
  [[nodiscard]] double largest(double said) const { return several() ? ranks_->largest(said) : said; }
  [[nodiscard]] bool any(bool said) const { return largest(said ? 1 : 0) > 0; }
  [[nodiscard]] bool same(double said) const { return largest(said) == -largest(-said); }

  /// Adds up what all have taken from their machines; a call of all.
  void note_use();
  /// Of all when that was last noted, s and bytes; before, of this process alone, now.
  [[nodiscard]] double cpu_seconds() const;
  [[nodiscard]] double peak_memory() const;

private:
  linear::Ranks const* ranks_;
  double cpu_ = 0, memory_ = 0;
};

} // namespace stiction::scene
