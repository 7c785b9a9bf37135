// A nominal step in halves of halves where it fails.
#pragma once

namespace stiction::scene {

/// Attempts at a nominal step: each that fails is made half as long, sizes grow back where the halves align.
class Halves {
public:
  /// at_most: how often a step may be halved.
  explicit Halves(int at_most) : at_most_(at_most) {}
  /// Part of the nominal step that the next attempt is of.
  [[nodiscard]] double part() const { return over_whole(size()); }
  /// Part of it that is done.
  [[nodiscard]] double done() const { return over_whole(done_); }
  [[nodiscard]] bool all_done() const { return done_ == whole(); }
  [[nodiscard]] bool shortest() const { return halved_ == at_most_; }
  /// The attempt failed; may it be made half as long?
  [[nodiscard]] bool cut() {
    successes_ = 0;
    return ++halved_ <= at_most_;
  }
  /// The attempt was accepted; is the next one twice as long?
  [[nodiscard]] bool advance() {
    long const made = size();
    done_ += made;
    if (!(halved_ > 0 && ++successes_ >= 2 && done_ % (2 * made) == 0))
      return false;
    --halved_;
    successes_ = 0;
    return true;
  }
  /// The next nominal step, in parts as long as those of the last one.
  void begin() { done_ = 0; }
  template<class Archive> void visit(Archive& archive) { archive(done_, halved_, successes_); }

private:
  [[nodiscard]] long whole() const { return 1L << at_most_; }
  [[nodiscard]] long size() const { return whole() >> halved_; }
  [[nodiscard]] double over_whole(long parts) const {
    return static_cast<double>(parts) / static_cast<double>(whole());
  }
  int at_most_;
  long done_ = 0; ///< of whole()
  int halved_ = 0, successes_ = 0;
};

} // namespace stiction::scene
