// Neighbours, edges, averaged normals and hat areas of a surface of cell facets.
#include "contact/surface/cell_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "contact/surface/facet.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

void sort_unique(Indices& nodes) {
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// What a side is called by its own facet and by the neighbour's.
struct SideKey {
  Index from, to;
  [[nodiscard]] SideKey turned() const { return {to, from}; }
  [[nodiscard]] auto operator<=>(SideKey const&) const = default;
};

/// An end of a line is one node; the last of one facet is the first of the next.
SideKey key_of(CellFacet const& facet, int side) {
  if (facet.corners() == 2)
    return side == 0 ? SideKey{-1, facet.nodes[0]} : SideKey{facet.nodes[1], -1};
  return {facet.nodes[ix(side)], facet.nodes[ix((side + 1) % facet.corners())]};
}

std::size_t representative(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

int corner_of(CellFacet const& facet, Index node) {
  for (int k = 0; k < facet.corners(); ++k)
    if (facet.nodes[ix(k)] == node)
      return k;
  return -1;
}

/// Derivative of a facet's area vector at a corner by the position of its node k.
template<int D> Mat<D> area_by_node(FacetNodes<D> const& nodes, FacetShape const& shape, int k) {
  Mat<D> by;
  if constexpr (D == 2) {
    by << 0, shape.by[0][k], -shape.by[0][k], 0;
  } else {
    Vec3 const a = nodes * shape.by[0] * shape.by[1][k] - nodes * shape.by[1] * shape.by[0][k];
    by << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  }
  return by;
}

} // namespace

CellSurface::CellSurface(std::vector<mesh::Facet> const& facets, Matrix const& reference,
                         Vec3 const& direction)
    : dim_(static_cast<int>(reference.cols())) {
  for (auto const& given : facets) {
    CellFacet facet;
    facet.kind = kind_of(dim_, given.nodes.size());
    for (std::size_t k = 0; k < given.nodes.size(); ++k) {
      facet.nodes[k] = given.nodes[k];
      facet.reference.col(static_cast<Eigen::Index>(k)).head(dim_) =
          reference.row(given.nodes[k]).transpose();
      nodes_.push_back(given.nodes[k]);
    }
    corner_nodes_.insert(corner_nodes_.end(), facet.nodes.begin(), facet.nodes.begin() + facet.corners());
    facets_.push_back(facet);
    double const area = domain_size(facet.kind) * measure(size() - 1, middle_coordinates(facet.kind), false);
    double const length = dim_ == 2 ? area : std::sqrt(area);
    facet_size_ += length / static_cast<double>(facets.size());
    largest_size_ = std::max(largest_size_, length);
  }
  sort_unique(nodes_);
  sort_unique(corner_nodes_);
  link_sides();
  gather_fans();
  choose_directions(direction);
}

void CellSurface::link_sides() {
  std::map<SideKey, std::pair<int, int>> sides; // (facet, side)
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facet(f).corners(); ++k)
      core::expect(sides.emplace(key_of(facet(f), k), std::pair(f, k)).second,
                   "a checked surface neither branches nor turns over");
  for (auto const& [key, side] : sides)
    if (auto const other = sides.find(key.turned()); other != sides.end()) {
      auto& own = facets_[ix(side.first)];
      own.neighbour[ix(side.second)] = other->second.first;
      own.across[ix(side.second)] = other->second.second;
    }
}

/// Corners that meet across a side that is no edge share their normal.
void CellSurface::gather_fans() {
  std::vector<std::size_t> parent(4 * facets_.size());
  for (std::size_t i = 0; i < parent.size(); ++i)
    parent[i] = i;
  double const flat = std::cos(edge_angle);
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facet(f).corners(); ++k) {
      int const other = facet(f).neighbour[ix(k)];
      if (other < 0)
        continue;
      Vec3 const here = reference_normal(f, coordinates_on_side(facet(f).kind, k, 0.5)),
                 there = reference_normal(
                     other, coordinates_on_side(facet(other).kind, facet(f).across[ix(k)], 0.5));
      if (here.dot(there) < flat)
        continue;
      for (int c = 0; c < facet(f).corners(); ++c)
        if (int const match = corner_of(facet(other), facet(f).nodes[ix(c)]);
            match >= 0 && (dim_ == 3 ? c == k || c == (k + 1) % facet(f).corners() : c == k))
          parent[representative(parent, slot(f, c))] = representative(parent, slot(other, match));
    }
  std::map<std::size_t, int> number;
  for (int f = 0; f < size(); ++f)
    for (int c = 0; c < facet(f).corners(); ++c) {
      auto const [entry, fresh] =
          number.emplace(representative(parent, slot(f, c)), static_cast<int>(fans_.size()));
      if (fresh)
        fans_.emplace_back();
      facets_[ix(f)].fan[ix(c)] = entry->second;
      fans_[ix(entry->second)].push_back({f, c});
    }
}

void CellSurface::choose_directions(Vec3 const& direction) {
  if (dim_ == 2)
    return;
  core::expect(direction.norm() > 0, "the direction of the first tangent has no length");
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  for (int f = 0; f < size(); ++f) {
    double const along = reference_normal(f, middle_coordinates(facet(f).kind)).dot(direction.normalized());
    facets_[ix(f)].direction =
        std::abs(along) < nearly_parallel ? direction : Vec3(Vec3::Unit((largest + 1) % 3));
  }
}

Vec3 CellSurface::reference_normal(int number, Vec2 const& at) const {
  auto const shape = facet_shape(facet(number).kind, at);
  if (dim_ == 3)
    return across<3>(tangents_of<3>(facet(number).reference, shape)).normalized();
  Vec3 const along = facet(number).reference * shape.by[0];
  return Vec3(along.y(), -along.x(), 0).normalized();
}

double CellSurface::measure(int number, Vec2 const& at, bool around) const {
  auto const shape = facet_shape(facet(number).kind, at);
  auto const& reference = facet(number).reference;
  if (dim_ == 3)
    return across<3>(tangents_of<3>(reference, shape)).norm();
  double const length = (reference * shape.by[0]).norm();
  return around ? 2 * std::numbers::pi * reference.row(0).dot(shape.N.transpose()) * length : length;
}

std::vector<double> CellSurface::hat_areas(Indices const& points, bool around) const {
  std::map<Index, double> areas;
  for (int f = 0; f < size(); ++f) {
    auto const kind = facet(f).kind;
    auto const& rule = facet_rule(facet(f).corners(), true);
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      double const area = rule.weights[q] * measure(f, rule.points[q], around);
      auto const hats = facet_shape(linear_kind(kind), rule.points[q]).N;
      for (int k = 0; k < facet(f).corners(); ++k)
        areas[facet(f).nodes[ix(k)]] += area * hats[k];
    }
  }
  std::vector<double> result;
  for (Index const point : points)
    result.push_back(areas.at(point));
  return result;
}

template<int D> FacetNodes<D> CellSurface::positions(int number, Positions x) const {
  auto const& f = facet(number);
  FacetNodes<D> at = FacetNodes<D>::Zero();
  for (int k = 0; k < f.count(); ++k)
    at.col(k) = Eigen::Map<Vec<D> const>(&x[ix(D * f.nodes[ix(k)])]);
  return at;
}

template<int D> Vec<D> CellSurface::normal(int number, Vec2 const& at, Positions x) const {
  return across<D>(tangents_of<D>(positions<D>(number, x), facet_shape(facet(number).kind, at)));
}

template<int D> FanNormals<D> CellSurface::fan_normals(Positions x) const {
  FanNormals<D> normals;
  for (auto const& fan : fans_) {
    Vec<D> sum = Vec<D>::Zero();
    for (auto const& [f, c] : fan)
      sum += domain_size(facet(f).kind) * normal<D>(f, corner_coordinates(facet(f).kind, c), x);
    normals.length.push_back(sum.norm());
    normals.unit.push_back(sum / sum.norm());
  }
  return normals;
}

template FacetNodes<2> CellSurface::positions<2>(int, Positions) const;
template FacetNodes<3> CellSurface::positions<3>(int, Positions) const;
template Vec2 CellSurface::normal<2>(int, Vec2 const&, Positions) const;
template Vec3 CellSurface::normal<3>(int, Vec2 const&, Positions) const;
template<int D>
std::vector<NormalByNode<D>> CellSurface::turn_of_fan(FanNormals<D> const& normals, Index fan,
                                                      Positions x) const {
  Vec<D> const& n = normals.unit[ix(fan)];
  Mat<D> const by_area = (Mat<D>::Identity() - n * n.transpose()) / normals.length[ix(fan)];
  std::vector<NormalByNode<D>> all;
  for (auto const& [number, corner] : fans_[ix(fan)]) {
    auto const& f = facet(number);
    auto const nodes = positions<D>(number, x);
    auto const shape = facet_shape(f.kind, corner_coordinates(f.kind, corner));
    for (int k = 0; k < f.count(); ++k)
      all.push_back({f.nodes[ix(k)], domain_size(f.kind) * by_area * area_by_node<D>(nodes, shape, k)});
  }
  return all;
}

template FanNormals<2> CellSurface::fan_normals<2>(Positions) const;
template FanNormals<3> CellSurface::fan_normals<3>(Positions) const;
template std::vector<NormalByNode<2>> CellSurface::turn_of_fan<2>(FanNormals<2> const&, Index,
                                                                  Positions) const;
template std::vector<NormalByNode<3>> CellSurface::turn_of_fan<3>(FanNormals<3> const&, Index,
                                                                  Positions) const;

} // namespace stiction::contact
