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

/// Bonds that weaken with their opening faster than what they hold follows: they snap.
struct SofteningDoubt {
  Index points = 0;     ///< how many snap alone, all other forces held: 1 / W_nn <= A fall
  Index worst = -1;     ///< the one with the largest W_nn A fall
  double stiffness = 0; ///< 1 / W_nn of the worst, N/m
  double fall = 0;      ///< A fall of the worst, N/m
  double together =
      0; ///< largest eigenvalue of W_nn A fall over all bonds looked at; below 1 the answer is single
  [[nodiscard]] bool any() const { return together >= 1; }
};

/// Friction that falls with the slip of a step, mu(|v_t|), faster than what it holds follows: points leap.
struct WeakeningDoubt {
  Index points = 0;     ///< how many leap alone, all other forces held: 1 / W_tt <= p_n fall of mu
  Index worst = -1;     ///< the one with the largest W_tt p_n fall
  double stiffness = 0; ///< 1 / W_tt of the worst along its friction, N/m
  double fall = 0;      ///< p_n fall of the worst, N/m
  double together = 0;  ///< as of bonds
  [[nodiscard]] bool any() const { return together >= 1; }
};

struct Doubts {
  FrictionDoubt friction;
  SofteningDoubt softening;
  WeakeningDoubt weakening;
  [[nodiscard]] bool any() const { return friction.any() || softening.any() || weakening.any(); }
};

/// Which points are looked at: those that press, or pull with 1 % of their law's strength; or all.
enum class Checked { bearing, all };

/// force[dim n], x[dim n]: an answer, or what stands for one.
[[nodiscard]] Doubts doubts(Problem const& problem, Vector const& force, Vector const& x, Checked which);

/// A sentence without its place; only where there are such points.
[[nodiscard]] std::string words(FrictionDoubt const& doubt);
[[nodiscard]] std::string words(SofteningDoubt const& doubt);
[[nodiscard]] std::string words(WeakeningDoubt const& doubt);

} // namespace stiction::contact
