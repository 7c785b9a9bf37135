// Layers of a graph, by distance from an end of it: what lies in one touches only the ones beside it.
#pragma once
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/threads.hpp"

namespace stiction::linear {

/// Walks over the graph of n nodes; near(i, visit) calls visit(j) for every neighbour j of node i.
template<class Near> class LayersOfGraph {
public:
  LayersOfGraph(Index n, Near const& near) : near_(&near), layer_(ix(n), -1) {}

  /// Of each node; parts that are not connected come one after the other.
  Indices find() {
    Index next = 0;
    for (Index i = 0; i < static_cast<Index>(layer_.size()); ++i)
      if (layer_[ix(i)] < 0) {
        Index const end = walk(i, next); // to the end that is farthest from anywhere
        for (Index const j : reached_)
          layer_[ix(j)] = -1;
        walk(end, next);
        next = layer_[ix(reached_.back())] + 1;
      }
    return std::move(layer_);
  }

private:
  /// The node reached last from `start`, which is in layer `first`.
  Index walk(Index start, Index first) {
    reached_.assign(1, start);
    layer_[ix(start)] = first;
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      Index const beyond = layer_[ix(reached_[k])] + 1;
      (*near_)(reached_[k], [&](Index j) {
        if (layer_[ix(j)] >= 0)
          return;
        layer_[ix(j)] = beyond;
        reached_.push_back(j);
      });
    }
    return reached_.back();
  }

  Near const* near_;
  Indices layer_, reached_;
};

/// What slabs are made of at least.
struct LeastSlab {
  Index members, layers;
};

/// Instead of layers, slabs of whole layers, [members]; the last one may be short.
[[nodiscard]] inline Indices slabs(Indices const& layer_of, LeastSlab least) {
  Indices slab_of(ix(*std::max_element(layer_of.begin(), layer_of.end()) + 1), 0);
  for (Index const layer : layer_of)
    ++slab_of[ix(layer)];
  Index slab = 0, inside = 0, deep = 0;
  for (Index& count : slab_of) {
    inside += count;
    ++deep;
    count = slab;
    if (inside < least.members || deep < least.layers)
      continue;
    ++slab;
    inside = deep = 0;
  }
  Indices of;
  of.reserve(layer_of.size());
  for (Index const layer : layer_of)
    of.push_back(slab_of[ix(layer)]);
  return of;
}

/// Rows of a matrix in two waves, in each of which slabs of rows are not coupled with each other: what goes
/// from row to row can be done in all slabs of a wave at the same time, as if it were done one by one.
struct Waves {
  Indices starts{0}; ///< of the slabs, and the end
  Index first = 0;   ///< slabs of the first wave
  Indices number{};  ///< [rows], of each by what it was before the waves; empty: the same

  /// Rows in the order in which they are numbered.
  static Waves one_by_one(Index rows) { return {{0, rows}, 1, {}}; }
  /// act(first, last) for all slabs.
  template<class Act> void forwards(Act const& act) const {
    wave(0, first, act);
    wave(first, static_cast<Index>(starts.size()) - 1, act);
  }
  template<class Act> void backwards(Act const& act) const {
    wave(first, static_cast<Index>(starts.size()) - 1, act);
    wave(0, first, act);
  }

private:
  template<class Act> void wave(Index from, Index to, Act const& act) const {
    core::each(to - from, [&](Index k) { act(starts[ix(from + k)], starts[ix(from + k + 1)]); });
  }
};

/// Numbers for rows that make waves of them.
struct WaveOrder {
  Indices order; ///< [rows], old numbers by new ones
  Waves waves;
};

/// Every other slab first.
[[nodiscard]] inline WaveOrder order_in_waves(Indices const& slab_of) {
  auto const rows = static_cast<Index>(slab_of.size());
  WaveOrder made{Indices(slab_of.size()), {}};
  made.waves.number.resize(slab_of.size());
  std::iota(made.order.begin(), made.order.end(), 0);
  std::ranges::stable_sort(made.order, {},
                           [&](Index i) { return std::pair(slab_of[ix(i)] % 2, slab_of[ix(i)]); });
  for (Index k = 1; k < rows; ++k) {
    Index const here = slab_of[ix(made.order[ix(k)])];
    if (here == slab_of[ix(made.order[ix(k - 1)])])
      continue;
    made.waves.starts.push_back(k);
    made.waves.first = here == 1 ? static_cast<Index>(made.waves.starts.size()) - 1 : made.waves.first;
  }
  made.waves.starts.push_back(rows);
  for (Index k = 0; k < rows; ++k)
    made.waves.number[ix(made.order[ix(k)])] = k;
  made.waves.first = std::max(made.waves.first, 1);
  return made;
}

/// Of the rows of a symmetric block matrix.
template<class BlockMatrix> [[nodiscard]] WaveOrder waves_of(BlockMatrix const& A, LeastSlab least) {
  auto const near = [&](Index i, auto const& visit) {
    std::for_each(A.column.begin() + A.starts[ix(i)], A.column.begin() + A.starts[ix(i) + 1], visit);
  };
  if (A.rows() == 0)
    return {{}, Waves::one_by_one(0)};
  return order_in_waves(slabs(LayersOfGraph(A.rows(), near).find(), least));
}

} // namespace stiction::linear
