// Solids of the OpenCASCADE kernel, whole or cut to a quarter, with their faces named by where they lie.
#include <cmath>
#include <gmsh.h>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "mesh/mesher/tasks.hpp"

namespace stiction::mesher {

namespace {

using Json = nlohmann::json;
using std::numbers::pi;

/// What is asked for: a box, cylinder or half ball whose upper side lies at z = 0, or a ball about the
/// origin.
struct Solid {
  std::string shape;
  std::vector<double> extent; ///< box {x, y, z}, cylinder {radius, height}, balls {radius}
  bool quarter;
};

void add(Solid const& solid) {
  namespace occ = gmsh::model::occ;
  double const a = solid.extent[0], turn = solid.quarter ? pi / 2 : 2 * pi;
  if (solid.shape == "box") {
    double const b = solid.extent[1], c = solid.extent[2];
    if (solid.quarter)
      occ::addBox(0, 0, -c, a / 2, b / 2, c);
    else
      occ::addBox(-a / 2, -b / 2, -c, a, b, c);
  } else if (solid.shape == "cylinder")
    occ::addCylinder(0, 0, -solid.extent[1], 0, 0, solid.extent[1], a, -1, turn);
  else
    occ::addSphere(0, 0, 0, a, -1, -pi / 2, solid.shape == "half_ball" ? 0 : pi / 2, turn);
  occ::synchronize();
}

/// Least and greatest coordinates of a face along an axis.
struct Span {
  double low, high;
  /// Kernels give bounding boxes with a margin; faces are of a size near 1.
  [[nodiscard]] bool flat() const { return high - low < 1e-5; }
};

std::string name_of(Solid const& solid, std::array<Span, 3> const& face) {
  auto const& [x, y, z] = face;
  bool const box = solid.shape == "box", half = solid.shape == "half_ball";
  if (x.flat())
    return solid.quarter && std::abs(x.low) < 1e-5 ? "symmetry_x" : x.low < 0 ? "left" : "right";
  if (y.flat())
    return solid.quarter && std::abs(y.low) < 1e-5 ? "symmetry_y" : y.low < 0 ? "front" : "back";
  if (z.flat())
    return half ? "flat" : std::abs(z.low) < 1e-5 ? "top" : "bottom";
  core::expect(!box, "plane faces of a box");
  return solid.shape == "cylinder" ? "side" : "cap";
}

void name_faces(Solid const& solid) {
  gmsh::vectorpair faces;
  gmsh::model::getEntities(faces, 2);
  std::map<std::string, std::vector<int>> names;
  for (auto const& [dim, tag] : faces) {
    double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
    gmsh::model::getBoundingBox(dim, tag, x0, y0, z0, x1, y1, z1);
    names[name_of(solid, {{{x0, x1}, {y0, y1}, {z0, z1}}})].push_back(tag);
  }
  for (auto const& [name, tags] : names)
    gmsh::model::setPhysicalName(2, gmsh::model::addPhysicalGroup(2, tags), name);
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  core::expect(volumes.size() == 1, "one volume");
  gmsh::model::setPhysicalName(3, gmsh::model::addPhysicalGroup(3, {volumes[0].second}), "all");
}

/// One size, and a smaller one in a ball that goes over into it.
void set_sizes(Json const& request) {
  namespace field = gmsh::model::mesh::field;
  double const size = request.at("size").get<double>(), fine = request.at("fine_size").get<double>();
  auto const near = request.at("near").get<std::vector<double>>();
  int const ball = field::add("Ball");
  field::setNumber(ball, "VIn", fine);
  field::setNumber(ball, "VOut", size);
  field::setNumber(ball, "XCenter", near[0]);
  field::setNumber(ball, "YCenter", near[1]);
  field::setNumber(ball, "ZCenter", near[2]);
  field::setNumber(ball, "Radius", request.at("within").get<double>());
  field::setNumber(ball, "Thickness", request.at("until").get<double>() - request.at("within").get<double>());
  field::setAsBackgroundMesh(ball);
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
}

} // namespace

void build_solid(Json const& request) {
  gmsh::model::add("solid");
  Solid const solid{request.at("shape").get<std::string>(), request.at("extent").get<std::vector<double>>(),
                    request.at("quarter").get<bool>()};
  add(solid);
  name_faces(solid);
  set_sizes(request);
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::model::mesh::generate(3);
  if (request.at("kind") == "tet10")
    gmsh::model::mesh::setOrder(2);
}

} // namespace stiction::mesher
