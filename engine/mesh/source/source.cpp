// Dispatch over the ways to get a mesh.
#include "mesh/source/source.hpp"

namespace stiction::mesh {

namespace {

template<class... Options>
std::vector<core::Schema> schemas_of(std::type_identity<std::variant<Options...>> /*generators*/) {
  return {Options::schema()...};
}

} // namespace

Mesh make(Generator const& generator) {
  struct {
    Mesh operator()(BlockOptions const& options) const { return block(options); }
    Mesh operator()(HalfDiscOptions const& options) const { return half_disc(options); }
    Mesh operator()(GradedBlockOptions const& options) const { return graded_block(options); }
    Mesh operator()(QuarterDiscOptions const& options) const { return quarter_disc(options); }
    Mesh operator()(BoxOptions const& options) const { return box(options); }
    Mesh operator()(QuarterCylinderOptions const& options) const { return quarter_cylinder(options); }
    Mesh operator()(HalfBallOptions const& options) const { return half_ball(options); }
    Mesh operator()(GmshGeometry const& geometry) const { return gmsh_geometry(geometry); }
    Mesh operator()(GmshSolid const& solid) const { return gmsh_solid(solid); }
    Mesh operator()(MshFile const& file) const { return msh_file(file); }
  } dispatch;
  return std::visit(dispatch, generator);
}

std::vector<core::Schema> generator_schemas() {
  return schemas_of(std::type_identity<Generator>{});
}

} // namespace stiction::mesh
