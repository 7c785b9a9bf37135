// All that must survive a step.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "contact/node_to_segment/kinematics.hpp"
#include "dynamics/model/momentum.hpp"
#include "interface/bond.hpp"
#include "linear/bulk_factor.hpp"

namespace stiction::dynamics {

/// One contact point at the end of a step.
struct ContactState {
  contact::Foot foot; ///< counterpart, the origin of the next step's slip
  double gap = 0;     ///< x_n, m; without counterpart the radius of the search
  double area = 0;    ///< reference area that its tractions act on, m^2 (m in plane strain)
  contact::Vec2 slip = contact::Vec2::Zero();     ///< increment of the last step, (t1, t2), m
  contact::Vec2 path = contact::Vec2::Zero();     ///< signed slip since the start, (t1, t2), m
  contact::Vec3 dry = contact::Vec3::Zero();      ///< rbar (n, t1, t2), Pa; t2 only in 3D
  contact::Vec3 adhesion = contact::Vec3::Zero(); ///< rtilde (n, t1, t2), Pa
  /// t1 on an obstacle in space, in the obstacle's frame: the next step's is its part along the surface
  /// there; zero: that of the pair's direction.
  contact::Vec3 tangent = contact::Vec3::Zero();
  interface::Bond bond;
  double spin = 0; ///< of the counterpart in the last step, by which the bond's stretch turned with it, rad
  interface::Status status = interface::Status::open;
  bool in_reach = false; ///< took part in the last step's contact problem
  bool beneath = false;  ///< came in past a border of the surface, and is not out yet
  /// Of gap and slip, (n, t1, t2), m/s, and with accelerations their own rate, m/s^2; kept where contact is
  /// at the velocity level.
  contact::Vec3 rate = contact::Vec3::Zero(), second = contact::Vec3::Zero();
};

/// What the contacts do to a rigid body: force, N, and moment about the origin, N m.
struct RigidLoad {
  contact::Vec3 force = contact::Vec3::Zero(), moment = contact::Vec3::Zero();
};

/// What the scheme's own formulas say it has lost (made, if negative) since the start, J. Found without the
/// balance of energies, so that the two may be held against each other; trapezia stand for exact works.
struct SchemeLoss {
  double rates = 0;    ///< d is not dt times the mean rate, and the balance not that of mean forces
  double averages = 0; ///< the mean internal force is not the trapezium's
  double contact = 0;  ///< pressure at the end of a step in which the gap closes, adhesion likewise
  double turning = 0;  ///< normals of the step's end work through d; zero on planes
  [[nodiscard]] double sum() const { return rates + averages + contact + turning; }
};

/// Cumulative energy account, J (J/m in plane strain); kinetic, strain and bond are present values.
struct Ledger {
  double kinetic = 0, strain = 0, bond = 0,
         potential = 0;          ///< potential: of gravity and of constant forces on rigid bodies
  double spring = 0;             ///< stored in springs, at present
  double surface = 0;            ///< of surface stresses, at present
  double motion_work = 0;        ///< done by driven nodes, moving obstacles and moving ends of springs
  double load_work = 0;          ///< done by prescribed forces
  double damping_loss = 0;       ///< dissipated by the bodies' viscosity
  double dashpot_loss = 0;       ///< dissipated by the dashpots of springs
  double relaxation_loss = 0;    ///< dissipated by the bodies' networks that relax
  double stabilisation_loss = 0; ///< dissipated by the stabilisation of quasi-statics
  double friction_loss = 0;      ///< dissipated by slip against rbar_t
  double bonding_loss = 0;       ///< by the bonds: int A b beta'^2 dt of RCC, the damage of cohesive laws
  double start = 0;              ///< kinetic + strain + bond + potential + spring + surface at t = 0
  /// What the scheme itself has lost (positive) or made.
  [[nodiscard]] double scheme_loss() const {
    return start + motion_work + load_work - (kinetic + strain + bond + potential + spring + surface) -
           damping_loss - dashpot_loss - relaxation_loss - stabilisation_loss - friction_loss - bonding_loss;
  }
  SchemeLoss predicted; ///< kept where the model is audited
  /// What is left of an audited ledger: rounding, but for bodies and bonds that are not linear.
  [[nodiscard]] double unaccounted() const { return scheme_loss() - predicted.sum(); }
};

/// What the networks of each body remember, as solid::Cells::relax fills it, [bodies]; 1.
using Memory = std::vector<Vector>;

/// Of one body; empty without memory.
[[nodiscard]] inline std::span<double const> memory_of(Memory const* memory, std::size_t body) {
  if (memory == nullptr)
    return {};
  auto const& own = (*memory)[body];
  return {own.data(), static_cast<std::size_t>(own.size())};
}

/// What a factor was made from that serves steps to come: to tell it from others, and to make it again.
struct FactorSource {
  std::shared_ptr<Vector const> u;                ///< m
  double dt = 0;                                  ///< s
  double t = 0;                                   ///< that springs and loads on paths are at, s
  Gases gas;                                      ///< at the start of its step
  std::shared_ptr<linear::Carried const> carried; ///< beside it; null: nothing
  std::shared_ptr<Memory const> memory{};         ///< at the start of its step; null: of rest
};

struct State {
  double t = 0;     ///< s
  double onset = 0; ///< until which loads that act from the start at once are on their way, s; 0: they act
  Vector u, v;      ///< [dim nodes], m and m/s; the turn of a free rigid body in rad and rad/s
  Vector a;         ///< accelerations, m/s^2; empty where the scheme keeps none
  /// Of explicit schemes: half the last contact impulse over the mass, m/s. v holds it, and the next step
  /// takes it out before it finds its own impulse; empty otherwise.
  Vector kick;
  Vector internal; ///< F_int(u) + A(u) v, N
  Vector damping;  ///< A(u) v, N; empty without viscosity
  Vector reaction; ///< H^T A r at the end of the step, N
  /// [pairs] each pair's own part of `reaction`, where there are several; else empty.
  std::vector<Vector> own_reactions;
  [[nodiscard]] Vector const& reaction_of(std::size_t pair) const {
    return own_reactions.empty() ? reaction : own_reactions[pair];
  }
  Vector drive; ///< force of the motions and constraints over the last step, N
  std::vector<std::vector<ContactState>> contacts; ///< [pairs][points]
  std::vector<RigidLoad> on_rigid;                 ///< [rigids] at the end of the step
  std::vector<Eigen::Matrix3d> turned; ///< [rigids] rotation of free rigid bodies in 3D; empty in 2D
  Gases gas;
  Ledger ledger;
  /// The factors that the step which led here left for the next, the last used first; none where they do not
  /// depend on u and carry nothing.
  std::vector<FactorSource> factors;
  double critical_step = 0; ///< of explicit schemes, s, found `critical_age` steps ago; age 0: not known
  int critical_age = 0;
  Momenta momenta;                      ///< empty unless the model is tallied
  std::shared_ptr<Memory const> memory; ///< null without bodies that relax
  [[nodiscard]] std::span<double const> memory_of(std::size_t body) const {
    return dynamics::memory_of(memory.get(), body);
  }
};

} // namespace stiction::dynamics
