// Queries for feet.
#include "contact/surface/search.hpp"

#include <algorithm>
#include <limits>

namespace stiction::contact {

namespace {

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

} // namespace

template<int D>
Search<D>::Search(Primary const& primary, double reach)
    : primary_(&primary), size_(mean_size(primary)),
      radius_(std::max(4 * size_, reach + largest_size(primary))) {}

template<int D>
void Search<D>::allow_self(std::span<double const> reference, std::vector<bool> const& guided) {
  own_.emplace(*primary_, reference, radius_, guided);
}

template<int D> void Search<D>::update(std::span<double const> x) {
  boxes_.clear();
  for (int f = 0; f < primary_->size(); ++f)
    boxes_.push_back(primary_->box(f, x));
  grid_.build(boxes_);
}

template<int D>
bool Search<D>::allows(Index node, Vec<D> const& point, Foot foot, std::span<double const> x) const {
  return !own_ || own_->allows(node, point, foot, x);
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
Foot Search<D>::project(Index node, Vec<D> const& point, Foot guess, std::span<double const> x,
                        Overhang overhang) const {
  auto const from = [&](Foot start) {
    Foot const foot = start.found() ? primary_->follow(point, start, x, overhang) : Foot{};
    bool const good = foot.found() && allows(node, point, foot, x) &&
                      (point - primary_->position(foot, x)).norm() <= 1.5 * radius_;
    return good ? foot : Foot{};
  };
  Foot const foot = from(guess);
  return foot.found() ? foot : from(nearest(point, x, node));
}

template class Search<2>;
template class Search<3>;

} // namespace stiction::contact
