// Points that a step carried through their counterpart, farther than any contact was looked for.
#pragma once
#include <string>
#include <vector>

#include "contact/tunnelling/tunnelling.hpp"
#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

class Tunnelling {
public:
  /// The model must outlive it.
  explicit Tunnelling(Model const& model);
  /// Name of the pair of which a point out of contact went through its counterpart on the way from `old` to
  /// `next`; empty if none did.
  [[nodiscard]] std::string passed(State const& old, State const& next) const;

private:
  template<int D> [[nodiscard]] bool passed(std::size_t pair, State const& old, State const& next) const;
  template<int D>
  [[nodiscard]] bool passed_rigid(std::size_t pair, State const& old, State const& next) const;

  Model const* model_;
  std::vector<std::vector<contact::Panel<2>>> lines_;     ///< [pairs]; in the plane
  std::vector<std::vector<contact::Panel<3>>> triangles_; ///< [pairs]; in space
};

} // namespace stiction::dynamics
