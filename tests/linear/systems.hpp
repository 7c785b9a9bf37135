// Patterns and values of springs for the tests of factors.
#pragma once
#include <random>

#include "linear/pattern.hpp"

namespace stiction::test {

using linear::Pattern;

/// A grid of springs, each node tied to its neighbours.
inline Pattern grid(Index side) {
  std::vector<Indices> cliques;
  for (Index i = 0; i + 1 < side; ++i)
    for (Index j = 0; j + 1 < side; ++j)
      cliques.push_back({i * side + j, (i + 1) * side + j, (i + 1) * side + j + 1, i * side + j + 1});
  return linear::pattern_of(side * side, cliques);
}

/// The pattern with its unknowns renumbered by `order`.
inline Pattern reordered(Pattern const& pattern, Indices const& order) {
  Indices number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    number[ix(order[k])] = static_cast<Index>(k);
  std::vector<Indices> pairs;
  for (Index j = 0; j < pattern.size(); ++j)
    for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k)
      pairs.push_back({number[ix(j)], number[ix(pattern.rows[ix(k)])]});
  return linear::pattern_of(pattern.size(), pairs);
}

/// Square grids one upon another, the lowest last; its first `last` unknowns keep their order at the end.
inline Pattern layers(Index side, Index count, Index last) {
  std::vector<Indices> cliques;
  Index const area = side * side, n = count * area;
  for (Index k = 0; k + 1 < count; ++k)
    for (Index i = 0; i + 1 < side; ++i)
      for (Index j = 0; j + 1 < side; ++j) {
        Index const a = k * area + i * side + j;
        cliques.push_back(
            {a, a + 1, a + side, a + side + 1, a + area, a + area + 1, a + area + side, a + area + side + 1});
      }
  auto const natural = linear::pattern_of(n, cliques);
  std::vector<bool> marked(ix(n), false);
  for (Index i = n - last; i < n; ++i)
    marked[ix(i)] = true;
  return reordered(natural, linear::elimination_order(natural, marked));
}

/// Random symmetric values, diagonally dominant.
inline std::vector<double> values_of(Pattern const& pattern, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> values(pattern.rows.size());
  for (auto& value : values)
    value = uniform(random);
  for (Index j = 0; j < pattern.size(); ++j)
    values[ix(pattern.columns[ix(j)])] = 30 + uniform(random);
  return values;
}

inline Dense dense(Pattern const& pattern, std::vector<double> const& values) {
  Dense A = Dense::Zero(pattern.size(), pattern.size());
  for (Index j = 0; j < pattern.size(); ++j)
    for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k)
      A(pattern.rows[ix(k)], j) = A(j, pattern.rows[ix(k)]) = values[ix(k)];
  return A;
}

} // namespace stiction::test
