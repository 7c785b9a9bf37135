// Reading .msh files, with a look at their ends first: gmsh may accept or crash on half a file.
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gmsh.h>
#include <sstream>

#include "core/error.hpp"
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

} // namespace

void import_file(nlohmann::json const& request, std::string const& output) {
  auto const path = request.at("path").get<std::string>();
  std::ostringstream read;
  read << std::ifstream(path, std::ios::binary).rdbuf();
  auto content = read.str();
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // which gmsh does not read over
  bool const marked = content.starts_with(byte_order_mark);
  if (marked)
    content.erase(0, byte_order_mark.size());
  check_ends(content);
  if (marked) {
    auto const twin = output + ".msh";
    std::ofstream(twin, std::ios::binary) << content;
    gmsh::open(twin);
    std::filesystem::remove(twin);
  } else {
    gmsh::open(path);
  }
  std::vector<std::string> log;
  gmsh::logger::get(log);
  for (auto const& line : log)
    if (line.starts_with("Error"))
      throw core::InputError("gmsh says: " + line);
}

} // namespace stiction::mesher
