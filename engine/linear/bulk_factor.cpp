// What all factors share, the diagonal one, and which to take.
#include "linear/bulk_factor.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "linear/sparse_factor.hpp"

namespace stiction::linear {

bool BulkFactor::factorize(std::span<double> values, std::vector<ColumnEntry> columns, Hold hold) {
  auto const& columns_at = pattern().columns;
  core::expect(values.size() == pattern().rows.size(), "one value per entry of the pattern");
  hold_ = 0;
  identity_ = std::make_shared<char>();
  bool const hold_at_once = hold == Hold::always && surface_ > 0;
  if (!hold_at_once && take(values))
    return add(std::move(columns));
  if (surface_ == 0)
    return false;
  auto const diagonal = [&](Index j) -> double& { return values[ix(columns_at[ix(j)])]; };
  for (Index j = 0; j < pattern().size(); ++j)
    hold_ = std::max(hold_, 10 * diagonal(j));
  for (Index j = first_of_surface(); j < pattern().size(); ++j)
    diagonal(j) += hold_;
  return take(values) && add(std::move(columns));
}

std::vector<Vector> BulkFactor::condense_all(std::span<Vector* const> b) {
  std::vector<Vector> motions;
  for (auto* const one : b)
    motions.push_back(condense(*one));
  return motions;
}

void BulkFactor::expand_all(std::span<Vector const* const> surface_loads, std::span<Vector* const> b) {
  for (std::size_t k = 0; k < b.size(); ++k)
    expand(*surface_loads[k], *b[k]);
}

void BulkFactor::solve(Vector& b) {
  static_cast<void>(condense(b));
  expand(Vector::Zero(surface_), b);
}

namespace {

/// As of a lumped mass.
class DiagonalFactor : public BulkFactor {
public:
  DiagonalFactor(Pattern pattern, Index surface) : BulkFactor(surface), pattern_(std::move(pattern)) {}
  [[nodiscard]] std::unique_ptr<BulkFactor> another() const override {
    return std::make_unique<DiagonalFactor>(pattern_, surface());
  }
  [[nodiscard]] Vector condense(Vector& b) override {
    b.array() /= diagonal_.array();
    return b.tail(surface());
  }
  void expand(Vector const& surface_load, Vector& b) override {
    b.tail(surface()).array() += surface_load.array() / diagonal_.tail(surface()).array();
  }
  void compliance(Indices const& used, Dense& C) override {
    auto const n = static_cast<Index>(used.size());
    C.setZero(n, n);
    for (Index i = 0; i < n; ++i)
      C(i, i) = 1 / diagonal_[first_of_surface() + used[ix(i)]];
  }
  [[nodiscard]] Pattern const& pattern() const override { return pattern_; }
  [[nodiscard]] Effort effort() const override {
    auto const n = static_cast<double>(pattern_.size());
    return {n, n};
  }
  [[nodiscard]] double surface_numbers() const override { return 0; }

protected:
  [[nodiscard]] bool take(std::span<double const> values) override {
    diagonal_ = Eigen::Map<Vector const>(values.data(), static_cast<Eigen::Index>(values.size()));
    return (diagonal_.array() > 0).all() && diagonal_.allFinite();
  }
  [[nodiscard]] bool add(std::vector<ColumnEntry> columns) override {
    for (auto const& [row, column, value] : columns)
      diagonal_[row] += value; // nothing is off the diagonal
    return (diagonal_.array() != 0).all();
  }

private:
  Pattern pattern_;
  Vector diagonal_;
};

} // namespace

std::unique_ptr<BulkFactor> make_bulk_factor(Pattern pattern, Index surface, bool skew) {
  if (pattern.entries() == pattern.size())
    return std::make_unique<DiagonalFactor>(std::move(pattern), surface);
  return make_sparse_factor(pattern, surface, skew);
}

} // namespace stiction::linear
