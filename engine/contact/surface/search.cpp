// Queries for feet, and what a curve's own nodes may take for their counterpart.
#include "contact/surface/search.hpp"

#include <algorithm>
#include <limits>

#include "core/error.hpp"

namespace stiction::contact {

namespace {

/// Cosine between a node's own normal and its counterpart's below which they face each other.
constexpr double facing = -0.2;
/// Reference length along the curve within which a node has no counterpart, in segments.
constexpr double neighbourhood = 3;

Vec2 normal_at(Curve const& curve, Foot foot, std::span<double const> x) {
  Vec2 const along = curve.evaluate(foot, x).by_xi[1].normalized();
  return {along.y(), -along.x()}; // the body lies to the left
}

/// Of a node, also at a corner.
Vec2 own_normal(Curve const& curve, Foot foot, std::span<double const> x) {
  Vec2 n = normal_at(curve, foot, x);
  if (int const before = curve.segments()[ix(foot.segment)].previous; foot.xi == 0 && before >= 0)
    n += normal_at(curve, {before, 1}, x);
  return n.normalized();
}

double largest_size(Curve const& curve) {
  double largest = 0;
  for (auto const& segment : curve.segments())
    largest = std::max(largest, segment.length);
  return largest;
}
double largest_size(Surface const& surface) {
  return surface.facet_size(); // the nearest point of a facet is exact, however large the facet
}
double mean_size(Curve const& curve) {
  return curve.segment_length();
}
double mean_size(Surface const& surface) {
  return surface.facet_size();
}
Vec2 position(Curve const& curve, Foot foot, std::span<double const> x) {
  return curve.evaluate(foot, x).by_xi[0];
}
Vec3 position(Surface const& surface, Foot foot, std::span<double const> x) {
  return surface.position(foot, x);
}
double gap_at(Curve const& curve, Vec2 const& point, Foot foot, std::span<double const> x) {
  return normal_at(curve, foot, x).dot(point - position(curve, foot, x));
}

} // namespace

OwnSide::OwnSide(Curve const& curve, std::span<double const> reference, double radius)
    : curve_(&curve), of_node_(reference.size() / 2) {
  std::vector<Box<2>> boxes;
  for (int s = 0; s < curve.size(); ++s) {
    boxes.push_back(curve.box(s, reference));
    auto const& ends = curve.segments()[ix(s)].ends;
    of_node_[ix(ends[0])].foot = {s, 0};
    if (curve.segments()[ix(s)].next < 0)
      of_node_[ix(ends[1])].foot = {s, 1};
  }
  Grid<2> grid;
  grid.build(boxes);
  for (std::size_t node = 0; node < of_node_.size(); ++node) {
    auto& own = of_node_[node];
    if (!own.foot.found())
      continue;
    own.depth = radius / 2;
    Vec2 const point = position(curve, own.foot, reference);
    grid.near(point, radius, [&](int s) { // half of what is seen through the body is not gone through
      double distance2 = 0;
      Foot const foot = curve.sample(s, point, reference, distance2);
      double const gap = gap_at(curve, point, foot, reference);
      if (gap < 0 && faces(own, foot, reference))
        own.depth = std::min(own.depth, -gap / 2);
    });
  }
}

bool OwnSide::faces(Own const& own, Foot foot, std::span<double const> x) const {
  auto const &here = curve_->segments()[ix(own.foot.segment)], &there = curve_->segments()[ix(foot.segment)];
  double const size = std::max({curve_->segment_length(), here.length, there.length});
  if (curve_->reference_distance(own.foot, foot) < neighbourhood * size)
    return false;
  return own_normal(*curve_, own.foot, x).dot(normal_at(*curve_, foot, x)) < facing;
}

bool OwnSide::allows(Index node, Vec2 const& point, Foot foot, std::span<double const> x) const {
  if (node < 0 || ix(node) >= of_node_.size() || !of_node_[ix(node)].foot.found())
    return true;
  auto const& own = of_node_[ix(node)];
  return gap_at(*curve_, point, foot, x) > -own.depth && faces(own, foot, x);
}

template<int D>
Search<D>::Search(Primary const& primary, double reach)
    : primary_(&primary), size_(mean_size(primary)),
      radius_(std::max(4 * size_, reach + largest_size(primary))) {}

template<int D> void Search<D>::allow_self(std::span<double const> reference) {
  if constexpr (D == 2)
    own_.emplace(*primary_, reference, radius_);
  else
    core::expect(reference.empty(), "only plane curves may touch themselves");
}

template<int D> void Search<D>::update(std::span<double const> x) {
  boxes_.clear();
  for (int f = 0; f < primary_->size(); ++f)
    boxes_.push_back(primary_->box(f, x));
  grid_.build(boxes_);
}

template<int D>
bool Search<D>::allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const {
  if constexpr (D == 2)
    return !own_ || own_->allows(node, point, foot, x);
  else
    return static_cast<void>(node), static_cast<void>(point), static_cast<void>(x), foot.found();
}

template<int D>
Foot Search<D>::nearest(Vec<D> const& point, std::span<double const> x, Index node, long* visits) const {
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  long count = 0;
  auto const visit = [&](int f) {
    ++count;
    double distance2 = 0;
    Foot const foot = primary_->sample(f, point, x, distance2);
    bool const nearer = distance2 < least || (distance2 == least && f < best.segment);
    if (nearer && allows(node, point, foot, x)) {
      least = distance2;
      best = foot;
    }
  };
  for (double radius = std::min(size_, radius_);; radius = std::min(2 * radius, radius_)) {
    grid_.near(point, radius + size_ / 2, visit);
    if (least <= radius * radius || radius >= radius_)
      break;
  }
  if (visits != nullptr)
    *visits += count;
  return least <= radius_ * radius_ ? best : Foot{};
}

template<int D>
Foot Search<D>::project(Index node, Vec<D> const& point, Foot guess, std::span<double const> x) const {
  auto const from = [&](Foot start) {
    Foot const foot = start.found() ? primary_->follow(point, start, x) : Foot{};
    bool const good = foot.found() && allows(node, point, foot, x) &&
                      (point - position(*primary_, foot, x)).norm() <= 1.5 * radius_;
    return good ? foot : Foot{};
  };
  Foot const foot = from(guess);
  return foot.found() ? foot : from(nearest(point, x, node));
}

template class Search<2>;
template class Search<3>;

} // namespace stiction::contact
