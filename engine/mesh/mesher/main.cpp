// stiction-mesher REQUEST OUTPUT: answers a JSON request ("-" is standard input) with an HDF5 mesh file.
#include <csignal>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <gmsh.h>
#include <iostream>
#include <new>
#include <sstream>
#include <sys/prctl.h>

#include "core/error.hpp"
#include "mesh/files/mesh_file.hpp"
#include "mesh/mesher/tasks.hpp"

namespace {

using namespace stiction;

std::string read_all(std::string const& name) {
  std::ostringstream text;
  if (name == "-")
    text << std::cin.rdbuf();
  else
    text << std::ifstream(name, std::ios::binary).rdbuf();
  return text.str();
}

/// gmsh, quiet and deterministic, for as long as the object lives.
struct Gmsh {
  Gmsh() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::logger::start();
  }
  ~Gmsh() { gmsh::finalize(); }
  Gmsh(Gmsh const&) = delete;
  Gmsh& operator=(Gmsh const&) = delete;
};

/// The errors and warnings that gmsh noted.
std::string gmsh_words() {
  std::vector<std::string> lines;
  gmsh::logger::get(lines);
  std::string words;
  for (auto const& line : lines)
    if (line.starts_with("Error") || line.starts_with("Warning"))
      words += (words.empty() ? "" : "; ") + line;
  return words;
}

constexpr char const* no_memory =
    "memory ran out while gmsh made the mesh: ask for fewer cells (a larger size)";

bool lacks_memory(std::exception_ptr const& error) {
  try {
    if (error)
      std::rethrow_exception(error);
  } catch (std::bad_alloc const&) {
    return true;
  } catch (...) {
    return false;
  }
  return false;
}

/// gmsh throws inside its parallel regions, out of which no exception can come: say what it noted and end.
[[noreturn]] void end_with_gmsh_words() {
  if (lacks_memory(std::current_exception())) {
    std::cerr << no_memory << std::endl;
    std::_Exit(1);
  }
  std::string const words = gmsh_words();
  std::cerr << "gmsh says: " << (words.empty() ? "it failed without a reason" : words) << std::endl;
  std::_Exit(2);
}

void answer(std::string const& request_text, std::string const& output) {
  auto const request = nlohmann::json::parse(request_text);
  auto const task = request.at("task").get<std::string>();
  if (task == "import")
    mesher::import_file(request, output);
  else if (task == "solid")
    mesher::build_solid(request);
  else
    mesher::build_geometry(request);
  mesh::write_mesh(output, mesher::extract(request.value("scale", 1.0)), request_text);
}

int guarded(std::string const& request, std::string const& output) {
  Gmsh const session;
  std::set_terminate(end_with_gmsh_words);
  try {
    answer(request, output);
    return 0;
  } catch (core::RunError const& error) {
    std::cerr << error.what() << '\n';
    return 1;
  } catch (core::InputError const& error) {
    std::cerr << error.what() << '\n';
  } catch (std::bad_alloc const&) {
    std::cerr << no_memory << '\n';
    return 1;
  } catch (std::exception const& error) {
    std::string const words = gmsh_words();
    std::cerr << "gmsh says: " << (words.empty() ? error.what() : words) << '\n';
  } catch (std::string const& error) { // gmsh before 4.9 throws its messages bare
    std::string const words = gmsh_words();
    std::cerr << "gmsh says: " << (words.empty() ? error : words) << '\n';
  }
  return 2;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: stiction-mesher REQUEST.json OUTPUT.h5   (REQUEST may be -)\n";
    return 2;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody would take the mesh
  return guarded(read_all(argv[1]), argv[2]);
}
