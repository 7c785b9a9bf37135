// Nodes of a primary that lie within the body of its secondary, between the points there, which do not see
// them.
#pragma once
#include "contact/tunnelling/tunnelling.hpp"
#include "dynamics/model/model.hpp"

namespace stiction::scene {

struct DugIn {
  Index node = -1;  ///< of the model; -1: none
  double depth = 0; ///< beneath the secondary's surface, straight between the corners of its facets, m
  double part = 0;  ///< the same over the size of a facet there
};

/// Looks for them in one pair of two bodies by node to segment; what the meshes say is made once.
class DigSearch {
public:
  /// model: must outlive it. Nothing is found in other pairs.
  DigSearch(dynamics::Model const& model, std::size_t pair);
  /// The deepest one, in parts of a facet, at the displacements u, [degrees of freedom]. Those that lie less
  /// than `least` of a facet deep do not count.
  [[nodiscard]] DugIn deepest(Vector const& u, double least) const;

private:
  template<int D>
  [[nodiscard]] DugIn deepest_in(std::vector<contact::Panel<D>> const& hull, Vector const& u,
                                 double least) const;
  dynamics::Model const* model_;
  std::size_t body_ = 0; ///< of the secondary
  Indices nodes_;        ///< of the primary; none: not such a pair
  std::vector<contact::Panel<2>> plane_;
  std::vector<contact::Panel<3>> space_; ///< of the body's boundary, by its own nodes
};

} // namespace stiction::scene
