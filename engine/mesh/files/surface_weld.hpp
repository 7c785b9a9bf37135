// What the readers of surface files share: reading words, refusing, welding vertices.
#pragma once
#include <array>
#include <istream>
#include <string>
#include <vector>

#include "mesh/files/surface_file.hpp"

namespace stiction::mesh {

using Triangle = std::array<Eigen::RowVector3d, 3>;
using Triangles = std::vector<Triangle>;

/// Throws InputError about the file.
[[noreturn]] void refuse_surface(std::string const& path, std::string const& words);

/// All bytes. Throws InputError when the file is missing or empty.
[[nodiscard]] std::string read_surface_file(std::string const& path);

/// Three numbers in words; "nan" and "inf" are read too, to be refused by name later. False when one is
/// missing.
bool read_vertex(std::istream& in, Eigen::RowVector3d& vertex);

/// The surface of the triangles, lengths times `scale`, as read_stl describes it.
[[nodiscard]] SurfaceMesh weld(Triangles const& triangles, double scale, std::string const& path);

} // namespace stiction::mesh
