// Two blocks of different meshes, one on the other and tied, and whether stress is uniform in them.
#pragma once
#include <sstream>

#include "dynamics/space.hpp"
#include "mesh/own_cache.hpp"

namespace stiction::test {

inline Input traction(std::string set, std::vector<double> const& end) {
  auto load = make("load.traction", {{"set", text(std::move(set))}, {"times", values({0, 1}, "s")}});
  for (std::size_t c = 0; c < end.size(); ++c)
    at(load, std::string(1, "xyz"[c])) = values({0, end[c]}, "Pa");
  return load;
}

/// "lower" below height 0 with `below` cells across and "upper" with `above`; 1 m wide, 1 m high each.
/// Without motions and loads.
inline Input tied_blocks(std::string const& kinematics, std::string const& kind, Input const& material,
                         std::pair<int, int> cells) {
  bool const space = kinematics == "three_dimensional";
  auto table = make("scene");
  at(table, "kinematics") = text(kinematics);
  at(table, "scheme") = quasi_static();
  at(table, "schedule") = schedule({{1, 1}});
  for (auto const& [name, low, across] :
       {std::tuple{"lower", -1.0, cells.first}, std::tuple{"upper", 0.0, cells.second}}) {
    std::vector<double> origin(space ? 3 : 2, 0.0), size(origin.size(), 1.0), counts(origin.size(), across);
    origin.back() = low;
    counts.back() = 2;
    if (space)
      counts[1] = across - 1;
    auto mesh = make(space ? "mesh.box" : "mesh.block", {{"origin", values(origin, "m")},
                                                         {"size", values(size, "m")},
                                                         {"cells", values(counts)},
                                                         {"kind", text(kind)}});
    at(table, std::string("bodies.") + name) =
        make("body", {{"mesh", std::move(mesh)}, {"material", material}, {"density", value(1, "kg/m^3")}});
  }
  at(table, "constraints") = list({tied("upper.bottom", "lower.top")});
  return table;
}

/// Where the nodes of a regular grid of so many cells lie.
using Shape = std::function<Vec3(Vec3 const&)>;
struct Grid {
  std::array<int, 3> cells;
  bool tets = false;
};

/// A file of hexahedra, or of six tetrahedra in place of each, over the unit cube by `shape`; surfaces
/// "left", "right", "front", "back", "bottom", "top".
inline std::string grid_file(Grid const& grid, Shape const& shape) {
  auto const [nx, ny, nz] = grid.cells;
  auto const node = [&, nx = nx, ny = ny](int i, int j, int k) {
    return 1 + i + (nx + 1) * (j + (ny + 1) * k);
  };
  std::ostringstream nodes, cells;
  nodes.precision(17);
  int count = 0;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        Vec3 const x = shape(Vec3(1.0 * i / nx, 1.0 * j / ny, 1.0 * k / nz));
        nodes << node(i, j, k) << ' ' << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
      }
  auto const element = [&](int type, int group, std::vector<int> const& of) {
    cells << ++count << ' ' << type << " 2 " << group << ' ' << group;
    for (int const n : of)
      cells << ' ' << n;
    cells << '\n';
  };
  auto const facet = [&](int group, std::array<int, 4> const& n) {
    if (!grid.tets)
      return element(3, group, {n[0], n[1], n[2], n[3]});
    element(2, group, {n[0], n[1], n[2]});
    element(2, group, {n[0], n[2], n[3]});
  };
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        std::array<int, 8> const n{
            node(i, j, k),     node(i + 1, j, k),     node(i + 1, j + 1, k),     node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1)};
        if (!grid.tets)
          element(5, 7, {n.begin(), n.end()});
        for (auto const& [a, b] : {std::pair{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
          if (grid.tets) // about the diagonal from 0 to 6
            element(4, 7, {n[0], n[ix(a)], n[ix(b)], n[6]});
        if (i == 0)
          facet(1, {n[0], n[4], n[7], n[3]});
        if (i == nx - 1)
          facet(2, {n[6], n[5], n[1], n[2]});
        if (j == 0)
          facet(3, {n[0], n[1], n[5], n[4]});
        if (j == ny - 1)
          facet(4, {n[6], n[2], n[3], n[7]});
        if (k == 0)
          facet(5, {n[0], n[3], n[2], n[1]});
        if (k == nz - 1)
          facet(6, {n[6], n[7], n[4], n[5]});
      }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n7\n2 1 \"left\"\n2 2 \"right\"\n2 3 "
         "\"front\"\n2 4 \"back\"\n2 5 \"bottom\"\n2 6 \"top\"\n3 7 \"body\"\n$EndPhysicalNames\n$Nodes\n" +
         std::to_string((nx + 1) * (ny + 1) * (nz + 1)) + '\n' + nodes.str() + "$EndNodes\n$Elements\n" +
         std::to_string(count) + '\n' + cells.str() + "$EndElements\n";
}
inline Input file_body(std::string const& path, Input material) {
  return make("body", {{"mesh", make("mesh.msh_file", {{"path", text(path)}})},
                       {"material", std::move(material)},
                       {"density", value(1, "kg/m^3")}});
}

/// Stress at the nodes of all bodies, [nodes, components], Pa.
inline Matrix stresses(scene::Scene const& scene, State const& state) {
  auto const& model = *scene.model;
  int const dim = model.dim();
  Matrix all(model.first_node.back(), dim == 2 ? 4 : 6);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto const first = model.first_node[b], count = model.first_node[b + 1] - first;
    all.middleRows(first, count) =
        model.cells[b].stress({state.u.data() + dim * first, ix(dim * count)}).cauchy;
  }
  return all;
}
/// Farthest of them from the first node's, Pa.
inline double unevenness(Matrix const& stress) {
  return (stress.rowwise() - stress.row(0)).cwiseAbs().maxCoeff();
}

} // namespace stiction::test
