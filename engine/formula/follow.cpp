// Pieces between turns, on each of which what is borne rises or falls; roots by halving.
#include "formula/follow.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::formula {

namespace {

constexpr double smallest = 1e-5;

/// Sizes that are looked at for turns, ascending: formulas are written so that these happen between, or close
/// to 1.
std::vector<double> looked_at() {
  std::vector<double> sizes;
  constexpr int decade = 200, near = 40;
  sizes.reserve(8 * decade + 2 * 9 * near + 1);
  for (int k = 0; k <= 8 * decade; ++k)
    sizes.push_back(smallest * std::pow(10, static_cast<double>(k) / decade));
  for (int k = 0; k < 9 * near; ++k) {
    double const off = 0.1 * std::pow(10, -static_cast<double>(k) / near);
    sizes.push_back(1 - off);
    sizes.push_back(1 + off);
  }
  std::ranges::sort(sizes);
  return sizes;
}

} // namespace

Follower::Follower(Formula const& formula, Drive drive) : formula_(&formula), drive_(drive) {
  find_turns();
}

double Follower::bears(double s) const {
  ++evaluations_;
  auto const state = formula_->at(s);
  return drive_ == Drive::depth ? state.depth : state.force;
}

void Follower::find_turns() {
  auto const sizes = looked_at();
  double before = bears(sizes[0]), now = bears(sizes[1]);
  for (std::size_t k = 1; k + 1 < sizes.size(); ++k) {
    double const after = bears(sizes[k + 1]);
    if ((now - before) * (after - now) < 0)
      turns_.push_back(turn(sizes[k - 1], sizes[k + 1], now > before ? 1 : -1));
    before = now;
    now = after;
  }
}

/// Of the largest (sign 1) or least (-1) that is borne between, by golden sections.
double Follower::turn(double low, double high, double sign) const {
  double const golden = (std::sqrt(5.0) - 1) / 2;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = sign * bears(left), at_right = sign * bears(right);
  while (high - low > 1e-12 * high) {
    if (at_left > at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = sign * bears(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = sign * bears(right);
    }
  }
  return 0.5 * (low + high);
}

/// Where the drive is borne, between a size that bears less and one that bears no less.
double Follower::root(double low, double high, double drive) const {
  for (;;) {
    double const middle = 0.5 * (low + high);
    if (!(low < middle && middle < high))
      return high;
    (bears(middle) < drive ? low : high) = middle;
  }
}

void Follower::grow(double from, double drive) {
  for (double const end : turns_) {
    if (end <= from)
      continue;
    if (bears(end) >= drive) {
      size_ = root(from, end, drive);
      return;
    }
    from = end;
  }
  double end = 2 * from;
  while (bears(end) < drive && std::isfinite(end))
    end *= 2;
  size_ = root(from, end, drive);
}

bool Follower::shrink(double from, double drive) {
  for (auto turn = turns_.rbegin(); turn != turns_.rend(); ++turn) {
    if (*turn >= from)
      continue;
    if (bears(*turn) <= drive) {
      size_ = root(*turn, from, drive);
      return true;
    }
    from = *turn;
  }
  double const least = bears(0);
  size_ = least < drive ? root(0, from, drive) : 0;
  return least <= drive;
}

std::optional<State> Follower::follow(double drive) {
  double const from = std::max(size_, smallest);
  bool const near = drive_ == Drive::force || size_ > 0 || drive >= bears(0);
  if (near && bears(from) < drive)
    grow(from, drive);
  else if (!near || !shrink(from, drive))
    return drive_ == Drive::depth ? std::optional(State{drive, 0, 0, 0, 0, 0}) : std::nullopt;
  return formula_->at(size_);
}

State largest_pull(Formula const& formula, double from) {
  Follower const follower(formula, Drive::force);
  auto least = formula.at(0);
  for (double const turn : follower.turns())
    if (auto const state = formula.at(turn); turn <= from && state.force < least.force)
      least = state;
  return least;
}

} // namespace stiction::formula
