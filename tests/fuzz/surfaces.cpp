// Surface files: what is read has finite nodes and triangles of three of them.
#include "core/error.hpp"
#include "fuzz/scratch.hpp"
#include "fuzz/targets.hpp"
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

} // namespace stiction::fuzz
