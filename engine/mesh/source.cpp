// Dispatch over the ways to get a mesh.
#include "mesh/source.hpp"

namespace stiction::mesh {

Mesh make(Generator const& generator) {
  struct {
    Mesh operator()(BlockOptions const& options) const { return block(options); }
    Mesh operator()(HalfDiscOptions const& options) const { return half_disc(options); }
    Mesh operator()(GmshGeometry const& geometry) const { return gmsh_geometry(geometry); }
    Mesh operator()(MshFile const& file) const { return msh_file(file); }
  } dispatch;
  return std::visit(dispatch, generator);
}

std::vector<core::Schema> generator_schemas() {
  return {BlockOptions::schema(), HalfDiscOptions::schema(), GmshGeometry::schema(), MshFile::schema()};
}

} // namespace stiction::mesh
