// Bodies that motions turn as a whole, and where a step takes them.
#pragma once
#include <vector>

#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

class Carried {
public:
  /// None of a model with inertia, whose rates are a better guess, or of one whose bodies are bonded to each
  /// other.
  explicit Carried(Model const& model);
  /// Of bodies that nothing ties to others and whose driven nodes go from u [dofs] to time t1 as one
  /// rigid body that turns: its way for all of their nodes, put into d [dofs], m. Along the tangent they
  /// would be stretched.
  void guess(Vector const& u, double t1, Vector& d) const;

private:
  struct Body {
    Index first, last; ///< its nodes, the last one not
    Indices nodes;     ///< that motions drive: in all components, or the body is none of these
  };
  void add_body(Index first, Index last);

  Model const* model_;
  std::vector<Motion const*> driver_; ///< [degrees of freedom], null where free
  std::vector<Body> bodies_;          ///< with a motion that turns
};

} // namespace stiction::dynamics
