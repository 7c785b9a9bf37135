// Meshes that gmsh makes or reads, as declarations that a script can write.
#pragma once
#include <string>
#include <vector>

#include "core/reader.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// One edge of an outline, from where the last one ended: straight, a circular arc or an interpolating
/// spline.
struct Edge {
  core::Numbers to;     ///< end {x, y}, m
  core::Numbers centre; ///< of an arc of less than half a turn {x, y}, m; empty for other edges
  core::Numbers
      through;      ///< points of a spline between its ends {x1, y1, x2, y2, ...}, m; empty for other edges
  std::string name; ///< the set it belongs to; several edges may share one; may be empty
  static core::Schema const& schema();
};

/// A closed curve: the last edge ends where the first one starts.
struct Outline {
  core::Numbers start; ///< {x, y}, m
  std::vector<Edge> edges;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// Smaller cells near a set: `size` up to the distance `within`, growing to the mesh's size at `until`.
struct Refinement {
  std::string near;  ///< name of edges
  double size = 0;   ///< m
  double within = 0; ///< m
  double until = 0;  ///< m
  static core::Schema const& schema();
};

/// A plane region by its outlines. Sets: the names of its edges (boundaries), "all" (nodes).
struct GmshGeometry {
  core::Numbers start; ///< first point of the outline {x, y}, m
  std::vector<Edge> edges;
  std::vector<Outline> holes;
  double size = 0; ///< cell size, m
  std::vector<Refinement> refine;
  core::Numbers sizes; ///< {x1, y1, size1, x2, ...}, m: cells there, growing from there by `growth` per metre
  double growth = 0.3; ///< of the cell size over the distance
  CellKind kind = CellKind::quad4;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// Size of the smallest cells that the mesher is asked for in this region, m.
[[nodiscard]] double smallest_size(GmshGeometry const& geometry);

/// A mesh file, solid where it has solid cells. Sets: of gmsh's .msh its physical groups by name (curves in
/// 2D and surfaces in 3D become boundaries, others node sets), of Abaqus' .inp its surfaces (boundaries),
/// node and element sets, of a grid of VTK NAME_VALUE of its arrays of whole numbers, of an .stl "surface"
/// and "face_1", ... between creases of 40 degrees; "all" (nodes). Sets of cells know their cells. Without
/// physical surfaces (2D) or volumes (3D) all cells are taken.
struct MshFile {
  std::string path;    ///< ends in .msh, .inp, .vtu, .vtk or .stl
  double scale = 1.0;  ///< length of the file's unit, m
  double size = 0;     ///< of the tetrahedra that fill an .stl, m; else 0
  bool scaled = false; ///< the script gives the scale
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// Throws InputError for outlines that are open, arcs off their circle, unknown names, and what gmsh refuses.
[[nodiscard]] Mesh gmsh_geometry(GmshGeometry const& geometry);

/// Throws InputError when the file is missing, truncated, a shell, of solid and surface cells without a
/// physical volume, or has cells of a kind we lack.
[[nodiscard]] Mesh msh_file(MshFile const& file);

} // namespace stiction::mesh
