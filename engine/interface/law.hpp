// The interface of one pair: friction and, where declared, adhesion.
#pragma once
#include <optional>

#include "interface/coulomb.hpp"
#include "interface/rcc.hpp"

namespace stiction::interface {

struct Law {
  std::optional<Coulomb> friction; ///< none: frictionless
  std::optional<Rcc> adhesion;     ///< none: dry contact, no bond state
  [[nodiscard]] double mu() const { return friction ? friction->mu : 0.0; }
};

} // namespace stiction::interface
