// Neighbourhood, facing, depth and order of the points of a surface that may touch itself.
#include "contact/surface/own_side.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace stiction::contact {

namespace {

/// Cosine between a node's own normal and its counterpart's below which they face each other.
constexpr double opposed = -0.2;
/// Facets along the surface within which a node has no counterpart.
constexpr int neighbourhood = 3;
/// Cosine between the normals of facets beside each other below which they make a corner.
constexpr double sharp = 0.5;
/// Direction of the order: powers of the plastic number's inverse, far from axes and diagonals.
std::array<double, 3> const order_direction{1, 0.7548776662466927, 0.5698402909980532};

int ends_of(Curve const&, int) {
  return 2;
}
int ends_of(Surface const& surface, int facet) {
  return surface.facets()[ix(facet)].count;
}
Index node_at(Curve const& curve, int segment, int end) {
  return curve.segments()[ix(segment)].ends[ix(end)];
}
Index node_at(Surface const& surface, int facet, int corner) {
  return surface.facets()[ix(facet)].nodes[ix(corner)];
}
Foot foot_at(Curve const&, int segment, int end) {
  return {segment, static_cast<double>(end)};
}
Foot foot_at(Surface const& surface, int facet, int corner) {
  Vec2 const at = node_coordinates(surface.facets()[ix(facet)].count, corner);
  return {facet, at.x(), at.y()};
}

Foot middle_of(Curve const&, int segment) {
  return {segment, 0.5};
}
Foot middle_of(Surface const& surface, int facet) {
  double const middle = surface.facets()[ix(facet)].count == 3 ? 1.0 / 3 : 0;
  return {facet, middle, middle};
}
/// Does the surface end at a node with these feet?
bool ends_at(Curve const&, std::span<Foot const> feet) {
  return feet.size() < 2;
}
/// Each facet there has two edges that end at the node, of which it shares both with others within the
/// surface.
bool ends_at(Surface const& surface, std::span<Foot const> feet) {
  std::vector<Index> beside;
  for (Foot const& foot : feet) {
    auto const& facet = surface.facets()[ix(foot.segment)];
    std::size_t corner = 0;
    while (corner + 1 < ix(facet.count) &&
           (node_coordinates(facet.count, static_cast<int>(corner)) - Vec2(foot.xi, foot.eta)).squaredNorm() >
               0)
      ++corner;
    beside.push_back(facet.nodes[(corner + 1) % ix(facet.count)]);
    beside.push_back(facet.nodes[(corner + ix(facet.count) - 1) % ix(facet.count)]);
  }
  return std::ranges::any_of(beside, [&](Index node) { return std::ranges::count(beside, node) < 2; });
}

Vec2 normal_at(Curve const& curve, Foot foot, std::span<double const> x) {
  Vec2 const along = curve.evaluate(foot, x).by_xi[1].normalized();
  return {along.y(), -along.x()}; // the body lies to the left
}
Vec3 normal_at(Surface const& surface, Foot foot, std::span<double const> x) {
  return area_vector(surface.positions(foot.segment, x), surface.facets()[ix(foot.segment)].count)
      .normalized();
}
template<class Primary, class Point>
double gap_at(Primary const& primary, Point const& point, Foot foot, std::span<double const> x) {
  return normal_at(primary, foot, x).dot(point - primary.position(foot, x));
}

/// Where a facet is nearest to a point; of a curve: its chord.
template<class Primary, class Point>
Foot nearest_on(Primary const& primary, int facet, Point const& point, std::span<double const> x) {
  double distance2 = 0;
  return primary.sample(facet, point, x, distance2);
}
/// m
template<class Primary, class Point>
double distance(Primary const& primary, Point const& point, Foot foot, std::span<double const> x) {
  return (point - primary.position(foot, x)).norm();
}

double interpolate(Curve const& curve, Foot foot, std::vector<double> const& of_nodes) {
  auto const& ends = curve.segments()[ix(foot.segment)].ends;
  return (1 - foot.xi) * of_nodes[ix(ends[0])] + foot.xi * of_nodes[ix(ends[1])];
}
double interpolate(Surface const& surface, Foot foot, std::vector<double> const& of_nodes) {
  auto const& facet = surface.facets()[ix(foot.segment)];
  auto const N = shape<double>(facet.count, foot.xi, foot.eta).N;
  double sum = 0;
  for (std::size_t k = 0; k < ix(facet.count); ++k)
    sum += N[k] * of_nodes[ix(facet.nodes[k])];
  return sum;
}

Index nearest_node(Curve const& curve, Foot foot) {
  return node_at(curve, foot.segment, foot.xi < 0.5 ? 0 : 1);
}
Index nearest_node(Surface const& surface, Foot foot) {
  auto const& facet = surface.facets()[ix(foot.segment)];
  auto const N = shape<double>(facet.count, foot.xi, foot.eta).N;
  auto const most = std::max_element(N.begin(), N.begin() + facet.count);
  return facet.nodes[static_cast<std::size_t>(most - N.begin())];
}

/// Larger than every facet in the reference, m; asked of surfaces alone.
double longest_facet(Curve const&) {
  return 0;
}
double longest_facet(Surface const& surface) {
  double longest = 0;
  for (auto const& facet : surface.facets())
    for (std::size_t a = 0; a < ix(facet.count); ++a)
      for (std::size_t b = 0; b < a; ++b)
        longest = std::max(longest, (facet.reference[a] - facet.reference[b]).norm());
  return 1.001 * longest;
}

/// Are they a few facets apart at most, along the surface? longest: of the facets, m.
bool neighbours(Curve const& curve, std::span<Foot const> own, Foot foot, double) {
  auto const &here = curve.segments()[ix(own[0].segment)], &there = curve.segments()[ix(foot.segment)];
  double const size = std::max({curve.segment_length(), here.length, there.length});
  return curve.reference_distance(own[0], foot) < neighbourhood * size;
}
bool neighbours(Surface const& surface, std::span<Foot const> own, Foot foot, double longest) {
  Vec3 const &here = surface.facets()[ix(own[0].segment)].reference[0],
             &there = surface.facets()[ix(foot.segment)].reference[0];
  if ((here - there).norm() > (neighbourhood + 1) * longest)
    return false;
  std::vector<int> ring, seen;
  for (Foot const& at : own)
    ring.push_back(at.segment);
  for (int n = 0; n <= neighbourhood; ++n) {
    if (std::find(ring.begin(), ring.end(), foot.segment) != ring.end())
      return true;
    seen.insert(seen.end(), ring.begin(), ring.end());
    std::vector<int> next;
    for (int const facet : ring)
      for (int const beside : surface.around(facet))
        if (std::find(seen.begin(), seen.end(), beside) == seen.end()) {
          seen.push_back(beside);
          next.push_back(beside);
        }
    ring = std::move(next);
  }
  return false;
}

} // namespace

template<int D>
OwnSide<D>::OwnSide(Primary const& primary, std::span<double const> reference, double radius,
                    std::vector<bool> const& guided)
    : primary_(&primary), longest_(longest_facet(primary)) {
  gather_feet(reference.size() / D);
  order_nodes(reference);
  last_ = outstanding(reference, guided);
  look_through(reference, radius);
}

template<int D> std::span<Foot const> OwnSide<D>::feet_of(Index node) const {
  return {feet_.data() + starts_[ix(node)], starts_[ix(node) + 1] - starts_[ix(node)]};
}

template<int D> void OwnSide<D>::gather_feet(std::size_t nodes) {
  auto const each_end = [&](auto const& act) {
    for (int f = 0; f < primary_->size(); ++f)
      for (int end = 0; end < ends_of(*primary_, f); ++end)
        act(ix(node_at(*primary_, f, end)), foot_at(*primary_, f, end));
  };
  starts_.assign(nodes + 1, 0);
  each_end([&](std::size_t node, Foot) { ++starts_[node + 1]; });
  for (std::size_t node = 0; node < nodes; ++node)
    starts_[node + 1] += starts_[node];
  feet_.resize(starts_.back());
  auto next = starts_;
  each_end([&](std::size_t node, Foot foot) { feet_[next[node]++] = foot; });
}

/// Does a node stand out, as where the surface ends or has a convex corner or edge? Other nodes would pass
/// beside it.
template<int D> bool OwnSide<D>::stands_out(Index node, std::span<double const> reference) const {
  auto const own = feet_of(node);
  if (ends_at(*primary_, own))
    return true;
  for (Foot const& a : own)
    for (Foot const& b : own) {
      Vec<D> const normal = normal_at(*primary_, middle_of(*primary_, a.segment), reference);
      Vec<D> const way = primary_->position(middle_of(*primary_, b.segment), reference) -
                         primary_->position(middle_of(*primary_, a.segment), reference);
      if (normal.dot(normal_at(*primary_, middle_of(*primary_, b.segment), reference)) < sharp &&
          way.dot(normal) < 0)
        return true;
    }
  return false;
}

/// Those that stand out and what is near them along the surface.
template<int D>
std::vector<bool> OwnSide<D>::outstanding(std::span<double const> reference,
                                          std::vector<bool> const& guided) const {
  std::vector<bool> out(reference.size() / D, false);
  for (std::size_t node = 0; node < out.size(); ++node)
    out[node] = !feet_of(static_cast<Index>(node)).empty() && !(node < guided.size() && guided[node]) &&
                stands_out(static_cast<Index>(node), reference);
  for (int n = 0; n < neighbourhood; ++n) {
    auto const before = out;
    for (int f = 0; f < primary_->size(); ++f) {
      bool beside = false;
      for (int end = 0; end < ends_of(*primary_, f); ++end)
        beside = beside || before[ix(node_at(*primary_, f, end))];
      for (int end = 0; beside && end < ends_of(*primary_, f); ++end)
        out[ix(node_at(*primary_, f, end))] = true;
    }
  }
  return out;
}

template<int D> void OwnSide<D>::order_nodes(std::span<double const> reference) {
  order_.assign(reference.size() / D, 0);
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t node = 0; node < order_.size(); ++node) {
    for (std::size_t d = 0; d < D; ++d)
      order_[node] += order_direction[d] * reference[D * node + d];
    least = std::min(least, order_[node]);
    most = std::max(most, order_[node]);
  }
  tie_ = 1e-12 * (most - least);
}

template<int D> void OwnSide<D>::look_through(std::span<double const> reference, double radius) {
  std::vector<Box<D>> boxes;
  boxes.reserve(ix(primary_->size()));
  for (int f = 0; f < primary_->size(); ++f)
    boxes.push_back(primary_->box(f, reference));
  Grid<D> grid;
  grid.build(boxes);
  behind_.assign(order_.size(), {{}, radius, radius});
  for (std::size_t node = 0; node < behind_.size(); ++node)
    if (!feet_of(static_cast<Index>(node)).empty())
      grid.near(Eigen::Map<Vec<D> const>(&reference[D * node]), radius,
                [&](int f) { look_behind(static_cast<Index>(node), f, reference); });
}

template<int D> void OwnSide<D>::look_behind(Index node, int facet, std::span<double const> reference) {
  Vec<D> const point = Eigen::Map<Vec<D> const>(&reference[D * ix(node)]);
  auto& behind = behind_[ix(node)];
  Foot const foot = nearest_on(*primary_, facet, point, reference);
  double const gap = gap_at(*primary_, point, foot, reference),
               way = distance(*primary_, point, foot, reference);
  bool const tells = way < behind.way || -gap < behind.thickness;
  if (!(gap < 0) || !tells || !faces(node, foot, reference))
    return;
  behind.thickness = std::min(behind.thickness, -gap);
  if (way < behind.way || !behind.foot.found()) {
    behind.foot = foot;
    behind.way = way;
  }
}

/// Half of what is seen through the body, less as far as that has come nearer, is not gone through.
template<int D>
bool OwnSide<D>::sees_through(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const {
  if (!(gap_at(*primary_, point, foot, x) < 0))
    return false;
  auto const& behind = behind_[ix(node)];
  double const now = behind.foot.found() ? distance(*primary_, point, behind.foot, x) : behind.way;
  double const thickness = behind.thickness * std::min(1.0, now / behind.way);
  return distance(*primary_, point, nearest_on(*primary_, foot.segment, point, x), x) >= thickness / 2;
}

template<int D> bool OwnSide<D>::faces(Index node, Foot foot, std::span<double const> x) const {
  auto const own = feet_of(node);
  Vec<D> normal = Vec<D>::Zero();
  for (Foot const& at : own)
    normal += normal_at(*primary_, at, x);
  return normal.normalized().dot(normal_at(*primary_, foot, x)) < opposed &&
         !neighbours(*primary_, own, foot, longest_);
}

template<int D> bool OwnSide<D>::comes_after(Index node, Foot foot) const {
  bool const there = last_[ix(nearest_node(*primary_, foot))];
  return last_[ix(node)] != there ? !there : order_[ix(node)] > interpolate(*primary_, foot, order_) - tie_;
}

template<int D>
bool OwnSide<D>::allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const {
  if (node < 0 || ix(node) >= order_.size() || feet_of(node).empty())
    return true;
  return comes_after(node, foot) && !sees_through(node, point, foot, x) && faces(node, foot, x);
}

template class OwnSide<2>;
template class OwnSide<3>;

} // namespace stiction::contact
