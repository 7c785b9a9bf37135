// Bodies in a viscous medium, from where they are to where they rest.
#pragma once
#include "contact/solvers/proximal.hpp"

namespace stiction::contact {

/// Implicit steps of a motion that a medium resists by c (x - x0), N, x0 where the last step ended, with less
/// and less of it:
///   x = free + W (p - c (x - x0)),  a problem with (1 + c W)^-1 W and (1 + c W)^-1 (free + c W x0).
/// Where it rests is an answer. The medium is stiffer than a bond that softens, so that each step has one,
/// and bonds snap one after the other. It begins where the problem's step does, or else with the forces of
/// the guess. answer: of problems on the way; polish: of this one.
[[nodiscard]] Solution come_to_rest(Problem const& problem, Vector const& guess, Answering const& answer,
                                    Answering const& polish);

} // namespace stiction::contact
