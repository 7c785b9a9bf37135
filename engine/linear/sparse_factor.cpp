// Half-solves with the surface last, whole ones where it is not.
#include "linear/sparse_factor.hpp"

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "linear/cholesky.hpp"
#include "linear/skew_columns.hpp"
#include "linear/surface_columns.hpp"

extern "C" {
void dtrtri_(char const* uplo, char const* diag, int const* n, double* a, int const* lda, int* info);
void dlauum_(char const* uplo, int const* n, double* a, int const* lda, int* info);
void dtrmm_(char const* side, char const* uplo, char const* trans, char const* diag, int const* m,
            int const* n, double const* alpha, double const* a, int const* lda, double* b, int const* ldb);
}

namespace stiction::linear {

namespace {

/// Columns of a group: whole nodes in the plane and in space; fewer where a column costs more.
Index width(Order order, Index surface) {
  if (order == Order::free)
    return 12;
  return surface <= at_once ? std::max(surface, 1) : 24;
}

/// L becomes its inverse, half by half: OpenBLAS's dtrtri takes longer, as it goes column by column. [n, n]
/// of a lower triangle, column by column
void invert_triangle(double* L, int n, int stride) {
  constexpr int by_columns = 24;
  if (n <= by_columns) {
    int info = 0;
    dtrtri_("L", "N", &n, L, &stride, &info);
    core::expect(info == 0, "the trailing factor to be regular");
    return;
  }
  int const half = n / 2, rest = n - half;
  double *const under = L + half, *const last = under + std::ptrdiff_t{half} * stride;
  double const one = 1, minus = -1;
  invert_triangle(L, half, stride);
  invert_triangle(last, rest, stride);
  dtrmm_("R", "L", "N", "N", &rest, &half, &one, L, &stride, under, &stride);
  dtrmm_("L", "L", "N", "N", &rest, &half, &minus, last, &stride, under, &stride);
}

/// The factor and what is common to both orders.
class SparseFactor : public BulkFactor {
public:
  SparseFactor(Index surface, std::unique_ptr<Cholesky> factor)
      : BulkFactor(surface), factor_(std::move(factor)), columns_(surface, width(factor_->order(), surface)) {
  }
  [[nodiscard]] Pattern const& pattern() const override { return factor_->pattern(); }
  [[nodiscard]] Effort effort() const override { return factor_->effort(); }
  [[nodiscard]] double surface_numbers() const override { return columns_.numbers(); }
  [[nodiscard]] std::shared_ptr<Carried const> carried() const override {
    return std::make_shared<Carried const>(Carried{known(), {}, {}});
  }
  void compliance(Indices const& used, Dense& C) override {
    prepare_columns();
    auto const spent = columns_.gather(
        used, [this](Index first, Dense& X) { return solve_columns(first, X); }, C);
    spend(spent.columns, spent.operations);
  }

protected:
  [[nodiscard]] bool take(std::span<double const> values) override {
    columns_.clear();
    return factor_->factorize(values);
  }
  /// Before several threads solve for columns.
  virtual void prepare_columns() {}
  /// As of SurfaceColumns.
  [[nodiscard]] virtual double solve_columns(Index first, Dense& X) = 0;
  [[nodiscard]] virtual Indices known() const { return columns_.known(); }
  [[nodiscard]] Cholesky& factor() { return *factor_; }
  [[nodiscard]] std::unique_ptr<Cholesky> fresh() const {
    return std::make_unique<Cholesky>(pattern(), surface(), factor_->order());
  }

private:
  std::unique_ptr<Cholesky> factor_;
  SurfaceColumns columns_;
};

/// The surface last: the trailing block of the factor is that of the Schur complement onto it.
class SurfaceLast : public SparseFactor {
public:
  using SparseFactor::SparseFactor;
  [[nodiscard]] std::unique_ptr<BulkFactor> another() const override {
    return std::make_unique<SurfaceLast>(surface(), fresh());
  }
  [[nodiscard]] bool symmetric() const override { return !skew_; }

  [[nodiscard]] Vector condense(Vector& b) override {
    factor().forward(b);
    return motion(b);
  }
  void expand(Vector const& surface_load, Vector& z) override {
    load(surface_load, z);
    factor().backward(z);
  }
  [[nodiscard]] std::vector<Vector> condense_all(std::span<Vector* const> b) override {
    factor().forward(b);
    std::vector<Vector> motions;
    for (auto* const one : b)
      motions.push_back(motion(*one));
    return motions;
  }
  void expand_all(std::span<Vector const* const> surface_loads, std::span<Vector* const> z) override {
    for (std::size_t k = 0; k < z.size(); ++k)
      load(*surface_loads[k], *z[k]);
    factor().backward(z);
  }

  void compliance(Indices const& used, Dense& C) override {
    if (!skew_)
      return SparseFactor::compliance(used, C);
    auto const n = static_cast<double>(surface());
    long const columns = skew_->compliance(used, C);
    spend(columns, 2 * n * n * static_cast<double>(columns));
  }

  [[nodiscard]] double surface_numbers() const override {
    auto const n = static_cast<double>(surface());
    return (skew_ ? 2 * n * n + skew_->numbers() : n * n) + SparseFactor::surface_numbers();
  }

protected:
  [[nodiscard]] bool take(std::span<double const> values) override {
    skew_.reset();
    return SparseFactor::take(values);
  }
  [[nodiscard]] bool add(std::vector<ColumnEntry> columns) override {
    if (columns.empty())
      return true;
    auto const n = static_cast<double>(surface());
    spend(surface(), (2 * effort().entries + 5.0 / 3 * n * n) * n); // B, product, LU
    return skew_.emplace().add(factor(), std::move(columns), surface());
  }
  [[nodiscard]] Indices known() const override { return skew_ ? skew_->known() : SparseFactor::known(); }
  void prepare_columns() override { static_cast<void>(factor().trailing_factor()); }
  /// Rows above `first` want neither half of the solution.
  [[nodiscard]] double solve_columns(Index first, Dense& X) override {
    auto const rows = surface() - first;
    auto const n = static_cast<double>(rows);
    if (X.cols() == surface()) {
      invert(X);
      return n * n * n;
    }
    auto const L = factor().trailing_factor().bottomRightCorner(rows, rows);
    X.setIdentity();
    L.triangularView<Eigen::Lower>().solveInPlace(X);
    L.transpose().triangularView<Eigen::Upper>().solveInPlace(X);
    return 2 * n * n * static_cast<double>(X.cols());
  }

private:
  /// Of the surface, from the forward half of a solution.
  [[nodiscard]] Vector motion(Vector& z) {
    if (skew_)
      return skew_->condense(factor(), z);
    Vector y = z.tail(surface());
    factor().trailing_factor().transpose().triangularView<Eigen::Upper>().solveInPlace(y);
    return y;
  }
  /// Adds a load on the surface to that.
  void load(Vector const& surface_load, Vector& z) {
    if (skew_) {
      skew_->expand(factor(), surface_load, z);
    } else if (!surface_load.isZero(0)) {
      Vector const own = factor().trailing_factor().triangularView<Eigen::Lower>().solve(surface_load);
      z.tail(surface()) += own;
    }
  }
  /// The lower triangle alone.
  void invert(Dense& X) {
    X = factor().trailing_factor(); // L_cc L_cc^T = Schur complement
    int const n = surface();
    int info = 0;
    invert_triangle(X.data(), n, n);
    dlauum_("L", &n, X.data(), &n, &info);
  }

  std::optional<SkewColumns> skew_;
};

/// The surface wherever it fills least: nothing dense between its unknowns, but columns through all of L.
class SurfaceAnywhere : public SparseFactor {
public:
  using SparseFactor::SparseFactor;
  [[nodiscard]] std::unique_ptr<BulkFactor> another() const override {
    return std::make_unique<SurfaceAnywhere>(surface(), fresh());
  }
  [[nodiscard]] Vector condense(Vector& b) override {
    factor().solve(b);
    return b.tail(surface());
  }
  void expand(Vector const& surface_load, Vector& b) override {
    if (surface_load.isZero(0))
      return;
    Vector more = Vector::Zero(b.size());
    more.tail(surface()) = surface_load;
    factor().solve(more);
    b += more;
  }
  [[nodiscard]] std::vector<Vector> condense_all(std::span<Vector* const> b) override {
    factor().solve(b);
    std::vector<Vector> motions;
    for (auto* const one : b)
      motions.emplace_back(one->tail(surface()));
    return motions;
  }
  void expand_all(std::span<Vector const* const> surface_loads, std::span<Vector* const> b) override {
    if (std::ranges::all_of(surface_loads, [](auto const* load) { return load->isZero(0); }))
      return;
    std::vector<Vector> more(b.size());
    std::vector<Vector*> all;
    for (std::size_t k = 0; k < b.size(); ++k) {
      more[k] = Vector::Zero(b[k]->size());
      more[k].tail(surface()) = *surface_loads[k];
      all.push_back(&more[k]);
    }
    factor().solve(all);
    for (std::size_t k = 0; k < b.size(); ++k)
      *b[k] += more[k];
  }

protected:
  [[nodiscard]] bool add(std::vector<ColumnEntry> columns) override {
    core::expect(columns.empty(), "columns beside the matrix only where the surface is last");
    return true;
  }
  [[nodiscard]] double solve_columns(Index first, Dense& X) override {
    Dense loads = Dense::Zero(pattern().size(), X.cols());
    loads.middleRows(first_of_surface() + first, X.cols()).setIdentity();
    factor().solve(loads);
    X = loads.bottomRows(X.rows());
    return 4 * effort().entries * static_cast<double>(X.cols());
  }
};

constexpr double small = 1000; // surface unknowns below which nothing but the surface last is looked at
constexpr double near = 0.25;  // part of the surface that is expected to be near contact

/// Operations of a factorization with the columns that it is expected to be asked for.
double expected(Effort const& effort, double surface, double column) {
  return effort.operations + near * surface * column;
}

/// What of that the surface takes where it comes last.
double dense_part(double surface) {
  return (1.0 / 3 + near) * surface * surface * surface;
}

} // namespace

bool worth_another_order(Effort const& last, double surface) {
  return surface >= small && 2 * dense_part(surface) >= expected(last, surface, surface * surface);
}

bool surface_goes_last(Effort const& last, Effort const& free, double surface) {
  return expected(last, surface, surface * surface) <= expected(free, surface, 4 * free.entries);
}

std::unique_ptr<BulkFactor> make_sparse_factor(Pattern const& pattern, Index surface, bool skew) {
  std::unique_ptr<Cholesky> last, free;
  try {
    last = std::make_unique<Cholesky>(pattern, surface);
  } catch (core::OutOfMemory const&) { // more numbers than CHOLMOD can count
    if (skew)
      throw;
  }
  if (last && (skew || !worth_another_order(last->effort(), surface)))
    return std::make_unique<SurfaceLast>(surface, std::move(last));
  free = std::make_unique<Cholesky>(pattern, surface, Order::free);
  if (last && surface_goes_last(last->effort(), free->effort(), surface))
    return std::make_unique<SurfaceLast>(surface, std::move(last));
  return std::make_unique<SurfaceAnywhere>(surface, std::move(free));
}

} // namespace stiction::linear
