// Numbering, mass with or without inertia on contact nodes, and the effective stiffness.
#include "dynamics/bulk/bulk_system.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/threads.hpp"
#include "dynamics/bulk/bulk_choice.hpp"
#include "dynamics/bulk/timer.hpp"
#include "linear/multigrid_factor.hpp"
#include "linear/rank_factor.hpp"

namespace stiction::dynamics {

namespace {

/// Of the grip, in the matrix alone where bonds hold a body: without it the bodies have no factor, and with
/// it Newton's method still ends in the balance that has none.
constexpr double steady = 1e-8;
constexpr Index few_cells = 256; // that one thread does best

/// Lumps the mass of all nodes as that of contact nodes.
std::vector<bool> everywhere(Model const& model) {
  return std::vector<bool>(ix(model.node_count()), true);
}

/// Order of the unknowns with those marked at the end and nothing else changed.
Indices surface_last(std::vector<bool> const& last) {
  Indices order;
  for (bool const marked : {false, true})
    for (std::size_t k = 0; k < last.size(); ++k)
      if (last[k] == marked)
        order.push_back(static_cast<Index>(k));
  return order;
}

/// Calls visit(body, degrees of freedom of a cell) for the cells that are assembled here, in that order.
template<class Visit> void each_cell_dofs(Model const& model, Visit&& visit) {
  Indices dofs;
  int const dim = model.dim();
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    model.cells[body].each_part([&](std::span<Index const> nodes) {
      dofs.clear();
      for (Index const node : nodes)
        for (int i = 0; i < dim; ++i)
          dofs.push_back(dim * (model.first_node[body] + node) + i);
      visit(body, dofs);
    });
}

/// Largest distance of a cell's nodes from its first, m.
double largest_cell(Model const& model) {
  double largest = 0;
  for (std::size_t body = 0; body < model.cells.size(); ++body)
    model.cells[body].each_cell([&](std::span<Index const> cell) {
      auto const position = [&](Index node) { return model.reference.row(model.first_node[body] + node); };
      for (Index const node : cell)
        largest = std::max(largest, (position(node) - position(cell.front())).norm());
    });
  return largest;
}

} // namespace

BulkSystem::BulkSystem(Model const& model, StepWeights const& weights, Purpose purpose)
    : BulkSystem(model, weights, purpose == Purpose::steps ? Matrix::own : Matrix::none, nullptr) {}

BulkSystem::BulkSystem(Model const& model, StepWeights const& weights, BulkSystem const& lead)
    : BulkSystem(model, weights, Matrix::of_another, &lead) {}

BulkSystem::BulkSystem(Model const& model, StepWeights const& weights, Matrix matrix, BulkSystem const* lead)
    : model_(&model), dim_(model.dim()), diagonal_(weights.explicit_forces), springs_(model),
      surface_loads_(model), links_(model) {
  on_surface_ = contact_nodes(model);
  for (auto const& cells : model.cells) {
    damped_ = damped_ || (weights.inertia && cells.damped());
    relaxing_ = relaxing_ || cells.relaxing();
  }
  damped_ = damped_ || (weights.inertia && springs_.damped());
  own_rates_ = damped_ && weights.surface_apart() && weights.rate != 1;
  if (matrix == Matrix::own)
    make_matrix(model, weights);
  else if (lead != nullptr)
    number_as(*lead);
  if (matrix == Matrix::of_another && weights.skin) {
    skin_more_ = 1 - weights.xi;
    skin_.emplace(model, on_surface_);
  }
  mass_.dead_load.setZero(model.dofs());
  bool const loaded = !model.gravity.isZero(0) || std::any_of(model.rigids.begin(), model.rigids.end(),
                                                              [](auto const& rigid) { return rigid.free(); });
  if (weights.inertia || loaded)
    mass_ = weights.explicit_forces ? assemble_mass(model, everywhere(model), ContactInertia::implicit)
                                    : assemble_mass(model, on_surface_, weights.contact_inertia);
  if (matrix == Matrix::none)
    return;
  if (weights.inertia && matrix == Matrix::own)
    set_mass(weights);
  grip_in_matrix_ = model.held_by_bonds ? steady : 0;
  if (grip_in_matrix_ > 0 || weights.stabilisation > 0)
    gather_grip(model);
  linear_bodies_ = springs_.linear() && surface_loads_.empty() &&
                   std::all_of(model.bodies.begin(), model.bodies.end(),
                               [](auto const& body) { return solid::linear(*body); });
  linear_ = diagonal_ || linear_bodies_;
  cell_size_ = largest_cell(model);
  arms_ = arms(model);
}

void BulkSystem::make_matrix(Model const& model, StepWeights const& weights) {
  number_unknowns(model);
  if (!diagonal_)
    build_maps(model);
  if (!weights.skin)
    return;
  skin_more_ = 1 - weights.xi;
  skin_.emplace(model, on_surface_);
  skin_->map_entries(kept_.front().factor->pattern(), unknown_of_);
}

void BulkSystem::number_unknowns(Model const& model) {
  Index const dofs = model.dofs();
  std::vector<bool> driven(ix(dofs), false);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driven[ix(dim_ * node + motion.component)] = true;
  std::vector<bool> touched(ix(dofs));
  for (Index dof = 0; dof < dofs; ++dof)
    touched[ix(dof)] = on_surface_[ix(dof / dim_)];
  for (auto const& link : model.links) {
    driven[ix(link.dof)] = true;
    for (auto const& [master, weight] : link.masters)
      touched[ix(master)] = touched[ix(master)] || touched[ix(link.dof)];
  }
  Indices free;
  std::vector<bool> last;
  unknown_of_.assign(ix(dofs), -1);
  for (Index dof = 0; dof < dofs; ++dof) {
    if (driven[ix(dof)])
      continue;
    unknown_of_[ix(dof)] = static_cast<Index>(free.size());
    free.push_back(dof);
    last.push_back(touched[ix(dof)]);
    trailing_ += touched[ix(dof)] ? 1 : 0;
  }
  links_.number(unknown_of_);
  auto cliques = [&] {
    std::vector<Indices> all;
    if (diagonal_)
      return all;
    each_cell_dofs(model, [&](std::size_t, Indices const& cell) {
      all.emplace_back();
      for (Index const dof : cell)
        all.back().push_back(unknown_of_[ix(dof)]);
    });
    springs_.add_cliques(unknown_of_, all);
    surface_loads_.add_cliques(unknown_of_, all);
    for (auto& clique : all)
      links_.expand(unknown_of_, clique);
    return all;
  };
  auto const count = static_cast<Index>(free.size());
  bool const iterative = !diagonal_ && by_multigrid(model);
  auto const order =
      iterative ? surface_last(last) : linear::elimination_order(linear::pattern_of(count, cliques()), last);
  for (Index k = 0; k < count; ++k) {
    dof_of_.push_back(free[ix(order[ix(k)])]);
    unknown_of_[ix(dof_of_.back())] = k;
  }
  auto pattern = linear::pattern_of(count, cliques());
  values_.resize(pattern.rows.size());
  own_rates_ = own_rates_ && trailing_ > 0;
  if (model.share)
    kept_.emplace_back().factor = linear::make_rank_factor(std::move(pattern), trailing_,
                                                           unknowns_of_ranks(model), *model.share->ranks);
  else if (iterative)
    kept_.emplace_back().factor =
        linear::make_multigrid_factor(std::move(pattern), trailing_, nodes_of_unknowns(model));
  else
    kept_.emplace_back().factor = linear::make_bulk_factor(std::move(pattern), trailing_, own_rates_);
}

namespace {
/// A cell's place among the unknowns of its body and in the map of its body.
struct CellPlace {
  std::size_t first, count, entry;
};

/// Where the entries of a cell's lower triangle are, row by row.
template<class Place> void add_places(Places const& places, std::span<Index const> unknowns, Place* at) {
  for (std::size_t i = 0; i < unknowns.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      *at++ = places(unknowns[i], unknowns[j]);
}

/// Fills the map of one body, its cells shared among the threads.
void fill_map(Places const& places, std::vector<CellPlace> const& cells, Indices const& unknowns,
              solid::ScatterMap& map) {
  core::each_piece(static_cast<Index>(cells.size()), few_cells, [&](Index from, Index to) {
    for (Index c = from; c < to; ++c) {
      auto const [first, count, entry] = cells[ix(c)];
      add_places(places, {&unknowns[first], count}, &map[entry]);
    }
  });
}
} // namespace

void BulkSystem::build_maps(Model const& model) {
  std::vector<Indices> unknowns(model.cells.size());
  std::vector<std::vector<CellPlace>> cells(model.cells.size());
  std::vector<std::size_t> entries(model.cells.size(), 0);
  each_cell_dofs(model, [&](std::size_t body, Indices const& cell) {
    cells[body].push_back({unknowns[body].size(), cell.size(), entries[body]});
    entries[body] += cell.size() * (cell.size() + 1) / 2;
    for (Index const dof : cell)
      unknowns[body].push_back(unknown_of(dof));
    links_.add_slots(std::span(unknowns[body]).last(cell.size()));
  });
  auto const add_slots = [&](Indices const& dofs) {
    Indices numbers;
    numbers.reserve(dofs.size());
    for (Index const dof : dofs)
      numbers.push_back(unknown_of(dof));
    links_.add_slots(numbers);
  };
  if (!links_.empty()) {
    springs_.each_block(add_slots);
    std::ranges::for_each(surface_loads_.facets(), add_slots);
    std::ranges::for_each(surface_loads_.walls(), add_slots);
  }
  auto const& pattern = kept_.front().factor->pattern();
  links_.settle(pattern, unknown_of_);
  values_.resize(pattern.rows.size() + links_.slots());
  Places const places{pattern, links_};
  maps_.resize(model.cells.size());
  for (std::size_t body = 0; body < maps_.size(); ++body) {
    maps_[body].resize(entries[body]);
    fill_map(places, cells[body], unknowns[body], maps_[body]);
  }
  springs_.map_entries(
      [&](Index first, Index second) { return places(unknown_of(first), unknown_of(second)); });
  surface_loads_.map_entries(places, unknown_of_);
}

/// An entry of M between two unknowns or followers.
void BulkSystem::add_mass(Index row, Index column, double value) {
  auto const& pattern = kept_.front().factor->pattern();
  if (row == -1 || column == -1 || (row != column && diagonal_))
    return;
  if (row < 0 || column < 0)
    links_.each_entry(pattern, unknown_of_, {row, column},
                      [&](Index at, double part) { mass_in_matrix_[ix(at)] += part * value; });
  else if (Index const at = pattern.find(row, column); at >= 0) // of others' nodes it need not be here
    mass_in_matrix_[ix(at)] += value;
}

/// Sets M in the pattern of the effective stiffness, in the proportion to 1 / (mass dt^2) that the balance
/// and the own balance of contact nodes ask for.
void BulkSystem::set_mass(StepWeights const& weights) {
  mass_in_matrix_.assign(kept_.front().factor->pattern().rows.size(), 0.0);
  for (Index j = 0; j < mass_.pattern.size(); ++j) {
    double const share =
        weights.surface_apart() && on_surface(j) ? weights.apart_factor() * weights.mass : 1.0;
    for (Index k = mass_.pattern.columns[ix(j)]; k < mass_.pattern.columns[ix(j) + 1]; ++k)
      for (int c = 0; c < dim_; ++c)
        add_mass(unknown_of(dim_ * mass_.pattern.rows[ix(k)] + c), unknown_of(dim_ * j + c),
                 share * mass_.values[ix(k)]);
  }
}

namespace {
/// Of a body; null where it has none.
solid::Networks const* of_body(std::vector<solid::Networks> const& networks, std::size_t body) {
  return networks.empty() || networks[body].empty() ? nullptr : &networks[body];
}
} // namespace

solid::Pass BulkSystem::internal_force(Vector const& u, Vector& force, Forces what) const {
  force.setZero(u.size());
  solid::Pass all;
  Index first_cell = 0;
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const first = ix(dim_ * model_->first_node[body]),
               count = ix(dim_ * model_->first_node[body + 1]) - first;
    auto const* networks = what == Forces::all ? of_body(networks_, body) : nullptr;
    auto const pass =
        model_->cells[body].add_force({u.data() + first, count}, {force.data() + first, count}, networks);
    if (!pass.sound()) {
      all.inverted_cell = first_cell + pass.inverted_cell;
      break;
    }
    all.energy += pass.energy;
    first_cell += model_->cells[body].count();
  }
  return model_->share ? together(all, force) : all;
}

void BulkSystem::skin_force(Vector const& u, Vector& force) const {
  skin_->internal_force(u, force);
  force *= skin_more_;
}

void BulkSystem::damping_force(Vector const& u, Vector const& v, Vector& force) const {
  force.setZero(u.size());
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const first = ix(dim_ * model_->first_node[body]),
               count = ix(dim_ * model_->first_node[body + 1]) - first;
    if (model_->cells[body].damped())
      static_cast<void>(model_->cells[body].add_damping({u.data() + first, count}, {v.data() + first, count},
                                                        {force.data() + first, count}));
  }
  if (model_->share)
    model_->share->gather(force, dim_);
}

namespace {
/// Of M, 1/s^2; without inertia of the grip, 1.
double mass_factor(StepWeights const& weights, double dt) {
  return weights.inertia ? 1 / (weights.mass * dt * dt) : weights.stabilisation / dt;
}
} // namespace

void BulkSystem::Kept::is_of(FactorSource from, StepWeights const& weights, bool relaxing) {
  source = std::move(from);
  made = wanted = false;
  xi = weights.xi;
  mass = mass_factor(weights, source.dt);
  relaxed = relaxing ? source.dt : 0;
}

bool BulkSystem::Kept::is(StepWeights const& weights, double dt, bool relaxing) const {
  return source.u != nullptr && xi == weights.xi && mass == mass_factor(weights, dt) &&
         relaxed == (relaxing ? dt : 0);
}

bool BulkSystem::take_factor(StepWeights const& weights, double dt, Cost& cost) {
  auto const found =
      std::ranges::find_if(kept_, [&](Kept const& one) { return one.is(weights, dt, relaxing_); });
  if (found == kept_.end())
    return false;
  std::rotate(kept_.begin(), found, found + 1);
  return kept_.front().made || make(weights, cost);
}

/// Memory for a factor, what it holds is of no use.
std::unique_ptr<linear::BulkFactor> BulkSystem::spare() {
  if (spare_.empty()) {
    auto const& any = *std::ranges::find_if(kept_, [](Kept const& one) { return one.factor != nullptr; });
    return any.factor->another();
  }
  auto last = std::move(spare_.back());
  spare_.pop_back();
  return last;
}

/// Puts first what may be overwritten by a factor from this source: one of the same coefficients, one that is
/// empty or new, or the one used longest ago.
void BulkSystem::choose_factor(FactorSource source, StepWeights const& weights) {
  auto found = std::ranges::find_if(kept_, [&](Kept const& one) {
    return one.is(weights, source.dt, relaxing_) || one.source.u == nullptr;
  });
  if (found == kept_.end() && kept_.size() < kept_at_most_) {
    auto memory = spare();
    kept_.emplace_back().factor = std::move(memory);
    found = kept_.end() - 1;
  } else if (found == kept_.end()) {
    found = kept_.end() - 1;
  }
  if (found->wanted && found->made && kept_at_most_ > 1 && parked_.empty()) {
    auto memory = spare();
    parked_.push_back(std::move(*found));
    found->factor = std::move(memory);
  }
  std::rotate(kept_.begin(), found, found + 1);
  kept_.front().is_of(std::move(source), weights, relaxing_);
}

void BulkSystem::add_stiffness(FactorSource const& at, StepWeights const& weights, Cost& cost) {
  auto const& u = *at.u;
  bool const present = relaxing_ && at.dt == relax_dt_ && at.memory == memory_ && !networks_.empty();
  auto const made_again =
      relaxing_ && !present ? networks_of(at.memory.get(), at.dt) : std::vector<solid::Networks>{};
  auto const& networks = present ? networks_ : made_again;
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const first = ix(dim_ * model_->first_node[body]),
               count = ix(dim_ * model_->first_node[body + 1]) - first;
    model_->cells[body].add_stiffness({u.data() + first, count}, weights.xi, maps_[body], values_,
                                      of_body(networks, body));
  }
  if (skin_)
    skin_->add_stiffness(u, skin_more_, values_);
  springs_.add_stiffness(u, at.t, weights.xi, values_);
  if (!surface_loads_.empty())
    surface_loads_.add_stiffness(u, at.t, at.gas, weights.xi, values_);
  ++cost.stiffness_passes;
  double const viscous = weights.xi / (weights.rate * at.dt);
  if (damped_ && !own_rates_)
    add_damping(at, viscous, values_);
  if (!own_rates_)
    return;
  viscous_.assign(values_.size(), 0.0);
  add_damping(at, viscous, viscous_);
  for (std::size_t k = 0; k < values_.size(); ++k)
    values_[k] += viscous_[k];
  links_.fold(viscous_);
}

void BulkSystem::add_damping(FactorSource const& at, double factor, std::vector<double>& values) const {
  auto const& u = *at.u;
  for (std::size_t body = 0; body < model_->cells.size(); ++body) {
    auto const first = ix(dim_ * model_->first_node[body]),
               count = ix(dim_ * model_->first_node[body + 1]) - first;
    if (model_->cells[body].damped())
      model_->cells[body].add_damping_stiffness({u.data() + first, count}, factor, maps_[body], values);
  }
  springs_.add_damping_stiffness(u, at.t, factor, values);
}

/// The columns of contact unknowns in `share` times what A adds.
std::vector<linear::ColumnEntry> BulkSystem::own_columns(double share) const {
  auto const& pattern = kept_.front().factor->pattern();
  Index const first_contact = first_contact_unknown();
  std::vector<linear::ColumnEntry> entries;
  auto const add = [&](Index row, Index column, double value) {
    if (column >= first_contact && value != 0)
      entries.push_back({row, column - first_contact, share * value});
  };
  for (Index j = 0; j < unknowns(); ++j)
    for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k) {
      Index const i = pattern.rows[ix(k)];
      add(i, j, viscous_[ix(k)]);
      if (i != j)
        add(j, i, viscous_[ix(k)]);
    }
  return entries;
}

bool BulkSystem::factorize(Vector const& u, StepWeights const& weights, double dt, Cost& cost,
                           LoadsAt const& at) {
  auto gas = at.gas.empty() ? Gases(model_->gases.size()) : at.gas;
  choose_factor(
      {std::make_shared<Vector const>(u), dt, at.t, std::move(gas), nullptr, linear_ ? nullptr : memory_},
      weights);
  return make(weights, cost);
}

/// The present factor from its source.
bool BulkSystem::make(StepWeights const& weights, Cost& cost) {
  auto& now = kept_.front();
  auto const& source = now.source;
  {
    Timer const timer(cost.assembly);
    if (weights.inertia)
      for (std::size_t k = 0; k < mass_in_matrix_.size(); ++k)
        values_[k] = now.mass * mass_in_matrix_[k];
    else
      std::fill(values_.begin(), values_.end(), 0.0);
    std::fill(values_.end() - static_cast<std::ptrdiff_t>(links_.slots()), values_.end(), 0.0);
    if (!diagonal_)
      add_stiffness(source, weights, cost);
    links_.fold(values_);
    for (Index j = 0; j < (grip_.size() > 0 ? unknowns() : 0); ++j)
      values_[ix(factor().pattern().columns[ix(j)])] +=
          (grip_in_matrix_ + weights.stabilisation / source.dt) * grip_[dof_of(j)];
  }
  Timer const timer(cost.factorization);
  auto const& columns = now.factor->pattern().columns;
  now.scale = now.bodies = 0;
  for (Index j = 0; j < unknowns(); ++j) {
    if (!own(j))
      continue;
    auto const k = ix(columns[ix(j)]);
    double const arm = arms_.size() > 0 ? arms_[dof_of(j)] : 1;
    now.scale = std::max(now.scale, values_[k] / (arm * arm));
    now.bodies = std::max(now.bodies, values_[k] - (weights.inertia ? now.mass * mass_in_matrix_[k] : 0));
  }
  if (model_->share) {
    now.scale = model_->share->ranks->largest(now.scale);
    now.bodies = model_->share->ranks->largest(now.bodies);
  }
  auto apart = own_rates_ ? own_columns(weights.rate - 1) : std::vector<linear::ColumnEntry>{};
  now.made = now.factor->factorize(std::span(values_).first(columns.back()), std::move(apart),
                                   model_->held_by_bonds ? linear::Hold::always : linear::Hold::if_needed);
  now.factor->carry_on(source.carried.get());
  bool const held = now.factor->hold() > 0;
  cost.factorizations += held ? 2 : 1;
  cost.shifted_factorizations += held ? 1 : 0;
  if (!now.made)
    now.source = {};
  return now.made;
}

} // namespace stiction::dynamics
