// Numbering, mass with or without inertia on contact nodes, and the effective stiffness.
#include "dynamics/structure.hpp"

#include <algorithm>

#include "dynamics/timer.hpp"

namespace stiction::dynamics {

namespace {

/// Model nodes of every contact surface, secondary and primary.
std::vector<bool> contact_nodes(Model const& model) {
  std::vector<bool> touched(ix(model.node_count()), false);
  for (auto const& pair : model.pairs) {
    for (Index const node : pair.secondary)
      touched[ix(node)] = true;
    if (auto const* curve = std::get_if<contact::Curve>(&pair.primary))
      for (auto const& segment : curve->segments())
        for (int k = 0; k < segment.count; ++k)
          touched[ix(segment.nodes[ix(k)])] = true;
  }
  return touched;
}

/// Calls visit(body, degrees of freedom of a cell) in assembly order.
template<class Visit> void each_cell_dofs(Model const& model, Visit&& visit) {
  Indices dofs;
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    model.cells[body].each_cell([&](std::span<Index const> nodes) {
      dofs.clear();
      for (Index const node : nodes)
        for (int i = 0; i < 2; ++i)
          dofs.push_back(2 * (model.first_node[body] + node) + i);
      visit(body, dofs);
    });
}

} // namespace

Structure::Structure(Model const& model, StepWeights const& weights) : model_(&model) {
  massless_.assign(ix(model.node_count()), false);
  if (weights.inertia && weights.massless_contact)
    massless_ = contact_nodes(model);
  number_unknowns(model);
  build_maps(model);
  weight_.setZero(2 * model.node_count());
  if (weights.inertia || !model.gravity.isZero())
    assemble_mass(model);
  for (auto const& body : model.bodies)
    linear_ = linear_ && std::holds_alternative<material::LinearElastic>(body->material);
}

void Structure::number_unknowns(Model const& model) {
  Index const dofs = 2 * model.node_count();
  std::vector<bool> driven(ix(dofs), false);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driven[ix(2 * node + motion.component)] = true;
  auto const touched = contact_nodes(model);
  Indices free;
  std::vector<bool> last;
  unknown_of_.assign(ix(dofs), -1);
  for (Index dof = 0; dof < dofs; ++dof) {
    if (driven[ix(dof)])
      continue;
    unknown_of_[ix(dof)] = static_cast<Index>(free.size());
    free.push_back(dof);
    last.push_back(touched[ix(dof / 2)]);
    trailing_ += touched[ix(dof / 2)] ? 1 : 0;
  }
  auto cliques = [&] {
    std::vector<Indices> all;
    each_cell_dofs(model, [&](std::size_t, Indices const& cell) {
      all.emplace_back();
      for (Index const dof : cell)
        all.back().push_back(unknown_of_[ix(dof)]);
    });
    return all;
  };
  auto const count = static_cast<Index>(free.size());
  auto const order = linear::elimination_order(linear::pattern_of(count, cliques()), last);
  for (Index k = 0; k < count; ++k) {
    dof_of_.push_back(free[ix(order[ix(k)])]);
    unknown_of_[ix(dof_of_.back())] = k;
  }
  auto pattern = linear::pattern_of(count, cliques());
  values_.resize(pattern.rows.size());
  factor_ = std::make_unique<linear::Cholesky>(std::move(pattern), trailing_);
}

void Structure::build_maps(Model const& model) {
  maps_.resize(model.cells.size());
  auto const& pattern = factor_->pattern();
  each_cell_dofs(model, [&](std::size_t body, Indices const& cell) {
    for (std::size_t i = 0; i < cell.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        Index const row = unknown_of(cell[i]), column = unknown_of(cell[j]);
        maps_[body].push_back(row >= 0 && column >= 0 ? pattern.find(row, column) : -1);
      }
  });
}

void Structure::assemble_mass(Model const& model) {
  std::vector<Indices> cliques;
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    model.cells[body].each_cell([&](std::span<Index const> nodes) {
      cliques.emplace_back();
      for (Index const node : nodes)
        cliques.back().push_back(model.first_node[body] + node);
    });
  mass_pattern_ = linear::pattern_of(model.node_count(), cliques);
  mass_.assign(mass_pattern_.rows.size(), 0.0);

  for (std::size_t body = 0; body < model.cells.size(); ++body) {
    Index const first = model.first_node[body];
    double total = 0, kept = 0;
    std::vector<std::pair<Index, double>> entries; // of this body, to be scaled at the end
    model.cells[body].each_mass([&](std::span<Index const> nodes, Dense const& mass) {
      auto const n = static_cast<Eigen::Index>(nodes.size());
      auto light = [&](Eigen::Index a) { return massless_[ix(first + nodes[static_cast<std::size_t>(a)])]; };
      double const whole = mass.sum();
      double rest = 0; // what the nodes with inertia hold of this cell
      for (Eigen::Index a = 0; a < n; ++a)
        for (Eigen::Index b = 0; b < n; ++b)
          rest += light(a) || light(b) ? 0.0 : mass(a, b);
      double const scale = rest > 0 ? whole / rest : 0.0;
      total += whole;
      kept += scale * rest;
      for (Eigen::Index a = 0; a < n; ++a) {
        Index const i = first + nodes[static_cast<std::size_t>(a)];
        weight_.segment<2>(2 * i) += mass.row(a).sum() * model.gravity;
        for (Eigen::Index b = 0; b <= a; ++b)
          if (!light(a) && !light(b))
            entries.emplace_back(mass_pattern_.find(i, first + nodes[static_cast<std::size_t>(b)]),
                                 scale * mass(a, b));
      }
    });
    // cells all of whose nodes are in contact give their mass to the whole body
    for (auto const& [entry, value] : entries)
      mass_[ix(entry)] += value * (kept > 0 ? total / kept : 0.0);
  }

  auto const& pattern = factor_->pattern();
  mass_in_matrix_.assign(pattern.rows.size(), 0.0);
  for (Index j = 0; j < mass_pattern_.size(); ++j)
    for (Index k = mass_pattern_.columns[ix(j)]; k < mass_pattern_.columns[ix(j) + 1]; ++k)
      for (int c = 0; c < 2; ++c) {
        Index const row = unknown_of(2 * mass_pattern_.rows[ix(k)] + c), column = unknown_of(2 * j + c);
        if (row >= 0 && column >= 0)
          mass_in_matrix_[ix(pattern.find(row, column))] = mass_[ix(k)];
      }
}

solid::Pass Structure::internal_force(Vector const& u, Vector& force) const {
  force.setZero(u.size());
  solid::Pass all;
  Index first_cell = 0;
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const first = ix(2 * model_->first_node[body]), count = ix(2 * model_->first_node[body + 1]) - first;
    auto const pass = model_->cells[body].add_force({u.data() + first, count}, {force.data() + first, count});
    if (!pass.sound()) {
      all.inverted_cell = first_cell + pass.inverted_cell;
      return all;
    }
    all.energy += pass.energy;
    first_cell += model_->cells[body].count();
  }
  return all;
}

void Structure::mass_times(Vector const& x, Vector& y) const {
  y.setZero(x.size());
  for (Index j = 0; j < mass_pattern_.size(); ++j)
    for (Index k = mass_pattern_.columns[ix(j)]; k < mass_pattern_.columns[ix(j) + 1]; ++k) {
      Index const i = mass_pattern_.rows[ix(k)];
      double const m = mass_[ix(k)];
      y.segment<2>(2 * i) += m * x.segment<2>(2 * j);
      if (i != j)
        y.segment<2>(2 * j) += m * x.segment<2>(2 * i);
    }
}

namespace {
double mass_factor(StepWeights const& weights, double dt) {
  return weights.inertia ? 1 / (weights.theta * dt * dt) : 0.0;
}
} // namespace

bool Structure::has_factor(StepWeights const& weights, double dt) const {
  return factored_ && factored_xi_ == weights.xi && factored_mass_ == mass_factor(weights, dt);
}

bool Structure::factorize(Vector const& u, StepWeights const& weights, double dt, Cost& cost) {
  {
    Timer const timer(cost.assembly);
    double const inertia = mass_factor(weights, dt);
    if (weights.inertia)
      for (std::size_t k = 0; k < values_.size(); ++k)
        values_[k] = inertia * mass_in_matrix_[k];
    else
      std::fill(values_.begin(), values_.end(), 0.0);
    for (std::size_t body = 0; body < model_->cells.size(); ++body) {
      auto const first = ix(2 * model_->first_node[body]),
                 count = ix(2 * model_->first_node[body + 1]) - first;
      model_->cells[body].add_stiffness({u.data() + first, count}, weights.xi, maps_[body], values_);
    }
    auto const& columns = factor_->pattern().columns;
    stiffness_scale_ = 0;
    for (Index j = 0; j < unknowns(); ++j)
      stiffness_scale_ = std::max(stiffness_scale_, values_[ix(columns[ix(j)])]);
    factored_xi_ = weights.xi;
    factored_mass_ = inertia;
    ++cost.stiffness_passes;
  }
  Timer const timer(cost.factorization);
  ++cost.factorizations;
  return factored_ = factor_->factorize(values_);
}

} // namespace stiction::dynamics
