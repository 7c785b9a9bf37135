// Where a way meets the surface of an obstacle: each gap is as far as the way may be followed unseen.
#include "contact/tunnelling/obstacle_tunnelling.hpp"

#include <algorithm>
#include <optional>

namespace stiction::contact {

namespace {

constexpr int most_strides = 10000;       // of a way that glides past
constexpr double blind_stride = 1.0 / 32; // of the way at most, where no counterpart is found
constexpr int depth_samples = 32;         // of the way
constexpr double short_way = 8;           // of the reach: samples of such a way miss nothing
constexpr double other_side = -0.5;       // cosine between the normals of two sides

template<int D> Mat<D> turn_about(Vec3 const& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix().template topLeftCorner<D, D>();
}

template<int D> class Walk {
public:
  Walk(Obstacle const& obstacle, RelativeWay<D> const& way, WayEnds const& ends)
      : obstacle_(&obstacle), way_(&way), reach_(ends.reach), held_(ends.held),
        start_(seen_at(0, ends.first)), end_(seen_at(1, ends.last)) {}

  [[nodiscard]] bool passes() const {
    bool const began_inside = start_.found && start_.gap < -reach_;
    bool const stays_inside = end_.found && end_.gap < -most_depth * reach_;
    if (began_inside || slides() || (stays_inside && held_))
      return false;
    if (!stays_inside && way_->length() < short_way * reach_ && depth(0, 1) < least())
      return false;
    auto const entry = meet(false);
    if (!entry || stays_inside)
      return entry.has_value();
    auto const exit = meet(true);
    double const between = depth(*entry, exit.value_or(1));
    bool const turned = exit && normal(*entry).dot(normal(*exit)) < other_side;
    return between >= least() && (turned || (!held_ && between > reach_));
  }

private:
  [[nodiscard]] double least() const { return least_depth * reach_; }
  /// Gap below which the surface is met, m.
  [[nodiscard]] double skin() const { return 0.1 * least(); }
  [[nodiscard]] ObstacleView<D> seen_at(double t, Foot guess = {}) const {
    return view<D>(*obstacle_, way_->at(t), {}, guess, Vec3::UnitX());
  }
  [[nodiscard]] Vec<D> normal(double t) const { return seen_at(t).frame.col(0); }
  /// It lay on the surface and is held by nearly the same side of it.
  [[nodiscard]] bool slides() const {
    bool const on_it = start_.found && end_.found && std::max(start_.gap, end_.gap) < skin();
    return held_ && on_it && start_.frame.col(0).dot(end_.frame.col(0)) >= other_side;
  }
  /// Where the way first comes to the surface from outside, or walked backwards where it last does.
  [[nodiscard]] std::optional<double> meet(bool backwards) const {
    bool seen = true; // before this point: what comes into sight behind an open end was not met
    double const blind = std::min(blind_stride, most_depth * reach_ / way_->length());
    double walked = 0;
    for (int stride = 0; stride < most_strides && walked <= 1; ++stride) {
      double const t = backwards ? 1 - walked : walked;
      auto const here = seen_at(t);
      if (here.found && here.gap < skin())
        return seen ? std::optional(t) : std::nullopt;
      seen = here.found;
      walked += seen ? here.gap / way_->length() : blind;
    }
    return {};
  }
  /// How much deeper than its ends a part of the way lies, m.
  [[nodiscard]] double depth(double from, double to) const {
    double least = 0;
    Foot guess = start_.foot;
    for (int k = 0; k <= depth_samples; ++k) {
      auto const here = seen_at(from + (to - from) * k / depth_samples, guess);
      if (!here.found)
        continue;
      guess = here.foot;
      least = std::min(least, here.gap);
    }
    return std::min({0.0, start_.found ? start_.gap : 0.0, end_.found ? end_.gap : 0.0}) - least;
  }

  Obstacle const* obstacle_;
  RelativeWay<D> const* way_;
  double reach_; ///< m
  bool held_;
  ObstacleView<D> start_, end_;
};

} // namespace

template<int D>
RelativeWay<D>::RelativeWay(Vec<D> const& from, Vec<D> const& to, Pose<D> const& first, Pose<D> const& last)
    : arm_(from - first.position), move_(to - last.position - arm_), first_(first) {
  if (first.rotation != last.rotation) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<D, D>() = last.rotation * first.rotation.transpose();
    Eigen::AngleAxisd const about(turn);
    axis_ = about.axis();
    angle_ = about.angle();
  }
  length_ = move_.norm() + std::abs(angle_) * std::max(arm_.norm(), (arm_ + move_).norm());
}

template<int D> Vec<D> RelativeWay<D>::at(double t) const {
  Vec<D> const arm = arm_ + t * move_;
  Vec<D> const unturned = angle_ == 0 ? arm : Vec<D>(turn_about<D>(axis_, -t * angle_) * arm);
  return first_.pivot + first_.rotation.transpose() * unturned;
}

template<int D> bool passes(Obstacle const& obstacle, RelativeWay<D> const& way, WayEnds const& ends) {
  return way.length() >= 2 * least_depth * ends.reach && Walk<D>(obstacle, way, ends).passes();
}

template class RelativeWay<2>;
template class RelativeWay<3>;
template bool passes(Obstacle const&, RelativeWay<2> const&, WayEnds const&);
template bool passes(Obstacle const&, RelativeWay<3> const&, WayEnds const&);

} // namespace stiction::contact
