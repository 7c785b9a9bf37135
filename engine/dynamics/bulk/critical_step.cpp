// Largest eigenvalue of M^-1 K, cell by cell; no global matrix.
#include "dynamics/bulk/critical_step.hpp"

#include <fmt/format.h>
#include <limits>

#include "dynamics/bulk/springs.hpp"
#include "dynamics/bulk/surface_loads.hpp"
#include "dynamics/model/mass.hpp"
#include "linear/decompositions.hpp"

namespace stiction::dynamics {

namespace {

/// Free degrees of freedom of one cell, numbered within the cell, and the root of their lumped mass.
struct FreeCell {
  std::vector<Eigen::Index> dofs;
  Vector root_mass; ///< [dofs], kg^1/2
};

/// Rows and columns of the free unknowns, scaled by mass. `lower`: the cell's lower triangle, row by row.
double largest_eigenvalue(FreeCell const& cell, double const* lower) {
  auto const n = static_cast<Eigen::Index>(cell.dofs.size());
  if (n == 0)
    return 0;
  Dense scaled = Dense::Zero(n, n);
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = 0; b <= a; ++b) {
      Eigen::Index const i = cell.dofs[static_cast<std::size_t>(a)],
                         j = cell.dofs[static_cast<std::size_t>(b)];
      scaled(a, b) = lower[i * (i + 1) / 2 + j] / (cell.root_mass[a] * cell.root_mass[b]);
    }
  return Eigen::SelfAdjointEigenSolver<Dense>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[n - 1];
}

std::vector<bool> driven_dofs(Model const& model) {
  std::vector<bool> driven(ix(model.dofs()), false);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driven[ix(model.dim() * node + motion.component)] = true;
  return driven;
}

std::vector<FreeCell> free_cells(Model const& model, std::size_t body, std::vector<bool> const& driven) {
  std::vector<FreeCell> cells;
  int const dim = model.dim();
  model.cells[body].each_mass([&](std::span<Index const> nodes, Dense const& consistent) {
    Vector const mass = lumped(consistent);
    auto& cell = cells.emplace_back();
    std::vector<double> roots;
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (int c = 0; c < dim; ++c)
        if (!driven[ix(dim * (model.first_node[body] + nodes[a]) + c)]) {
          cell.dofs.push_back(dim * static_cast<Eigen::Index>(a) + c);
          roots.push_back(std::sqrt(mass[static_cast<Eigen::Index>(a)]));
        }
    cell.root_mass = Eigen::Map<Vector const>(roots.data(), static_cast<Eigen::Index>(roots.size()));
  });
  return cells;
}

/// Largest eigenvalue that springs and loads add, at most.
double load_eigenvalue(Model const& model, Vector const& u, double t) {
  Springs const springs(model);
  SurfaceLoads const loads(model);
  if (springs.empty() && loads.empty())
    return 0;
  std::vector<bool> const everywhere(ix(model.node_count()), true);
  Vector inverse =
      assemble_mass(model, everywhere, ContactInertia::implicit).diagonal().unaryExpr([](double m) {
        return m > 0 ? 1 / m : 0.0;
      });
  auto const driven = driven_dofs(model);
  for (Index dof = 0; dof < model.dofs(); ++dof)
    if (driven[ix(dof)])
      inverse[dof] = 0;
  return springs.stiffest(u, t, inverse) + (loads.empty() ? 0 : loads.stiffest(u, t, inverse));
}

/// Each cell's lower triangle, one after the other.
std::vector<double> cell_stiffnesses(Model const& model, std::size_t body, Vector const& u,
                                     Memory const* memory) {
  std::size_t entries = 0;
  auto const dim = ix(model.dim());
  model.cells[body].each_cell(
      [&](std::span<Index const> nodes) { entries += dim * nodes.size() * (dim * nodes.size() + 1) / 2; });
  solid::ScatterMap apart(entries);
  for (std::size_t k = 0; k < entries; ++k)
    apart[k] = static_cast<Index>(k);
  std::vector<double> values(entries, 0.0);
  auto const first = dim * ix(model.first_node[body]), end = dim * ix(model.first_node[body + 1]);
  auto const& cells = model.cells[body];
  auto const networks = cells.relaxing() ? cells.networks(memory_of(memory, body), 0) : solid::Networks{};
  cells.add_stiffness({u.data() + first, end - first}, 1, apart, values,
                      networks.empty() ? nullptr : &networks);
  return values;
}

} // namespace

double critical_step(Model const& model, Vector const& u, double t, Memory const* memory) {
  auto const driven = driven_dofs(model);
  double largest = 0;
  for (std::size_t body = 0; body < model.cells.size(); ++body) {
    auto const stiffness = cell_stiffnesses(model, body, u, memory);
    auto const cells = free_cells(model, body, driven);
    std::size_t k = 0, at = 0;
    model.cells[body].each_cell([&](std::span<Index const> nodes) {
      largest = std::max(largest, largest_eigenvalue(cells[k++], &stiffness[at]));
      std::size_t const n = ix(model.dim()) * nodes.size();
      at += n * (n + 1) / 2;
    });
  }
  largest += load_eigenvalue(model, u, t);
  return largest > 0 ? 2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

std::string above_critical(double dt, double limit) {
  return fmt::format("dt = {:.4g} s is above the stability limit {:.4g} s of central differences", dt, limit);
}

} // namespace stiction::dynamics
