// The keys of a field figure that place it in space: view, mirror, crop, sphere.
#pragma once
#include "core/reader.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// Fills view, mirror, crop and sphere; lengths in the spec are in units of `metres`.
void read_solid(core::Reader& reader, double metres, FieldSpec& field);

} // namespace stiction::postproc
