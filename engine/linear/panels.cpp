// The plan of a factorization, and its passes: trees that stand alone, then what is above them.
#include "linear/panels.hpp"

#include <algorithm>
#include <cholmod.h>
#include <numeric>
#include <thread>

#include "core/error.hpp"
#include "core/threads.hpp"

extern "C" {
void dsyrk_(char const* uplo, char const* trans, int const* n, int const* k, double const* alpha,
            double const* a, int const* lda, double const* beta, double* c, int const* ldc);
void dgemm_(char const* transa, char const* transb, int const* m, int const* n, int const* k,
            double const* alpha, double const* a, int const* lda, double const* b, int const* ldb,
            double const* beta, double* c, int const* ldc);
void dtrsm_(char const* side, char const* uplo, char const* trans, char const* diag, int const* m,
            int const* n, double const* alpha, double const* a, int const* lda, double* b, int const* ldb);
void dpotrf_(char const* uplo, int const* n, double* a, int const* lda, int* info);
}

namespace stiction::linear {

namespace {

constexpr Index widest = 192;      // columns of a panel
constexpr double of_all = 1. / 64; // part of all work that a tree takes at most
constexpr double call = 2000;      // operations in the time that an update takes beside its own
constexpr Index long_enough = 1 << 16;
constexpr std::align_val_t line{64};

/// C = beta C + alpha A B^T, of which the square at the top is symmetric and its lower half alone wanted; B
/// is that part of A. [rows, columns], over `inner`
struct Product {
  int rows, columns, inner;
  double const* A;
  int stride;
  void to(double alpha, double beta, double* C, int stride_C) const {
    dsyrk_("L", "N", &columns, &inner, &alpha, A, &stride, &beta, C, &stride_C);
    if (int const below = rows - columns; below > 0)
      dgemm_("N", "T", &below, &columns, &inner, &alpha, A + columns, &stride, A, &stride, &beta, C + columns,
             &stride_C);
  }
};

} // namespace

/// Of a thread, kept from panel to panel.
struct Panels::Scratch {
  struct Free {
    void operator()(double* all) const { ::operator delete[](all, line); }
  };
  std::unique_ptr<double, Free> product;
  std::size_t room = 0;
  Indices place; ///< of an unknown among the rows of the present panel

  void make_room(Index numbers, Index unknowns) {
    if (room < ix(numbers)) {
      room = ix(numbers);
      product.reset(static_cast<double*>(::operator new[](room * sizeof(double), line)));
    }
    if (place.size() < ix(unknowns))
      place.resize(ix(unknowns));
  }
};

Panels::Panels(cholmod_factor_struct const& symbolic, Pattern const& pattern)
    : unknowns_(static_cast<Index>(symbolic.n)), numbers_(symbolic.xsize), panel_of_(symbolic.n) {
  cut(symbolic);
  find_updates();
  share_work();
  place_entries(symbolic, pattern);
  done_ = std::make_unique<std::atomic<bool>[]>(panels_.size());
}

void Panels::cut(cholmod_factor_struct const& symbolic) {
  auto const *super = static_cast<int const*>(symbolic.super), *pi = static_cast<int const*>(symbolic.pi),
             *px = static_cast<int const*>(symbolic.px), *s = static_cast<int const*>(symbolic.s);
  for (std::size_t q = 0; q < symbolic.nsuper; ++q) {
    Index const columns = super[q + 1] - super[q], stride = pi[q + 1] - pi[q],
                parts = (columns + widest - 1) / widest;
    for (Index part = 0; part < parts; ++part) {
      Index const first = static_cast<Index>(std::int64_t{columns} * part / parts),
                  last = static_cast<Index>(std::int64_t{columns} * (part + 1) / parts);
      std::fill_n(panel_of_.begin() + super[q] + first, last - first, static_cast<Index>(panels_.size()));
      panels_.push_back({super[q] + first, last - first, stride - first, s + pi[q] + first,
                         px[q] + std::ptrdiff_t{first} * (stride + 1), stride});
    }
  }
}

/// Calls visit(target, update) for all, in the order of their sources.
template<class Visit> void Panels::each_update(Visit const& visit) const {
  for (Index p = 0; p < static_cast<Index>(panels_.size()); ++p) {
    auto const& panel = panels_[ix(p)];
    for (Index first = panel.columns, last = first; first < panel.rows; first = last) {
      Index const target = panel_of_[ix(panel.row[first])];
      while (last < panel.rows && panel_of_[ix(panel.row[last])] == target)
        ++last;
      visit(target, Update{p, first, last});
    }
  }
}

void Panels::find_updates() {
  first_update_.assign(panels_.size() + 1, 0);
  each_update([&](Index target, Update const& update) {
    ++first_update_[ix(target) + 1];
    largest_ =
        std::max(largest_, (panels_[ix(update.source)].rows - update.first) * (update.last - update.first));
  });
  std::partial_sum(first_update_.begin(), first_update_.end(), first_update_.begin());
  updates_.resize(first_update_.back());
  auto next = first_update_;
  each_update([&](Index target, Update const& update) { updates_[next[ix(target)]++] = update; });
}

Index Panels::parent(Index panel) const {
  auto const& one = panels_[ix(panel)];
  return one.rows > one.columns ? panel_of_[ix(one.row[one.columns])] : -1;
}

/// What it takes to make this panel.
double Panels::operations(Index panel) const {
  auto const& own = panels_[ix(panel)];
  double sum = static_cast<double>(own.columns) * own.columns * own.rows;
  for (auto const& update : updates_of(panel)) {
    auto const& source = panels_[ix(update.source)];
    sum += call + 2.0 * source.columns * (source.rows - update.first) * (update.last - update.first);
  }
  return sum;
}

void Panels::share_work() {
  auto const count = static_cast<Index>(panels_.size());
  std::vector<double> work(panels_.size());
  double all = 0;
  for (Index p = 0; p < count; ++p) {
    double const own = operations(p);
    all += own;
    work[ix(p)] += own;
    if (Index const above = parent(p); above >= 0)
      work[ix(above)] += work[ix(p)];
  }
  Indices tree(panels_.size(), -1), roots;
  for (Index p = count - 1; p >= 0; --p) {
    if (work[ix(p)] > of_all * all)
      continue;
    Index const above = parent(p);
    tree[ix(p)] = above >= 0 ? tree[ix(above)] : -1;
    if (tree[ix(p)] >= 0)
      continue;
    tree[ix(p)] = static_cast<Index>(roots.size());
    roots.push_back(p);
  }
  trees_.resize(roots.size());
  for (Index p = 0; p < count; ++p)
    (tree[ix(p)] >= 0 ? trees_[ix(tree[ix(p)])] : above_).push_back(p);
  std::ranges::stable_sort(trees_, std::greater<>(),
                           [&](Indices const& one) { return work[ix(one.back())]; });
}

void Panels::place_entries(cholmod_factor_struct const& symbolic, Pattern const& pattern) {
  Indices number(symbolic.n);
  auto const* old = static_cast<int const*>(symbolic.Perm);
  for (Index k = 0; k < unknowns_; ++k)
    number[ix(old[k])] = k;
  place_.resize(pattern.rows.size());
  core::each_piece(unknowns_, 1000, [&](Index first, Index last) {
    for (Index j = first; j < last; ++j)
      for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k) {
        auto const [column, row] = std::minmax(number[ix(j)], number[ix(pattern.rows[ix(k)])]);
        auto const& panel = panels_[ix(panel_of_[ix(column)])];
        auto const below = std::lower_bound(panel.row, panel.row + panel.rows, row) - panel.row;
        place_[ix(k)] =
            static_cast<Index>(panel.at + std::ptrdiff_t{column - panel.begin} * panel.stride + below);
      }
  });
}

void Panels::fill(std::span<double const> values, double* x) const {
  core::each_piece(static_cast<Index>(numbers_), long_enough,
                   [&](Index first, Index last) { std::fill(x + first, x + last, 0.0); });
  core::each_piece(static_cast<Index>(values.size()), long_enough, [&](Index first, Index last) {
    for (Index k = first; k < last; ++k)
      x[place_[ix(k)]] = values[ix(k)];
  });
}

void Panels::apply(Update const& update, Panel const& to, Scratch& scratch, double* x) const {
  auto const& from = panels_[ix(update.source)];
  Product const product{from.rows - update.first, update.last - update.first, from.columns,
                        x + from.at + update.first, from.stride};
  if (product.rows == to.rows && product.columns == to.columns) // row by row
    return product.to(-1, 1, x + to.at, to.stride);
  double* const C = scratch.product.get();
  product.to(1, 0, C, product.rows);
  Index const* const row = from.row + update.first;
  for (Index j = 0; j < product.columns; ++j) {
    double* const column = x + to.at + std::ptrdiff_t{row[j] - to.begin} * to.stride;
    double const* const change = C + std::ptrdiff_t{j} * product.rows;
    for (Index i = j; i < product.rows; ++i)
      column[scratch.place[ix(row[i])]] -= change[i];
  }
}

/// Gathers what others do to a panel, as soon as they are done, and eliminates its unknowns.
bool Panels::finish(Index p, double* x) {
  static thread_local Scratch scratch;
  scratch.make_room(largest_, unknowns_);
  auto const& panel = panels_[ix(p)];
  for (Index i = 0; i < panel.rows; ++i)
    scratch.place[ix(panel.row[i])] = i;
  for (auto const& update : updates_of(p)) {
    while (!done_[ix(update.source)].load(std::memory_order_acquire)) {
      if (failed_)
        return false;
      std::this_thread::yield();
    }
    apply(update, panel, scratch, x);
  }
  int info = 0;
  double const one = 1;
  dpotrf_("L", &panel.columns, x + panel.at, &panel.stride, &info);
  if (info != 0)
    return false;
  if (int const below = panel.rows - panel.columns; below > 0)
    dtrsm_("R", "L", "T", "N", &below, &panel.columns, &one, x + panel.at, &panel.stride,
           x + panel.at + panel.columns, &panel.stride);
  done_[ix(p)].store(true, std::memory_order_release);
  return true;
}

bool Panels::factorize(std::span<double const> values, double* x) {
  fill(values, x);
  failed_ = false;
  for (std::size_t p = 0; p < panels_.size(); ++p)
    done_[p].store(false, std::memory_order_relaxed);
  auto const make = [&](Index p) {
    if (!failed_ && !finish(p, x))
      failed_ = true;
  };
  core::each(static_cast<Index>(trees_.size()),
             [&](Index tree) { std::ranges::for_each(trees_[ix(tree)], make); });
  core::each(static_cast<Index>(above_.size()), [&](Index k) { make(above_[ix(k)]); });
  return !failed_;
}

} // namespace stiction::linear
