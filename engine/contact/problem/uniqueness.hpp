// Where theory promises no single answer to a contact problem, and the sentences that say so (physics.md 3).
#pragma once
#include <string>

#include "contact/problem/problem.hpp"

namespace stiction::contact {

/// Points with mu |W_nt| >= W_nn: each alone, all other forces held, has several answers or none. Where there
/// are none, those that press may have several together: W_nn + mu W_nt with each sliding as it is pushed has
/// a determinant below zero, and with forces that lean to one side there are other answers.
struct FrictionDoubt {
  Index points = 0;   ///< how many
  Index together = 0; ///< how many that only have several together
  Index worst = -1;   ///< the one with the largest mu |W_nt| / W_nn
  double mu = 0;
  double W_nn = 0, W_nt = 0; ///< of the worst, m/N; W_nt: length of (t1, t2)
  [[nodiscard]] bool any() const { return points + together > 0; }
};

/// Points whose force falls as they move on, faster than what it holds follows: they leap.
struct LeapDoubt {
  Index points = 0;     ///< how many leap alone: 1 / W <= fall, along the point's way
  Index worst = -1;     ///< the one with the largest W fall
  double stiffness = 0; ///< 1 / W of the worst, N/m
  bool held = false;    ///< W with what presses and what other bonds hold; else with all other forces held
  double fall = 0;      ///< of the worst, N/m
  double together =
      0; ///< largest eigenvalue of W fall over all points looked at; below 1 the answer is single
  [[nodiscard]] bool any() const { return together >= 1; }
};
/// Bonds that weaken with their opening, fall: A steepest_fall, or the most on the way of a step whose start
/// the problem knows; they snap.
struct SofteningDoubt : LeapDoubt {};
/// Friction that falls with the slip of a step, fall: p_n steepest_fall.
struct WeakeningDoubt : LeapDoubt {};

struct Doubts {
  FrictionDoubt friction;
  SofteningDoubt softening;
  WeakeningDoubt weakening;
  [[nodiscard]] bool any() const { return friction.any() || softening.any() || weakening.any(); }
};

/// Which points are looked at: those that press, or pull with 1 % of their law's strength; or all.
enum class Checked { bearing, all };

/// Did the step lose energy as bodies at rest do that snap?
enum class Snapped { unknown, yes };

/// force[dim n], x[dim n]: an answer, or what stands for one.
[[nodiscard]] Doubts doubts(Problem const& problem, Vector const& force, Vector const& x, Checked which,
                            Snapped snapped = Snapped::unknown);

/// A sentence without its place; only where there are such points.
[[nodiscard]] std::string words(FrictionDoubt const& doubt);
[[nodiscard]] std::string words(SofteningDoubt const& doubt);
[[nodiscard]] std::string words(WeakeningDoubt const& doubt);

} // namespace stiction::contact
