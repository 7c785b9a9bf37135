// Recursive bisection by coordinates, and gathering.
#include "dynamics/model/share.hpp"

#include <algorithm>
#include <numeric>

namespace stiction::dynamics {

solid::CellPart Share::part(std::span<Index const> nodes, Index first_node) const {
  if (own(first_node + nodes.front()))
    return solid::CellPart::all;
  bool const any = std::ranges::any_of(nodes, [&](Index node) { return own(first_node + node); });
  return any ? solid::CellPart::forces : solid::CellPart::none;
}

void Share::gather(Vector& values, int dim) const {
  auto const begin = first[ix(ranks->rank())], end = first[ix(ranks->rank() + 1)];
  Vector part(dim * (end - begin)), all;
  for (Index k = begin; k < end; ++k)
    part.segment(dim * (k - begin), dim) = values.segment(dim * order[ix(k)], dim);
  Indices places;
  for (Index const place : first)
    places.push_back(dim * place);
  ranks->gather(part, places, all);
  for (std::size_t k = 0; k < order.size(); ++k)
    values.segment(dim * order[k], dim) = all.segment(dim * static_cast<Index>(k), dim);
}

namespace {

/// Gives the nodes to the ranks from first_rank to before last_rank.
void bisect(Matrix const& nodes, std::span<Index> some, int first_rank, int last_rank, Indices& owner) {
  if (last_rank - first_rank == 1) {
    for (Index const node : some)
      owner[ix(node)] = first_rank;
    return;
  }
  Eigen::RowVectorXd least = nodes.row(some.front()), most = least;
  for (Index const node : some) {
    least = least.cwiseMin(nodes.row(node));
    most = most.cwiseMax(nodes.row(node));
  }
  Eigen::Index axis = 0;
  (most - least).maxCoeff(&axis);
  int const middle = (first_rank + last_rank) / 2;
  auto const count =
      static_cast<std::ptrdiff_t>(some.size()) * (middle - first_rank) / (last_rank - first_rank);
  std::ranges::nth_element(some, some.begin() + count, [&](Index a, Index b) {
    return std::pair(nodes(a, axis), a) < std::pair(nodes(b, axis), b);
  });
  bisect(nodes, some.first(static_cast<std::size_t>(count)), first_rank, middle, owner);
  bisect(nodes, some.subspan(static_cast<std::size_t>(count)), middle, last_rank, owner);
}

} // namespace

Share share_out(Matrix const& nodes, linear::Ranks const& ranks) {
  Share share{&ranks, Indices(static_cast<std::size_t>(nodes.rows())), {}, {0}};
  Indices some(share.owner.size());
  std::iota(some.begin(), some.end(), 0);
  share.order = some;
  bisect(nodes, some, 0, ranks.count(), share.owner);
  std::ranges::stable_sort(share.order, {}, [&](Index node) { return share.owner[ix(node)]; });
  for (int rank = 0; rank < ranks.count(); ++rank)
    share.first.push_back(share.first.back() +
                          static_cast<Index>(std::ranges::count(share.owner, static_cast<Index>(rank))));
  return share;
}

} // namespace stiction::dynamics
