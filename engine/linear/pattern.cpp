// Pattern building by sorting, ordering by CHOLMOD's AMD and METIS.
#include "linear/pattern.hpp"

#include <algorithm>
#include <memory>

#include "core/error.hpp"
#include "linear/cholmod_view.hpp"
#include "linear/node_order.hpp"

namespace stiction::linear {

Index Pattern::find(Index i, Index j) const {
  if (i < j)
    std::swap(i, j);
  auto const begin = rows.begin() + columns[ix(j)];
  auto const end = rows.begin() + columns[ix(j) + 1];
  auto const found = std::lower_bound(begin, end, i);
  return found == end || *found != i ? -1 : static_cast<Index>(found - rows.begin());
}

Pattern pattern_of(Index unknowns, std::vector<Indices> const& cliques) {
  std::vector<Indices> below(ix(unknowns));
  for (Index i = 0; i < unknowns; ++i)
    below[ix(i)].push_back(i);
  for (auto const& clique : cliques)
    for (Index const j : clique)
      for (Index const i : clique)
        if (j >= 0 && i > j)
          below[ix(j)].push_back(i);
  Pattern pattern;
  pattern.columns.push_back(0);
  for (auto& column : below) {
    std::sort(column.begin(), column.end());
    column.erase(std::unique(column.begin(), column.end()), column.end());
    pattern.rows.insert(pattern.rows.end(), column.begin(), column.end());
    pattern.columns.push_back(static_cast<Index>(pattern.rows.size()));
  }
  return pattern;
}

namespace {

/// The part of the pattern between unknowns that are not `last`, renumbered.
Pattern interior(Pattern const& pattern, std::vector<bool> const& last, Indices& old_number) {
  Indices number(last.size(), -1);
  for (std::size_t i = 0; i < last.size(); ++i)
    if (!last[i]) {
      number[i] = static_cast<Index>(old_number.size());
      old_number.push_back(static_cast<Index>(i));
    }
  Pattern part;
  part.columns.push_back(0);
  for (Index const j : old_number) {
    for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k)
      if (Index const i = number[static_cast<std::size_t>(pattern.rows[ix(k)])]; i >= 0)
        part.rows.push_back(i);
    part.columns.push_back(static_cast<Index>(part.rows.size()));
  }
  return part;
}

/// CHOLMOD's own limits, above which it looks for a better order than AMD's: operations per number of the
/// factor, and numbers of the factor per entry. It sees a factor of nodes, not of their `width` unknowns
/// each.
void choose_methods(cholmod_common& common, cholmod_sparse& view, double width) {
  constexpr double operations_per_number = 500, numbers_per_entry = 5;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_AMD;
  common.method[1].ordering = CHOLMOD_METIS;
  cholmod_factor* factor = cholmod_analyze(&view, &common);
  bool const dear =
      width * common.fl >= operations_per_number * common.lnz && common.lnz >= numbers_per_entry * common.anz;
  cholmod_free_factor(&factor, &common);
  common.nmethods = dear ? 2 : 1;
}

} // namespace

Indices elimination_order(Pattern const& pattern, std::vector<bool> const& last) {
  return elimination_order(pattern, last, 1);
}

Indices elimination_order(Pattern const& pattern, std::vector<bool> const& last, double width) {
  Indices order;
  Pattern part = interior(pattern, last, order);
  if (!order.empty()) {
    cholmod_common common;
    cholmod_start(&common);
    common.print = 0;
    cholmod_sparse view = view_of(part);
    common.supernodal = CHOLMOD_SUPERNODAL;
    if (width > 1)
      choose_methods(common, view, width);
    cholmod_factor* factor = cholmod_analyze(&view, &common);
    core::expect(factor != nullptr, "CHOLMOD to order the unknowns");
    Indices permuted;
    auto const* perm = static_cast<int const*>(factor->Perm);
    for (std::size_t k = 0; k < order.size(); ++k)
      permuted.push_back(order[ix(perm[k])]);
    order = std::move(permuted);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  for (std::size_t i = 0; i < last.size(); ++i)
    if (last[i])
      order.push_back(static_cast<Index>(i));
  return order;
}

void multiply(Pattern const& pattern, std::span<double const> values, Vector const& x, Vector& y) {
  y.setZero(x.size());
  for (Index j = 0; j < pattern.size(); ++j)
    for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k) {
      Index const i = pattern.rows[ix(k)];
      double const value = values[ix(k)];
      y[i] += value * x[j];
      if (i != j)
        y[j] += value * x[i];
    }
}

} // namespace stiction::linear
