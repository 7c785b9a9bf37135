// Surface files: what is read has finite nodes and triangles of three of them, or finite heights in a
// rectangle.
#include <cmath>

#include "core/error.hpp"
#include "fuzz/scratch.hpp"
#include "fuzz/targets.hpp"
#include "halfspace/height_file.hpp"
#include "mesh/files/surface_file.hpp"

namespace stiction::fuzz {

namespace {

template<class Read> void read_surface(Read read, std::string const& path) {
  mesh::SurfaceMesh surface;
  try {
    surface = read(path, 1e-3);
  } catch (core::InputError const&) {
    return;
  }
  core::expect(surface.nodes.allFinite() && !surface.facets.empty(), "finite nodes, at least one facet");
  for (auto const& facet : surface.facets) {
    core::expect(facet.nodes.size() == 3 && facet.nodes[0] != facet.nodes[1], "a facet has three nodes");
    for (Index const node : facet.nodes)
      core::expect(node >= 0 && node < surface.nodes.rows(), "a facet's nodes are there");
  }
}

} // namespace

void stl(std::string_view bytes) {
  read_surface(mesh::read_stl, scratch_file("surface.stl", bytes));
}

void msh(std::string_view bytes) {
  read_surface(mesh::read_msh_triangles, scratch_file("surface.msh", bytes));
}

void heights(std::string_view bytes) {
  if (bytes.starts_with("\x89HDF"))
    return; // the library's own format
  halfspace::HeightFile file;
  try {
    file = halfspace::read_heights(scratch_file("heights", bytes));
  } catch (core::InputError const&) {
    return;
  }
  core::expect(file.nx > 0 && file.heights.size() == ix(file.nx) * ix(file.ny), "rows of as many heights");
  for (double const height : file.heights)
    core::expect(std::isfinite(height), "finite heights");
}

} // namespace stiction::fuzz
