// The contact side of a step: where every point stands, the small eliminated problem, and the forces it
// gives.
#pragma once
#include <functional>
#include <memory>

#include "dynamics/bulk/bulk_system.hpp"
#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// A contact point by its pair and its index there.
struct PointId {
  int pair = 0;
  Index index = 0;
};

/// One step's contact, whatever the dimension and the number of components that the laws need.
class ContactSystem {
public:
  virtual ~ContactSystem() = default;

  /// Starts a step from `old` to time t1 with the forces of `old` as first guess. turning: may its problems
  /// know that normals turn as points move? The balance has that all the same: iterations converge, if
  /// slower.
  virtual void begin(State const& old, double t1, double dt, bool turning) = 0;
  /// After `begin`: forces, which bonds are closed, and which points have no counterpart, as another system
  /// of the same pairs has them now, and the first problem's operator as that of its last one. It must stay
  /// as it is until then.
  virtual void follow(ContactSystem const& lead) = 0;
  /// Keeps the points as they are, and puts them back to what was kept last.
  virtual void keep() = 0;
  virtual void restore() = 0;
  /// Has any problem of the step known it?
  [[nodiscard]] virtual bool turned() const = 0;
  /// Lets the next problems know it even where nothing tells that they have an answer then; one that has
  /// none is posed without. False if they do anyway, or if that was tried before in this attempt.
  [[nodiscard]] virtual bool insist() = 0;
  /// Was one of the attempt kept from it, as the bulk would be unstable?
  [[nodiscard]] virtual bool overturned() const = 0;
  /// Did the last problem know it?
  [[nodiscard]] virtual bool turning() const = 0;
  /// Kinematics of every point at u; `settle` freezes which points may bond, so that none flips for ever.
  virtual void locate(Vector const& u, bool settle) = 0;
  /// Calls visit(point, nodes, H) for every point as of the last `locate`; H: rows (n, t1 [, t2]) over the
  /// components of the nodes, of which there are none where it has no counterpart.
  using Visit = std::function<void(PointId, Indices const&, Dense const&)>;
  virtual void each_point(Visit const& visit) const = 0;
  /// H^T p with the current forces and kinematics, of all pairs or of one, [degrees of freedom], N.
  virtual void reaction(Vector& force, int pair = -1) const = 0;

  /// Solves the contact problem linearised at the last `locate`. y: motion of the bulk's surface without
  /// contact. On return c holds weight (K_geo du + H^T p) on it. False if the solver did not converge.
  [[nodiscard]] virtual bool solve(linear::BulkFactor& bulk, Vector const& y, double weight, Vector& c,
                                   Cost& cost) = 0;

  /// Largest natural-map residual of the present forces at the present kinematics, N; infinite while points
  /// penetrate that no problem has seen yet or the set of bonding points has changed.
  [[nodiscard]] virtual double residual() const = 0;
  /// Largest force on any point, N.
  [[nodiscard]] virtual double force_scale() const = 0;

  /// The points after the step, from the present kinematics and forces; the turn of free rigid bodies.
  virtual void finish(State const& old, double dt, State& next) const = 0;
  /// The last problem handed to a solver, without points where none was in reach; the forces that the solver
  /// left, and the contact point behind each of its rows.
  [[nodiscard]] virtual contact::Problem const& problem() const = 0;
  [[nodiscard]] virtual Vector const& forces() const = 0;
  [[nodiscard]] virtual PointId point_of(Index row) const = 0;
};

/// Per point: one where all pairs are frictionless and bond along the normal alone, else as many as the model
/// has dimensions.
[[nodiscard]] int contact_components(Model const& model);
[[nodiscard]] std::unique_ptr<ContactSystem> make_contact_system(Model const& model, BulkSystem const& bulk);

} // namespace stiction::dynamics
