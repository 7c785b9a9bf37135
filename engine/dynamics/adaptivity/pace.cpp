// Judges attempts and sets the size of the next one.
#include "dynamics/adaptivity/pace.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace stiction::dynamics {

namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();
constexpr double safety = 0.9;
constexpr double worthwhile = 1.3, needless = 0.8; ///< between these factors the step, and a factor, is kept
constexpr double fastest = 2, deepest = 0.1;       ///< growth and cut at most
constexpr int first_share = 8; ///< the first step, of whose error nothing is known, is so much smaller
constexpr int patience = 10;   ///< steps after a failed one before a longer one is tried again
constexpr double rounding = 1e-9;
constexpr double sliver = 1e-6; ///< part of the smallest step by which a moment may be missed

std::string words(Event const& event, char const* verb) {
  return fmt::format("point {} of pair {} {}{}", event.point + 1, event.pair + 1, verb, name_of(event.kind));
}

} // namespace

char const* name_of(Cut cut) {
  constexpr std::array<char const*, 5> names = {"none", "not_converged", "error", "beta_change", "event"};
  return names[static_cast<std::size_t>(cut)];
}

Pace<History> pace_of(Accuracy const& accuracy, BulkSystem const& bulk, Model const& model) {
  bool const inertia = weights(model.scheme).inertia;
  auto const bonded = [](Pair const& pair) { return pair.law.adhesion.has_value(); };
  return {History(bulk, model),
          StepSizes(accuracy, inertia ? StepSizes::Kind::rungs : StepSizes::Kind::any,
                    inertia || accuracy.events > 0 || std::ranges::any_of(model.pairs, bonded))};
}

/// The largest step that is not above dt: dt itself, or a rung.
double StepSizes::rung(double dt) const {
  return rungs_ ? base_ * std::exp2(std::floor(std::log2(dt / base_ * (1 + rounding)))) : dt;
}

void StepSizes::begin(double nominal, int halvings) {
  largest_ = accuracy_.largest > 0 ? accuracy_.largest : most_growth * nominal;
  smallest_ = accuracy_.smallest > 0 ? accuracy_.smallest : std::ldexp(nominal, -halvings);
  base_ = nominal;
  if (rungs_) {
    smallest_ = base_ * std::exp2(std::ceil(std::log2(smallest_ / base_ * (1 - rounding))));
    largest_ = rung(largest_);
  }
  smallest_ = std::min(smallest_, largest_);
  if (wanted_ == 0)
    wanted_ = nominal / first_share;
  wanted_ = std::clamp(rung(wanted_), smallest_, largest_);
}

bool StepSizes::at_smallest(double dt) const {
  return dt <= smallest_ * (1 + rounding);
}

double StepSizes::slack() const {
  return sliver * smallest_;
}

bool StepSizes::arrives(double dt, double left) const {
  return left - dt <= slack();
}

double StepSizes::next(std::optional<Event> const& expected, double left) {
  double const dt = std::min(wanted_, once_);
  aim_.clear();
  if (expected && expected->after > accuracy_.events && expected->after < std::min(dt, left)) {
    aim_ = words(*expected, "is expected to be next: it ");
    return std::max(rungs_ ? rung(expected->after) : expected->after - 0.5 * accuracy_.events, smallest_);
  }
  if (rungs_)
    return dt < left ? dt : rung(left + slack());
  if (dt >= left * (1 - rounding))
    return left;
  return left < 2 * dt ? 0.5 * left : dt; // no sliver is left over
}

Decision StepSizes::failed(std::string reason, double dt) {
  Decision decision;
  decision.cut = Cut::not_converged;
  decision.reason = std::move(reason);
  decision.failed = at_smallest(dt);
  shorten(dt, 0.5);
  patience_ = patience;
  return decision;
}

Decision StepSizes::judge(StepError const& error, std::optional<Event> const& unlocated, double dt) {
  Decision decision;
  decision.error = error;
  look_for_cut(unlocated, dt, decision);
  if (!decision.accepted() && at_smallest(dt)) {
    decision.cut = Cut::none;
    decision.at_floor = true;
  }
  if (decision.accepted())
    grow(decision, dt);
  return decision;
}

void StepSizes::look_for_cut(std::optional<Event> const& unlocated, double dt, Decision& decision) {
  auto const& error = decision.error;
  double const part = error.largest() / accuracy_.tolerance,
               change = error.beta_change / accuracy_.beta_change;
  if (change > 1 + rounding) {
    decision.cut = Cut::beta_change;
    decision.reason =
        fmt::format("beta would change by {:.3g}, more than {:g}", error.beta_change, accuracy_.beta_change);
    shorten(dt, safety / change);
  } else if (part > 1) {
    decision.cut = Cut::error;
    decision.reason = fmt::format("{}, more than {:g}", told(error), accuracy_.tolerance);
    shorten(dt, safety / std::sqrt(part));
  } else if (unlocated) {
    decision.cut = Cut::event;
    decision.reason = words(*unlocated, "") + " somewhere within";
    // the rates of old tell when, once; where they are wrong, halves of halves do
    once_ = std::max(retry_ ? 0.5 * dt : unlocated->after - 0.5 * accuracy_.events, deepest * dt);
    once_ = std::max(rung(once_), smallest_);
    retry_ = true;
  }
}

std::string StepSizes::told(StepError const& error) const {
  return fmt::format("the local error of {} is {:.2e}", error.bond > error.displacement ? "beta" : "u",
                     error.largest());
}

void StepSizes::shorten(double dt, double factor) {
  wanted_ = std::max(rung(dt * std::clamp(factor, deepest, safety)), smallest_);
  retry_ = true;
}

/// The step that would just meet the tolerance, from an error of u that goes with dt^3 and one of beta with
/// dt^2. Small changes are left out: they would cost a factorization each. (An integral term beside such a
/// dead band holds the error at a tenth of the tolerance.) A step that was shorter than wanted may lengthen
/// the wanted one only.
void StepSizes::grow(Decision& decision, double dt) {
  double const least = 1e-4, u = std::max(decision.error.displacement / accuracy_.tolerance, least),
               bond = std::max(decision.error.bond / accuracy_.tolerance, least);
  double factor = safety * std::min(1 / std::cbrt(u), 1 / std::sqrt(bond));
  if (decision.error.beta_change > 0)
    factor = std::min(factor, safety * accuracy_.beta_change / decision.error.beta_change);
  if (retry_ || patience_ > 0)
    factor = std::min(factor, 1.0);
  patience_ = std::max(patience_ - 1, 0);
  factor = std::clamp(factor, deepest, fastest);
  double const before = wanted_;
  if (factor > worthwhile)
    wanted_ = std::clamp(rung(dt * factor), wanted_, largest_);
  else if (factor < needless)
    wanted_ = std::max(std::min(wanted_, rung(dt * factor)), smallest_);
  decision.grown = wanted_ > before;
  if (decision.grown && decision.reason.empty())
    decision.reason = decision.error.largest() > 0
                          ? fmt::format("{} of {:g}", told(decision.error), accuracy_.tolerance)
                          : "no error is seen";
  retry_ = false;
  once_ = no_bound;
}

} // namespace stiction::dynamics
