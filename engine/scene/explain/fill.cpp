// Symbolic analysis on nodes or clusters of them.
#include "scene/explain/fill.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <set>

#include "dynamics/bulk/bulk_choice.hpp"
#include "linear/cholesky.hpp"
#include "linear/multigrid_factor.hpp"
#include "linear/node_order.hpp"
#include "linear/sparse_factor.hpp"

namespace stiction::scene {

namespace {

/// Vertices, free nodes or clusters of them, and the cells that couple them.
struct Graph {
  std::vector<bool> surface;    ///< [vertices]
  std::vector<Indices> cliques; ///< of vertices, [cells]
  [[nodiscard]] Index size() const { return static_cast<Index>(surface.size()); }
};

/// Numbers of the nodes that have a free component, -1 for others, and how many components those have.
struct FreeNodes {
  Indices number;
  double unknowns = 0, surface_unknowns = 0;
};

FreeNodes free_nodes(dynamics::Model const& model, dynamics::BulkSystem const& bulk) {
  int const dim = model.dim();
  std::vector<bool> driven(ix(model.dofs()), false);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driven[ix(dim * node + motion.component)] = true;
  FreeNodes free;
  Index next = 0;
  for (Index node = 0; node < model.node_count(); ++node) {
    auto const first = driven.begin() + dim * node;
    auto const count = static_cast<double>(std::count(first, first + dim, false));
    free.number.push_back(count > 0 ? next++ : -1);
    free.unknowns += count;
    free.surface_unknowns += bulk.on_surface(node) ? count : 0;
  }
  return free;
}

Graph node_graph(dynamics::Model const& model, dynamics::BulkSystem const& bulk, Indices const& number) {
  Graph graph;
  for (Index node = 0; node < model.node_count(); ++node)
    if (number[ix(node)] >= 0)
      graph.surface.push_back(bulk.on_surface(node));
  for (std::size_t b = 0; b < model.cells.size(); ++b)
    model.cells[b].each_cell([&](std::span<Index const> nodes) {
      auto& clique = graph.cliques.emplace_back();
      for (Index const node : nodes)
        if (Index const k = number[ix(model.first_node[b] + node)]; k >= 0)
          clique.push_back(k);
    });
  for (auto const& gas : model.gases) {
    auto& clique = graph.cliques.emplace_back();
    for (Index const node : gas.nodes)
      if (Index const k = number[ix(node)]; k >= 0)
        clique.push_back(k);
  }
  for (auto const& spring : model.springs) {
    auto& clique = graph.cliques.emplace_back();
    for (auto const* end : {&spring.from, &spring.to})
      for (Index const node : end->nodes)
        if (Index const k = number[ix(node)]; k >= 0 && !spring.spread)
          clique.push_back(k);
  }
  return graph;
}

/// Cells of each vertex.
struct Stars {
  Indices first, cells;
  explicit Stars(Graph const& graph) : first(ix(graph.size() + 1), 0) {
    for (auto const& clique : graph.cliques)
      for (Index const v : clique)
        ++first[ix(v + 1)];
    for (std::size_t v = 1; v < first.size(); ++v)
      first[v] += first[v - 1];
    Indices next = first;
    cells.resize(ix(first.back()));
    for (std::size_t c = 0; c < graph.cliques.size(); ++c)
      for (Index const v : graph.cliques[c])
        cells[ix(next[ix(v)]++)] = static_cast<Index>(c);
  }
};

/// Of some vertices, evenly chosen.
double mean_neighbours(Graph const& graph) {
  Stars const stars(graph);
  Index const stride = 1 + graph.size() / 1000;
  std::size_t found = 0, looked = 0;
  for (Index v = 0; v < graph.size(); v += stride, ++looked) {
    std::set<Index> around;
    for (Index k = stars.first[ix(v)]; k < stars.first[ix(v + 1)]; ++k)
      around.insert(graph.cliques[ix(stars.cells[ix(k)])].begin(),
                    graph.cliques[ix(stars.cells[ix(k)])].end());
    found += around.empty() ? 0 : around.size() - 1;
  }
  return static_cast<double>(found) / static_cast<double>(looked);
}

/// Clusters of a vertex with its neighbours, those of the surface apart from the others.
Graph clustered(Graph const& graph) {
  Stars const stars(graph);
  Indices cluster(ix(graph.size()), -1);
  auto const each_neighbour = [&](Index v, auto&& act) {
    for (Index k = stars.first[ix(v)]; k < stars.first[ix(v + 1)]; ++k)
      for (Index const w : graph.cliques[ix(stars.cells[ix(k)])])
        if (graph.surface[ix(w)] == graph.surface[ix(v)])
          act(w);
  };
  Graph coarse;
  for (bool const alone : {false, true}) // where all neighbours are free; then the rest
    for (Index v = 0; v < graph.size(); ++v) {
      Index beside = -1;
      if (cluster[ix(v)] >= 0)
        continue;
      each_neighbour(v, [&](Index w) { beside = std::max(beside, cluster[ix(w)]); });
      if (beside >= 0) {
        cluster[ix(v)] = alone ? beside : -1;
        continue;
      }
      each_neighbour(v, [&](Index w) { cluster[ix(w)] = coarse.size(); });
      cluster[ix(v)] = coarse.size();
      coarse.surface.push_back(graph.surface[ix(v)]);
    }
  for (auto const& clique : graph.cliques) {
    Indices own;
    for (Index const v : clique)
      own.push_back(cluster[ix(v)]);
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    if (own.size() > 1)
      coarse.cliques.push_back(std::move(own));
  }
  std::sort(coarse.cliques.begin(), coarse.cliques.end());
  coarse.cliques.erase(std::unique(coarse.cliques.begin(), coarse.cliques.end()), coarse.cliques.end());
  return coarse;
}

/// The pattern in an order of elimination with those marked last at the end, of vertices that stand for so
/// many unknowns each.
linear::Pattern ordered(Graph const& graph, std::vector<bool> const& last, double width) {
  auto const order = linear::elimination_order(linear::pattern_of(graph.size(), graph.cliques), last, width);
  Indices place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    place[ix(order[k])] = static_cast<Index>(k);
  auto cliques = graph.cliques;
  for (auto& clique : cliques)
    for (auto& v : clique)
      v = place[ix(v)];
  return linear::pattern_of(graph.size(), cliques);
}

/// Of vertices that stand for `ratio` nodes of `width` unknowns each.
struct Scale {
  double ratio, width, size;
  bool space;
  [[nodiscard]] linear::Effort operator()(linear::Effort const& one) const {
    double const entries = space ? std::pow(ratio, 4.0 / 3) : ratio * std::log(size * ratio) / std::log(size);
    return {entries * width * width * one.entries,
            std::pow(ratio, space ? 2.0 : 1.5) * std::pow(width, 3) * one.operations};
  }
  /// What makes operations per number those of the unknowns.
  [[nodiscard]] double front() const { return width * std::pow(ratio, space ? 2.0 / 3 : 0.5); }
};

} // namespace

Fill fill_of(dynamics::Model const& model, dynamics::BulkSystem const& bulk, Index most) {
  auto const free = free_nodes(model, bulk);
  Fill fill;
  fill.unknowns = free.unknowns;
  fill.surface = free.surface_unknowns;
  auto graph = node_graph(model, bulk, free.number);
  if (graph.size() == 0 || dynamics::weights(model.scheme).explicit_forces) {
    fill.entries = fill.factor.entries = fill.factor.operations = fill.unknowns;
    return fill;
  }
  auto const nodes = static_cast<double>(graph.size());
  double const width = fill.unknowns / nodes;
  fill.entries = width * (0.5 * (width + 1) + width * 0.5 * mean_neighbours(graph)) * nodes;
  if (dynamics::by_multigrid(model)) {
    fill.multigrid = true;
    fill.factor = linear::multigrid_effort(2 * fill.entries);
    return fill;
  }
  for (Index before = 0; graph.size() > most && graph.size() != before;) {
    before = graph.size();
    graph = clustered(graph);
  }
  Scale const scale{nodes / graph.size(), width, std::max(3.0, static_cast<double>(graph.size())),
                    model.dim() == 3};
  auto const surface = static_cast<Index>(std::count(graph.surface.begin(), graph.surface.end(), true));
  auto const begin = std::clock();
  auto const pattern = ordered(graph, graph.surface, scale.front());
  fill.factor = scale(linear::Cholesky(pattern, surface).effort());
  if (linear::worth_another_order(fill.factor, fill.surface)) {
    std::vector<bool> const nowhere(graph.surface.size(), false);
    auto const wherever = scale(linear::Cholesky(ordered(graph, nowhere, scale.front()), surface).effort());
    fill.surface_last = linear::surface_goes_last(fill.factor, wherever, fill.surface);
    if (!fill.surface_last)
      fill.factor = wherever;
  }
  fill.seconds = scale.ratio * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return fill;
}

} // namespace stiction::scene
