// Pressures and surface stresses, facet by facet.
#include "dynamics/bulk/surface_loads.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::dynamics {

namespace {

/// Adds a facet's [dim nodes] values at its nodes.
void add_at(mesh::Facet const& facet, double factor, Vector const& own, Vector& sum) {
  auto const dim = own.size() / static_cast<Eigen::Index>(facet.nodes.size());
  for (std::size_t i = 0; i < facet.nodes.size(); ++i)
    sum.segment(dim * facet.nodes[i], dim) += factor * own.segment(dim * static_cast<Eigen::Index>(i), dim);
}

constexpr double least_volume = 1e-9; ///< of a cavity that is pressed empty, of its first one

Indices dofs_of(Indices const& nodes, int dim) {
  Indices dofs;
  dofs.reserve(nodes.size() * static_cast<std::size_t>(dim));
  for (Index const node : nodes)
    for (int c = 0; c < dim; ++c)
      dofs.push_back(dim * node + c);
  return dofs;
}

/// Entries of the lower triangle over these degrees of freedom, row by row.
Indices entries_of(Places const& places, Indices const& dofs, Indices const& unknown_of) {
  Indices map;
  map.reserve(dofs.size() * (dofs.size() + 1) / 2);
  for (std::size_t i = 0; i < dofs.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      Index const row = unknown_of[ix(dofs[i])], column = unknown_of[ix(dofs[j])];
      map.push_back(places(row, column));
    }
  return map;
}

} // namespace

/// Present places of a facet's nodes, m.
Matrix SurfaceLoads::places(mesh::Facet const& facet, Vector const& u) const {
  int const dim = model_->dim();
  Matrix x(static_cast<Eigen::Index>(facet.nodes.size()), dim);
  for (std::size_t i = 0; i < facet.nodes.size(); ++i)
    x.row(static_cast<Eigen::Index>(i)) =
        model_->reference.row(facet.nodes[i]) + u.segment(dim * facet.nodes[i], dim).transpose();
  return x;
}

/// int N n da over a surface, m^2.
Vector SurfaceLoads::normals(std::vector<mesh::Facet> const& facets, Vector const& u) const {
  Vector sum = Vector::Zero(u.size());
  for (auto const& facet : facets)
    add_at(facet, 1,
           solid::facet_terms(model_->kinematics, places(facet, u), Point::Zero(), solid::FacetOrder::values)
               .normals,
           sum);
  return sum;
}

namespace {

Point centre_of(Gas const& gas, Vector const& u) {
  Point centre = gas.centre;
  for (auto const& [component, dof, part] : gas.carriers)
    centre[component] += part * u[dof];
  return centre;
}

} // namespace

/// Of one facet of a cavity's wall and what goes on from it to the seal.
solid::FacetTerms SurfaceLoads::wall_terms(Gas const& gas, std::size_t facet, Vector const& u,
                                           solid::FacetOrder order) const {
  Matrix const x = places(gas.facets[facet], u);
  Point const centre = centre_of(gas, u);
  auto terms = solid::facet_terms(model_->kinematics, x, centre, order);
  if (gas.seal)
    for (int const side : gas.seal->sides[facet])
      solid::add_skirt(model_->kinematics, x, side, {centre, gas.seal->normal}, terms);
  return terms;
}

/// int N n da over a cavity's wall, m^2: less how its volume grows.
Vector SurfaceLoads::wall_normals(Gas const& gas, Vector const& u) const {
  Vector sum = Vector::Zero(u.size());
  for (std::size_t k = 0; k < gas.facets.size(); ++k)
    add_at(gas.facets[k], 1, wall_terms(gas, k, u, solid::FacetOrder::values).normals, sum);
  return sum;
}

double SurfaceLoads::volume(Gas const& gas, Vector const& u) const {
  double sum = 0;
  for (std::size_t k = 0; k < gas.facets.size(); ++k)
    sum -= wall_terms(gas, k, u, solid::FacetOrder::values).volume;
  return sum;
}

/// V0^n over V^n.
double SurfaceLoads::thicker(Gas const& gas, Vector const& u) const {
  return std::pow(gas.volume / std::max(volume(gas, u), least_volume * gas.volume), gas.exponent);
}

Gases SurfaceLoads::gas_pressures(Vector const& u, double t, Gases const& known) const {
  Gases all = known;
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto const& gas = model_->gases[k];
    auto& [pressure, leaking, share] = all[k];
    double const P = gas.path.value(t);
    if (leaking)
      pressure = 0;
    else if (gas.by_volume)
      pressure += gas.stiffness * (gas.volume * P - volume(gas, u));
    else
      pressure = share * (P + gas.outside) * thicker(gas, u) - gas.outside;
    if (gas.seal)
      pressure = std::min(pressure, 0.0);
  }
  return all;
}

std::vector<double> SurfaceLoads::volumes(Vector const& u) const {
  std::vector<double> all;
  all.reserve(model_->gases.size());
  for (auto const& gas : model_->gases)
    all.push_back(volume(gas, u));
  return all;
}

Gases SurfaceLoads::balanced(Gases gas, std::vector<double> const& before,
                             std::vector<double> const& now) const {
  for (std::size_t k = 0; k < before.size(); ++k)
    if (model_->gases[k].by_volume)
      gas[k].pressure -= model_->gases[k].stiffness * (now[k] - before[k]);
  return gas;
}

double SurfaceLoads::rounding(Vector const& u) const {
  double most = 0;
  for (auto const& gas : model_->gases)
    if (gas.by_volume)
      most += 2e-16 * gas.stiffness * volume(gas, u) * wall_normals(gas, u).lpNorm<Eigen::Infinity>();
  return most;
}

Gases SurfaceLoads::leaked(Vector const& u, double t, Gases gas) const {
  int const dim = model_->dim();
  for (std::size_t k = 0; k < gas.size(); ++k) {
    auto const& one = model_->gases[k];
    if (!one.seal)
      continue;
    auto const off = [&](Index node) {
      Vector const x = model_->reference.row(node).transpose() + u.segment(dim * node, dim);
      return std::abs((x - one.centre.head(dim)).dot(one.seal->normal.head(dim)));
    };
    auto& [pressure, leaking, share] = gas[k];
    leaking = leaking ||
              std::ranges::any_of(one.seal->rim, [&](Index node) { return off(node) > one.seal->leaks_at; });
    double const amount = (one.path.value(t) + one.outside) * thicker(one, u);
    if (share * amount > one.outside)
      share = one.outside / amount;
  }
  return gas;
}

Gases SurfaceLoads::steady(Gases const& now, Gases const& known) const {
  auto all = now;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (model_->gases[k].by_volume)
      all[k] = known[k];
  return all;
}

void SurfaceLoads::add_pressures(Vector const& u, double t, Gases const& gas, Vector& force) const {
  for (auto const& pressure : model_->pressures)
    force -= pressure.path.value(t) * normals(pressure.facets, u);
  for (std::size_t k = 0; k < model_->gases.size(); ++k)
    force -= gas[k].pressure * wall_normals(model_->gases[k], u);
}

/// -dp/dV, Pa/m^3.
double SurfaceLoads::resistance(Gas const& gas, GasState const& now, double volume) const {
  if (now.leaking || (gas.seal && !(now.pressure < 0)))
    return 0;
  if (gas.by_volume)
    return gas.stiffness;
  return gas.exponent * (now.pressure + gas.outside) / std::max(volume, least_volume * gas.volume);
}

double SurfaceLoads::add_stresses(Vector const& u, Vector& force) const {
  double energy = 0;
  for (auto const& stress : model_->surface_stresses)
    for (auto const& facet : stress.facets) {
      auto const terms =
          solid::facet_terms(model_->kinematics, places(facet, u), Point::Zero(), solid::FacetOrder::first);
      energy += stress.gamma * terms.area;
      add_at(facet, stress.gamma, terms.area_by_x, force);
    }
  return energy;
}

/// Calls visit(facet, its part of the stiffness [dim nodes, dim nodes]).
template<class Visit>
void SurfaceLoads::each_stiffness(Vector const& u, double t, Gases const& gas, Visit const& visit) const {
  auto const terms = [&](mesh::Facet const& facet) {
    return solid::facet_terms(model_->kinematics, places(facet, u), Point::Zero(), solid::FacetOrder::second);
  };
  auto const press = [&](mesh::Facet const& facet, double p, Dense const& whole) {
    visit(facet, Dense((0.5 * p) * (whole + whole.transpose())));
  };
  for (auto const& pressure : model_->pressures)
    for (auto const& facet : pressure.facets)
      press(facet, pressure.path.value(t), terms(facet).normals_by_x);
  for (std::size_t k = 0; k < model_->gases.size(); ++k) {
    auto const& one = model_->gases[k];
    for (std::size_t i = 0; i < one.facets.size(); ++i)
      press(one.facets[i], gas[k].pressure, wall_terms(one, i, u, solid::FacetOrder::second).normals_by_x);
  }
  for (auto const& stress : model_->surface_stresses)
    for (auto const& facet : stress.facets)
      visit(facet, Dense(stress.gamma * terms(facet).area_by_x2));
}

std::vector<Indices> SurfaceLoads::facets() const {
  std::vector<Indices> all;
  auto const add = [&](std::vector<mesh::Facet> const& facets) {
    for (auto const& facet : facets)
      all.push_back(dofs_of(facet.nodes, model_->dim()));
  };
  for (auto const& pressure : model_->pressures)
    add(pressure.facets);
  for (auto const& gas : model_->gases)
    add(gas.facets);
  for (auto const& stress : model_->surface_stresses)
    add(stress.facets);
  return all;
}

std::vector<Indices> SurfaceLoads::walls() const {
  std::vector<Indices> all;
  all.reserve(model_->gases.size());
  for (auto const& gas : model_->gases)
    all.push_back(dofs_of(gas.nodes, model_->dim()));
  return all;
}

void SurfaceLoads::add_cliques(Indices const& unknown_of, std::vector<Indices>& cliques) const {
  for (auto& wall : walls()) {
    for (Index& dof : wall)
      dof = unknown_of[ix(dof)];
    cliques.push_back(std::move(wall));
  }
}

void SurfaceLoads::map_entries(Places const& places, Indices const& unknown_of) {
  for (auto const& facet : facets())
    maps_.push_back(entries_of(places, facet, unknown_of));
  for (auto const& wall : walls())
    walls_.push_back(entries_of(places, wall, unknown_of));
}

void SurfaceLoads::add_stiffness(Vector const& u, double t, Gases const& gas, double factor,
                                 std::span<double> values) const {
  auto map = maps_.begin();
  each_stiffness(u, t, gas, [&](mesh::Facet const&, Dense const& K) {
    auto at = map->begin();
    for (Eigen::Index i = 0; i < K.rows(); ++i)
      for (Eigen::Index j = 0; j <= i; ++j, ++at)
        if (*at >= 0)
          values[ix(*at)] += factor * K(i, j);
    ++map;
  });
  for (std::size_t k = 0; k < model_->gases.size(); ++k) {
    auto const& one = model_->gases[k];
    Vector const g = wall_normals(one, u);
    double const more = factor * resistance(one, gas[k], volume(one, u));
    auto const dofs = dofs_of(one.nodes, model_->dim());
    auto at = walls_[k].begin();
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j, ++at)
        if (*at >= 0)
          values[ix(*at)] += more * g[dofs[i]] * g[dofs[j]];
  }
}

/// By the sums over the rows of M^-1 K.
double SurfaceLoads::stiffest(Vector const& u, double t, Vector const& inverse_mass) const {
  Vector rows = Vector::Zero(u.size());
  auto const gas = gas_pressures(u, t, Gases(model_->gases.size()));
  each_stiffness(u, t, gas, [&](mesh::Facet const& facet, Dense const& K) {
    add_at(facet, 1, K.cwiseAbs().rowwise().sum(), rows);
  });
  for (std::size_t k = 0; k < model_->gases.size(); ++k) {
    Vector const g = wall_normals(model_->gases[k], u).cwiseAbs();
    rows += resistance(model_->gases[k], gas[k], volume(model_->gases[k], u)) * g.sum() * g;
  }
  return rows.cwiseProduct(inverse_mass).maxCoeff();
}

} // namespace stiction::dynamics
