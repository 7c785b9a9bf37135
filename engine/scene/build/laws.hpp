// Bulk laws of a body by sets of its cells.
#pragma once
#include <map>

#include "solid/body.hpp"

namespace stiction::scene {

/// Orders the body's cells into blocks of one kind and one law each; `laws` by the names of sets, empty:
/// nothing is done. Throws InputError with path "material" unless each cell is in one of the sets.
void give_laws(solid::Body& body, std::map<std::string, material::Material> const& laws);

} // namespace stiction::scene
