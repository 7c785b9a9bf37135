// HDF5 files: meshes from the mesher, histories and saved contact problems, as texts of tree.hpp.
#include "contact/solvers/solver.hpp"
#include "core/error.hpp"
#include "fuzz/targets.hpp"
#include "fuzz/tree.hpp"
#include "mesh/files/mesh_file.hpp"
#include "mesh/topology/quality.hpp"
#include "record/law_text.hpp"
#include "record/problem_file.hpp"
#include "record/series.hpp"

namespace stiction::fuzz {

void mesh_file(std::string_view bytes) {
  auto const path = tree_file("mesh.h5", bytes);
  try {
    auto const mesh = mesh::read_mesh(path).mesh;
    mesh::check(mesh, "mesh");
    static_cast<void>(mesh::report(mesh, "mesh"));
    static_cast<void>(mesh::boundary(mesh));
  } catch (core::RunError const&) { // damaged
  } catch (core::InputError const&) {
  }
}

void series(std::string_view bytes) {
  auto const path = tree_file("series.h5", bytes);
  try {
    auto const data = record::read_series(path);
    for (auto const& [name, column] : data.columns)
      core::expect(column.values.size() == data.time.size() * column.width,
                   "a column has a row for every time");
  } catch (core::InputError const&) {
  }
}

void problem(std::string_view bytes) {
  auto const path = tree_file("problem.h5", bytes);
  try {
    auto const problem = record::load_problem(path);
    core::expect(problem.W.dense().allFinite() && problem.free.size() == problem.dim * problem.size(),
                 "sizes fit");
    static_cast<void>(record::text_of_laws(problem));
    if (problem.size() <= 4)
      static_cast<void>(
          contact::BipotentialNewton{}.make()->solve(problem, Vector::Zero(problem.free.size())));
  } catch (core::InputError const&) {
  }
}

} // namespace stiction::fuzz
