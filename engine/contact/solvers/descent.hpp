// Descent of the potential of a frictionless contact problem: it stays on the branch of its start.
#pragma once
#include <optional>

#include "contact/problem/problem.hpp"

namespace stiction::contact {

/// A gap within which a bond touches, over the least opening of a law: there it can only open, with the slope
/// on that side.
inline constexpr double touching = 1e-10;

/// May the problem have several answers of which a root finder takes any? No friction, and bonds that can
/// soften faster than everything else gives way.
[[nodiscard]] bool may_snap(Problem const& problem);

/// Does nothing rub?
[[nodiscard]] bool frictionless(Problem const& problem);

/// Do these forces carry a bonded point further from the problem's start than its law's opening, as an answer
/// on another branch does?
[[nodiscard]] bool leaps(Problem const& problem, Vector const& guess, Vector const& force);

struct Descended {
  Vector force;         ///< [dim n], N
  long iterations = 0;  ///< Newton iterations in x
  double work = 0;      ///< as of Solution
  bool settled = false; ///< at the minimum, not only on the way to it
};

/// Forces at the minimum of
///   1/2 (x - free)^T W^-1 (x - free) + sum of the bonds' energies, x_n >= shift_n,
/// reached downhill from the problem's start, or else from x = free + W guess, in steps that leap over no
/// bond's opening. Nothing where W is singular. The problem has no friction.
[[nodiscard]] std::optional<Descended> descend(Problem const& problem, Vector const& guess, long iterations);

/// The same with the friction of `force` [dim n] held: forces with which friction may begin anew. Nothing
/// where there are no bonds or no friction, or no descent.
[[nodiscard]] std::optional<Descended> descend_beside_friction(Problem const& problem, Vector const& force,
                                                               long iterations);

} // namespace stiction::contact
