// Splitting, neighbours, edges and nodal normals of a primary surface in space.
#include "contact/surface/surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>

#include "core/error.hpp"
#include "mesh/topology/hats.hpp"

namespace stiction::contact {

namespace {

using LinearPiece = std::vector<int>; // local nodes of one linear facet

std::vector<LinearPiece> const& pieces_of(std::size_t nodes) {
  auto const& pieces = mesh::linear_pieces(3, nodes);
  if (pieces.empty())
    throw core::InputError(fmt::format("contact surface: a facet has {} nodes; facets in space have 3, 4, 6 "
                                       "or 8; use the boundary of a mesh of solid cells",
                                       nodes));
  return pieces;
}

/// Representatives in the sense of union and find.
struct Groups {
  std::vector<std::size_t> parent;
  explicit Groups(std::size_t n) : parent(n) {
    for (std::size_t i = 0; i < n; ++i)
      parent[i] = i;
  }
  std::size_t find(std::size_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent[std::max(find(i), find(j))] = std::min(find(i), find(j)); }
};

int local_number(Facet const& facet, Index node) {
  auto const* end = facet.nodes.data() + facet.count;
  return static_cast<int>(std::find(facet.nodes.data(), end, node) - facet.nodes.data());
}

/// The corners around a node on one side of edges get the same group.
void join_across(std::vector<Facet> const& facets, int f, int side, Groups& groups) {
  auto const& facet = facets[ix(f)];
  int const other = facet.neighbour[ix(side)];
  if (other < 0 || facet.sharp[ix(side)])
    return;
  for (int const k : {side, (side + 1) % facet.count})
    groups.join(slot(f, k), slot(other, local_number(facets[ix(other)], facet.nodes[ix(k)])));
}

} // namespace

Surface::Surface(std::vector<mesh::Facet> const& facets, Matrix const& reference, Vec3 const& direction) {
  core::expect(reference.cols() == 3, "a surface needs nodes in space");
  split(facets, reference);
  link_sides();
  gather_fans();
  gather_stencils();
  choose_directions(direction);
}

void Surface::split(std::vector<mesh::Facet> const& facets, Matrix const& reference) {
  for (auto const& given : facets)
    for (auto const& piece : pieces_of(given.nodes.size())) {
      Facet facet;
      facet.count = static_cast<int>(piece.size());
      for (std::size_t k = 0; k < piece.size(); ++k) {
        facet.nodes[k] = given.nodes[ix(piece[k])];
        facet.reference[k] = reference.row(facet.nodes[k]).transpose();
        nodes_.push_back(facet.nodes[k]);
      }
      facet_size_ += std::sqrt(area_vector(facet.reference, facet.count).norm());
      facets_.push_back(facet);
    }
  if (!facets_.empty())
    facet_size_ /= static_cast<double>(facets_.size());
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

Vec3 Surface::reference_normal(int facet) const {
  auto const& f = facets_[ix(facet)];
  return area_vector(f.reference, f.count).normalized();
}

void Surface::link_sides() {
  std::map<std::pair<Index, Index>, std::pair<int, int>> sides; // (from, to) -> (facet, side)
  for (int f = 0; f < size(); ++f) {
    auto const& facet = facets_[ix(f)];
    for (int k = 0; k < facet.count; ++k) {
      Index const from = facet.nodes[ix(k)], to = facet.nodes[ix((k + 1) % facet.count)];
      if (!sides.emplace(std::pair(from, to), std::pair(f, k)).second)
        throw core::InputError(fmt::format(
            "contact surface: two facets run from node {} to node {}; the surface branches or its "
            "facets are oriented against each other; use a boundary of one body with consistently "
            "oriented facets",
            from, to));
    }
  }
  double const flat = std::cos(edge_angle);
  for (auto const& [ends, side] : sides)
    if (auto const other = sides.find({ends.second, ends.first}); other != sides.end()) {
      auto& facet = facets_[ix(side.first)];
      facet.neighbour[ix(side.second)] = other->second.first;
      facet.across[ix(side.second)] = other->second.second;
      facet.sharp[ix(side.second)] =
          reference_normal(side.first).dot(reference_normal(other->second.first)) < flat;
    }
}

void Surface::gather_fans() {
  Groups groups(4 * facets_.size());
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facets_[ix(f)].count; ++k)
      join_across(facets_, f, k, groups);
  std::map<std::size_t, std::vector<int>> fans;
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facets_[ix(f)].count; ++k)
      fans[groups.find(slot(f, k))].push_back(f);
  std::map<std::size_t, int> number;
  fan_starts_ = {0};
  for (auto const& [group, fan] : fans) {
    number.emplace(group, static_cast<int>(number.size()));
    fan_facets_.insert(fan_facets_.end(), fan.begin(), fan.end());
    fan_starts_.push_back(static_cast<int>(fan_facets_.size()));
  }
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facets_[ix(f)].count; ++k)
      facets_[ix(f)].corner[ix(k)] = number.at(groups.find(slot(f, k)));
}

void Surface::gather_stencils() {
  std::map<Index, std::vector<int>> of_node;
  for (int f = 0; f < size(); ++f)
    for (int k = 0; k < facets_[ix(f)].count; ++k)
      of_node[facets_[ix(f)].nodes[ix(k)]].push_back(f);
  around_starts_ = stencil_starts_ = {0};
  for (auto const& facet : facets_) {
    Indices nodes(facet.nodes.begin(), facet.nodes.begin() + facet.count);
    std::vector<int> near;
    std::size_t valence = 0;
    for (int k = 0; k < facet.count; ++k) {
      auto const& here = of_node[facet.nodes[ix(k)]];
      near.insert(near.end(), here.begin(), here.end());
      valence = std::max(valence, here.size());
      for (int const other : fan(facet.corner[ix(k)]))
        for (int j = 0; j < facets_[ix(other)].count; ++j)
          if (Index const node = facets_[ix(other)].nodes[ix(j)];
              std::find(nodes.begin(), nodes.end(), node) == nodes.end())
            nodes.push_back(node);
    }
    if (nodes.size() + 1 > ix(max_nodes<3>))
      throw core::InputError(fmt::format(
          "contact surface: {} nodes surround the facet of node {}, where up to {} facets meet at a "
          "node; at most {} can take part in a contact; use a mesh with fewer facets around a node",
          nodes.size(), facet.nodes[0], valence, max_nodes<3> - 1));
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    around_facets_.insert(around_facets_.end(), near.begin(), near.end());
    around_starts_.push_back(static_cast<int>(around_facets_.size()));
    stencil_nodes_.insert(stencil_nodes_.end(), nodes.begin(), nodes.end());
    stencil_starts_.push_back(static_cast<int>(stencil_nodes_.size()));
  }
}

void Surface::choose_directions(Vec3 const& direction) {
  core::expect(direction.norm() > 0, "the direction of the first tangent has no length");
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  for (int f = 0; f < size(); ++f) {
    bool const usable = std::abs(reference_normal(f).dot(direction.normalized())) < nearly_parallel;
    facets_[ix(f)].direction = usable ? direction : Vec3(Vec3::Unit((largest + 1) % 3));
  }
}

namespace {

template<class T> std::span<T const> part(std::vector<T> const& all, std::vector<int> const& starts, int i) {
  auto const first = ix(starts[ix(i)]);
  return std::span(all).subspan(first, ix(starts[ix(i) + 1]) - first);
}

} // namespace

std::span<Index const> Surface::stencil(int facet) const {
  return part(stencil_nodes_, stencil_starts_, facet);
}
std::span<int const> Surface::fan(int corner) const {
  return part(fan_facets_, fan_starts_, corner);
}
std::span<int const> Surface::around(int facet) const {
  return part(around_facets_, around_starts_, facet);
}

std::array<Vec3, 4> Surface::positions(int facet, std::span<double const> x) const {
  auto const& f = facets_[ix(facet)];
  std::array<Vec3, 4> at;
  at[3].setZero();
  for (int k = 0; k < f.count; ++k)
    at[ix(k)] = Eigen::Map<Vec3 const>(&x[3 * ix(f.nodes[ix(k)])]);
  return at;
}

Vec3 Surface::position(Foot foot, std::span<double const> x) const {
  int const count = facets_[ix(foot.segment)].count;
  return combine<double>(shape(count, foot.xi, foot.eta).N, positions(foot.segment, x), count);
}

FacetNow Surface::now(int facet, std::span<double const> x) const {
  auto const& f = facets_[ix(facet)];
  FacetNow now{positions(facet, x), {}};
  now.normals[3].setZero();
  for (int k = 0; k < f.count; ++k) {
    Vec3 sum = Vec3::Zero();
    for (int const other : fan(f.corner[ix(k)]))
      sum += area_vector(positions(other, x), facets_[ix(other)].count);
    now.normals[ix(k)] = sum.normalized();
  }
  return now;
}

SurfacePoint Surface::evaluate(Foot foot, std::span<double const> x) const {
  int const count = facets_[ix(foot.segment)].count;
  auto const at = now(foot.segment, x);
  auto const N = shape(count, foot.xi, foot.eta);
  return {combine<double>(N.N, at.x, count), combine<double>(N.by_xi, at.x, count),
          combine<double>(N.by_eta, at.x, count), combine<double>(N.N, at.normals, count).normalized()};
}

Box<3> Surface::box(int facet, std::span<double const> x) const {
  auto const at = positions(facet, x);
  Box<3> box{at[0], at[0]};
  for (int k = 1; k < facets_[ix(facet)].count; ++k) {
    box.low = box.low.cwiseMin(at[ix(k)]);
    box.high = box.high.cwiseMax(at[ix(k)]);
  }
  return box;
}

} // namespace stiction::contact
