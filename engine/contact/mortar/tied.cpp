// Dual functions facet by facet, and what they see of the other surface.
#include "contact/mortar/tied.hpp"

#include <algorithm>
#include <cmath>

#include "contact/mortar/tied_cut.hpp"
#include "contact/surface/grid.hpp"
#include "core/error.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

Box<3> box_of(CellFacet const& facet) {
  auto const nodes = facet.reference.leftCols(facet.count());
  return {nodes.rowwise().minCoeff(), nodes.rowwise().maxCoeff()};
}

/// [nodes, nodes]: column j is the function that borrowed, by shape functions; of corners N_c + a sum N_m.
Dense borrowing(CellFacet const& facet, bool around) {
  int const corners = facet.corners(), count = facet.count();
  Dense B = Dense::Identity(count, count);
  bool const healthy = count == corners || (corners == 2 && !around);
  for (int m = corners; m < count && !healthy; ++m) {
    double const a = 0.2;
    for (int const c : {m - corners, corners == 2 ? 1 : (m - corners + 1) % corners})
      B(m, c) = a;
    B(m, m) = 1 - 2 * a;
  }
  return B;
}

/// The other surface's facets by place.
class Field {
public:
  Field(CellSurface const& own, CellSurface const& other, bool around)
      : own_(&own), other_(&other), around_(around) {
    std::vector<Box<3>> boxes;
    boxes.reserve(other.facets().size());
    for (auto const& facet : other.facets())
      boxes.push_back(box_of(facet));
    grid_.build(boxes);
  }

  [[nodiscard]] TiedFacet tie(int number) const {
    auto const& facet = own_->facet(number);
    TiedFacet tied;
    tied.own.assign(facet.nodes.begin(), facet.nodes.begin() + facet.count());
    TiedGround const ground(facet, own_->dim(), around_);
    auto const box = box_of(facet);
    double const largest = std::max(size_of(*own_, number), other_->largest_size());
    std::vector<int> near;
    grid_.near(0.5 * (box.low + box.high), 0.5 * (box.high - box.low).norm() + tied_gap * largest,
               [&](int f) { near.push_back(f); });
    std::sort(near.begin(), near.end());
    std::vector<std::pair<int, TiedPart>> parts;
    tied.reach = tied_gap * size_of(*own_, number);
    for (int const f : near) {
      auto part = ground.common(other_->facet(f));
      double const reach = tied_gap * std::max(size_of(*own_, number), size_of(*other_, f));
      if (part.points.empty())
        continue;
      tied.reach = std::max(tied.reach, reach);
      if (part.gap > reach) {
        tied.gap = tied.gap > 0 ? std::min(tied.gap, part.gap) : part.gap;
        continue;
      }
      tied.covered += part.area / ground.area();
      parts.emplace_back(f, std::move(part));
    }
    if (std::abs(tied.covered - 1) <= tied_bare)
      integrate(facet, parts, tied);
    return tied;
  }

private:
  static double size_of(CellSurface const& surface, int number) {
    auto const kind = surface.facet(number).kind;
    double const area = domain_size(kind) * surface.measure(number, middle_coordinates(kind), false);
    return surface.dim() == 2 ? area : std::sqrt(area);
  }

  void integrate(CellFacet const& facet, std::vector<std::pair<int, TiedPart>> const& parts,
                 TiedFacet& tied) const {
    int const count = facet.count();
    Dense products = Dense::Zero(count, count);
    for (auto const& [f, part] : parts) {
      auto const& other = other_->facet(f);
      tied.other.insert(tied.other.end(), other.nodes.begin(), other.nodes.begin() + other.count());
      for (auto const& point : part.points)
        products += point.weight * point.own.head(count) * point.own.head(count).transpose();
    }
    std::sort(tied.other.begin(), tied.other.end());
    tied.other.erase(std::unique(tied.other.begin(), tied.other.end()), tied.other.end());
    Dense const B = borrowing(facet, around_);
    Vector const areas = B.transpose() * products.colwise().sum().transpose();
    if (!(areas.minCoeff() > 0))
      throw core::InputError("a facet is so distorted that shape functions have no area on it");
    // psi = areas (B^T products B)^-1 B^T N
    Dense const dual = areas.asDiagonal() * (B.transpose() * products * B).llt().solve(B.transpose());
    tied.D = areas.asDiagonal() * B.inverse();
    tied.M = Dense::Zero(count, static_cast<Index>(tied.other.size()));
    for (auto const& [f, part] : parts)
      see(other_->facet(f), part, dual, tied);
  }

  static void see(CellFacet const& other, TiedPart const& part, Dense const& dual, TiedFacet& tied) {
    Dense sum = Dense::Zero(dual.rows(), other.count());
    for (auto const& point : part.points)
      sum +=
          point.weight * (dual * point.own.head(dual.cols())) * point.other.head(other.count()).transpose();
    for (int l = 0; l < other.count(); ++l) {
      auto const at = std::ranges::lower_bound(tied.other, other.nodes[ix(l)]) - tied.other.begin();
      tied.M.col(at) += sum.col(l);
    }
  }

  CellSurface const *own_, *other_;
  bool around_;
  Grid<3> grid_;
};

} // namespace

std::vector<TiedFacet> tie(CellSurface const& own, CellSurface const& other, bool around) {
  Field const field(own, other, around);
  std::vector<TiedFacet> all;
  all.reserve(own.facets().size());
  for (int f = 0; f < own.size(); ++f)
    all.push_back(field.tie(f));
  return all;
}

} // namespace stiction::contact
