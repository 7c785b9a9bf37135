// In place of vtk.cpp where VTK was not there when the mesher was built.
#include "core/error.hpp"
#include "mesh/mesher/file_mesh.hpp"

namespace stiction::mesher {

FileMesh read_vtk(std::string const& path) {
  throw core::InputError(
      path + ": this build reads no files of VTK; install libvtk9-dev and build anew, or save the "
             "mesh as .msh or .inp");
}

} // namespace stiction::mesher
