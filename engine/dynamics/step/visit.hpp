// What a run consists of between two steps, field by field, to be written and read (record/archive.hpp). The
// names stand for all fields in their order: with one more a struct no longer compiles here.
#pragma once
#include "dynamics/bulk/bulk_system.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::contact {

template<class Archive> void visit(Archive& archive, Foot& foot) {
  auto& [segment, xi, eta, zeta] = foot;
  archive(segment, xi, eta, zeta);
}

} // namespace stiction::contact

namespace stiction::interface {

template<class Archive> void visit(Archive& archive, Bond& bond) {
  auto& [beta, stretch] = bond;
  archive(beta, stretch);
}

} // namespace stiction::interface

namespace stiction::linear {

template<class Archive> void visit(Archive& archive, Carried& carried) {
  auto& [columns, load, motion] = carried;
  archive(columns, load, motion);
}

} // namespace stiction::linear

namespace stiction::dynamics {

template<class Archive> void visit(Archive& archive, ContactState& point) {
  auto& [foot, gap, area, slip, path, dry, adhesion, tangent, bond, spin, status, in_reach, beneath, rate,
         second] = point;
  archive(foot, gap, area, slip, path, dry, adhesion, tangent, bond, spin, status, in_reach, beneath, rate,
          second);
}

template<class Archive> void visit(Archive& archive, RigidLoad& load) {
  auto& [force, moment] = load;
  archive(force, moment);
}

template<class Archive> void visit(Archive& archive, SchemeLoss& loss) {
  auto& [rates, averages, contact, turning] = loss;
  archive(rates, averages, contact, turning);
}

template<class Archive> void visit(Archive& archive, Ledger& ledger) {
  auto& [kinetic, strain, bond, potential, spring, surface, motion_work, load_work, damping_loss,
         dashpot_loss, relaxation_loss, stabilisation_loss, friction_loss, bonding_loss, start, predicted] =
      ledger;
  archive(kinetic, strain, bond, potential, spring, surface, motion_work, load_work, damping_loss,
          dashpot_loss, relaxation_loss, stabilisation_loss, friction_loss, bonding_loss, start, predicted);
}

template<class Archive> void visit(Archive& archive, GasState& gas) {
  auto& [pressure, leaking, share] = gas;
  archive(pressure, leaking, share);
}

template<class Archive> void visit(Archive& archive, FactorSource& source) {
  auto& [u, dt, t, gas, carried, memory] = source;
  archive(u, dt, t, gas, carried, memory);
}

template<class Archive> void visit(Archive& archive, Screw& screw) {
  auto& [linear, angular] = screw;
  archive(linear, angular);
}

template<class Archive> void visit(Archive& archive, PairScrew& pair) {
  auto& [secondary, primary] = pair;
  archive(secondary, primary);
}

template<class Archive> void visit(Archive& archive, Momenta& momenta) {
  auto& [bodies, pairs, start, loads, motions, springs, forces] = momenta;
  archive(bodies, pairs, start, loads, motions, springs, forces);
}

template<class Archive> void visit(Archive& archive, State& state) {
  auto& [t, onset, u, v, a, kick, internal, damping, reaction, own_reactions, drive, contacts, on_rigid,
         turned, gas, ledger, factors, critical_step, critical_age, momenta, memory] = state;
  archive(t, onset, u, v, a, kick, internal, damping, reaction, own_reactions, drive, contacts, on_rigid,
          turned, gas, ledger, factors, critical_step, critical_age, momenta, memory);
}

template<class Archive> void visit(Archive& archive, Cost& cost) {
  auto& [assembly, factorization, contact, solve, force_passes, stiffness_passes, factorizations,
         shifted_factorizations, solves, newton_iterations, contact_iterations, contact_problems, answered,
         contact_rounded, contact_operations, compliance_columns, compliance_operations] = cost;
  archive(assembly, factorization, contact, solve, force_passes, stiffness_passes, factorizations,
          shifted_factorizations, solves, newton_iterations, contact_iterations, contact_problems, answered,
          contact_rounded, contact_operations, compliance_columns, compliance_operations);
}

} // namespace stiction::dynamics
