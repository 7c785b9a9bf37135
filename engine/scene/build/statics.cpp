// Linear statics with the factor of a step without inertia.
#include "scene/build/statics.hpp"

#include <numbers>

namespace stiction::scene {

namespace {

dynamics::StepWeights still() {
  dynamics::StepWeights weights;
  weights.inertia = false;
  return weights;
}

/// Of every node, kg.
Vector lumped_mass(dynamics::Model const& model) {
  Vector mass = Vector::Zero(model.node_count());
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    model.cells[b].each_mass([&](std::span<Index const> nodes, Dense const& m) {
      for (std::size_t k = 0; k < nodes.size(); ++k)
        mass[model.first_node[b] + nodes[k]] += m.row(static_cast<Eigen::Index>(k)).sum();
    });
  return mass;
}

} // namespace

Statics::Statics(dynamics::Model const& model) : model_(&model), bulk_(model, still()) {
  dynamics::Cost cost;
  regular_ = bulk_.factorize(Vector::Zero(model.dofs()), still(), 1, cost) && bulk_.factor().hold() == 0;
}

Vector Statics::solve(Vector const& force) {
  Vector rhs(bulk_.unknowns()), gathered = force;
  bulk_.links().gather(gathered);
  for (Index k = 0; k < bulk_.unknowns(); ++k)
    rhs[k] = gathered[bulk_.dof_of(k)];
  bulk_.factor().solve(rhs);
  Vector u = Vector::Zero(force.size());
  for (Index k = 0; k < bulk_.unknowns(); ++k)
    u[bulk_.dof_of(k)] = rhs[k];
  bulk_.links().follow(u);
  return u;
}

double Statics::compliance(Indices const& nodes, contact::Vec3 const& direction) {
  Vector force = Vector::Zero(model_->dofs());
  bool const around = model_->kinematics == solid::Kinematics::axisymmetric;
  double sum = 0;
  for (Index const node : nodes) {
    double const share = around ? model_->reference(node, 0) : 1;
    sum += share;
    for (int c = 0; c < model_->dim(); ++c)
      force[model_->dim() * node + c] += share * direction[c];
  }
  return force.dot(solve(force)) / (sum * sum);
}

double Statics::period() {
  auto const mass = lumped_mass(*model_);
  double longest = 0;
  for (int c = 0; c < model_->dim(); ++c) {
    Vector load = Vector::Zero(model_->dofs());
    for (Index node = 0; node < model_->node_count(); ++node)
      load[model_->dim() * node + c] = mass[node];
    Vector const u = solve(load);
    double kinetic = 0;
    for (Index dof = 0; dof < u.size(); ++dof)
      kinetic += mass[dof / model_->dim()] * u[dof] * u[dof];
    double const strain = u.dot(load);
    if (strain > 0)
      longest = std::max(longest, 2 * std::numbers::pi * std::sqrt(kinetic / strain));
  }
  return longest;
}

} // namespace stiction::scene
