// Reading mesh files; at .msh files with a look at their ends first: gmsh may accept or crash on half a file.
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <sstream>

#include "core/error.hpp"
#include "mesh/mesher/file_mesh.hpp"
#include "mesh/mesher/tasks.hpp"

namespace stiction::mesher {

namespace {

/// Mesh files are sections from $Name to $EndName (version 1: $NOD, $ENDNOD), binary ones too.
void check_ends(std::string const& content) {
  if (content.empty() || content.front() != '$')
    throw core::InputError("not a gmsh mesh file: it does not begin with $MeshFormat");
  std::size_t const last = content.find_last_not_of(" \t\r\n");
  std::size_t const line = content.rfind('\n', last) + 1;
  std::string tail = content.substr(line, last + 1 - line);
  for (char& c : tail)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (!tail.starts_with("$end"))
    throw core::InputError(
        fmt::format("the file is truncated: its last line, {} bytes in, does not close a section "
                    "($End...); write it anew",
                    line));
  bool const elements =
      content.find("$Elements") != std::string::npos || content.find("$ELM") != std::string::npos;
  if (!elements)
    throw core::InputError("the file has no cells (no $Elements section); it may be truncated");
}

void refuse_errors() {
  std::vector<std::string> log;
  gmsh::logger::get(log);
  for (auto const& line : log)
    if (line.starts_with("Error"))
      throw core::InputError("gmsh says: " + line);
}

/// gmsh reads past a byte order mark in no file.
void open_msh(std::string const& path, std::string content, std::string const& output) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  bool const marked = content.starts_with(byte_order_mark);
  if (marked)
    content.erase(0, byte_order_mark.size());
  check_ends(content);
  if (!marked)
    return gmsh::open(path);
  auto const twin = output + ".msh";
  std::ofstream(twin, std::ios::binary) << content;
  gmsh::open(twin);
  std::filesystem::remove(twin);
}

/// A closed surface of triangles becomes a volume of tetrahedra of one size.
void fill_stl(std::string const& path, double size) {
  gmsh::open(path);
  refuse_errors();
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  if (surfaces.empty())
    throw core::InputError("the file has no triangles");
  gmsh::model::mesh::removeDuplicateNodes();
  constexpr double crease = 40 * 3.14159265358979323846 / 180; // between triangles of one face
  gmsh::model::mesh::classifySurfaces(crease, true, true);
  gmsh::model::mesh::createGeometry();
  gmsh::model::getEntities(surfaces, 2);
  std::vector<int> tags;
  for (auto const& [dim, tag] : surfaces)
    tags.push_back(tag);
  gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop(tags)});
  gmsh::model::geo::synchronize();
  gmsh::option::setNumber("Mesh.MeshSizeMin", size);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
  gmsh::model::mesh::generate(3);
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  gmsh::model::setPhysicalName(3, gmsh::model::addPhysicalGroup(3, {volumes.at(0).second}), "all");
  for (std::size_t i = 0; i < tags.size(); ++i)
    gmsh::model::setPhysicalName(2, gmsh::model::addPhysicalGroup(2, {tags[i]}),
                                 fmt::format("face_{}", i + 1));
  gmsh::model::setPhysicalName(2, gmsh::model::addPhysicalGroup(2, tags), "surface");
}

} // namespace

void import_file(nlohmann::json const& request, std::string const& output) {
  auto const path = request.at("path").get<std::string>();
  std::ostringstream read;
  read << std::ifstream(path, std::ios::binary).rdbuf();
  auto const ends_in = [&path](char const* ending) { return path.ends_with(ending); };
  if (ends_in(".inp"))
    put_into_gmsh(parse_inp(read.str()));
  else if (ends_in(".vtk") || ends_in(".vtu"))
    put_into_gmsh(read_vtk(path));
  else if (ends_in(".stl"))
    fill_stl(path, request.at("size").get<double>());
  else
    open_msh(path, read.str(), output);
  refuse_errors();
}

} // namespace stiction::mesher
