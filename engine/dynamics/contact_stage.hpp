// The contact side of a step: where every point stands, the small eliminated problem, and the forces it
// gives.
#pragma once
#include <memory>

#include "dynamics/model.hpp"
#include "dynamics/state.hpp"
#include "dynamics/structure.hpp"

namespace stiction::dynamics {

class ContactStage {
public:
  ContactStage(Model const& model, Structure& structure);

  /// Starts a step from `old` to time t1 with the forces of `old` as first guess.
  void begin(State const& old, double t1, double dt);
  /// Kinematics of every point at u; `settle` freezes which points may bond, so that none flips for ever.
  void locate(Vector const& u, bool settle);
  /// H^T p with the current forces and kinematics, [degrees of freedom], N.
  void reaction(Vector& force) const;

  /// Solves the contact problem linearised at the last `locate`. y: motion of the contact unknowns without
  /// contact. On return c holds weight (K_geo du + H^T p) on them. False if the solver did not converge.
  [[nodiscard]] bool solve(Vector const& y, double weight, Vector& c, Cost& cost);

  /// Largest natural-map residual of the present forces at the present kinematics, N; infinite while points
  /// penetrate that no problem has seen yet or the set of bonding points has changed.
  [[nodiscard]] double residual() const;
  /// Largest force on any point, N.
  [[nodiscard]] double force_scale() const;

  /// The points after the step, from the present kinematics and forces.
  void finish(State const& old, double dt, State& next) const;
  /// The last problem handed to a solver, for saving.
  [[nodiscard]] contact::Problem const& problem() const { return problem_; }

private:
  struct Point {
    int pair = 0;
    Index index = 0;
    contact::PointKinematics kinematics;
    Vec2 force = Vec2::Zero(); ///< p = A r, (n, t), N
    double rho = 0;            ///< of the last problem, N/m; 0 before
    contact::ProblemPoint law; ///< area, mu, bond
    bool active = false;
  };
  [[nodiscard]] contact::PointKinematics look(Point const& point, contact::Foot start) const;
  void choose_active(Point& point) const;
  void gather_unknowns();
  void assemble_rows();
  void build_problem(Vector const& y, double weight);

  Model const* model_;
  Structure* structure_;
  std::unique_ptr<contact::Solver> solver_;
  std::vector<Point> points_;
  std::vector<Index> active_; ///< into points_
  Vector positions_;
  State const* old_ = nullptr;
  double t1_ = 0;
  bool bonding_changed_ = false;
  // the small system of one iteration
  Indices unknowns_, local_of_; ///< contact unknowns taking part; their local numbers or -1
  Dense H_, geometric_, V_, reduced_, right_;
  Vector free_motion_;
  contact::Problem problem_;
};

} // namespace stiction::dynamics
