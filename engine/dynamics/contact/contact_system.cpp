// Solution of the contact problems of a step: points, their problem's assembly and the model's solver
// together.
#include "dynamics/contact/contact_system.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/solvers/descent.hpp"
#include "dynamics/bulk/timer.hpp"
#include "dynamics/contact/problem_assembly.hpp"
#include "dynamics/contact/sharp_solver.hpp"

namespace stiction::dynamics {

namespace {

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> class System : public ContactSystem {
public:
  System(Model const& model, BulkSystem const& bulk)
      : points_(model, problem_), assembly_(model, bulk), solver_(sharp_solver(model)),
        of_many_starts_(std::holds_alternative<contact::BipotentialNewton>(model.solver)) {}
  void begin(State const& old, double t1, double dt, bool turning) override {
    points_.begin(old, t1, dt);
    lead_ = nullptr;
    solver_->forget();
    assembly_.begin(old, dt, turning);
  }
  void follow(ContactSystem const& lead) override {
    lead_ = &dynamic_cast<System const&>(lead);
    points_.follow(lead_->points_);
  }
  void keep() override { points_.keep(); }
  void restore() override { points_.restore(); }
  [[nodiscard]] bool turned() const override { return assembly_.turned(); }
  [[nodiscard]] bool insist() override { return assembly_.insist(); }
  [[nodiscard]] bool overturned() const override { return assembly_.overturned(); }
  [[nodiscard]] bool turning() const override { return assembly_.turning(); }
  void locate(Vector const& u, bool settle) override { points_.locate(u, settle); }
  void each_point(Visit const& visit) const override {
    for (auto const& point : points_.all())
      visit(point.id, point.kinematics.nodes, point.kinematics.H);
  }
  void reaction(Vector& force, int pair) const override { points_.reaction(force, pair); }
  [[nodiscard]] bool solve(linear::BulkFactor& bulk, Vector const& y, double weight, Vector& c,
                           Cost& cost) override;
  [[nodiscard]] double residual() const override { return points_.residual(); }
  [[nodiscard]] double force_scale() const override { return points_.force_scale(); }
  void finish(State const&, double, State& next) const override { points_.finish(next); }
  [[nodiscard]] contact::Problem const& problem() const override { return problem_; }
  [[nodiscard]] Vector const& forces() const override { return forces_; }
  [[nodiscard]] PointId point_of(Index row) const override { return points_.all()[ix(rows_[ix(row)])].id; }

private:
  contact::Problem problem_;
  ContactPoints<D, C> points_;
  ProblemAssembly<D, C> assembly_;
  std::unique_ptr<contact::Solver> solver_;
  /// Does the solver start from nothing, too, where this problem's forces lead nowhere?
  [[nodiscard]] bool starts_anew() const {
    return of_many_starts_ && !contact::frictionless(problem_) && problem_.W.together() == nullptr;
  }

  bool of_many_starts_;          ///< the solver
  Indices rows_;                 ///< into all points, behind the problem's rows
  System const* lead_ = nullptr; ///< of one that follows: whose last problem the next one is like
  Vector forces_;                ///< that the solver left
};

template<int D, int C>
bool System<D, C>::solve(linear::BulkFactor& bulk, Vector const& y, double weight, Vector& c, Cost& cost) {
  Timer const timer(cost.contact);
  c.setZero(bulk.surface());
  problem_.points.clear();
  if (points_.active().empty() && bulk.hold() == 0 && !assembly_.spins())
    return true;
  Vector guess;
  contact::Solution found;
  auto const pose = [&] {
    std::optional<Vector> like;
    auto const* const lead = std::exchange(lead_, nullptr);
    if (lead != nullptr && lead->rows_ == points_.active() && !lead->problem_.points.empty()) {
      like = assembly_.pose_as(lead->assembly_, points_, bulk, {y, weight}, problem_);
      if (like)
        problem_.W = lead->problem_.W;
    }
    guess = like ? *std::move(like) : assembly_.pose(points_, bulk, y, weight, problem_);
    cost.add(bulk.spent());
  };
  auto const solve_from = [&](Vector const& start) {
    found = solver_->solve(problem_, start);
    auto const rows = static_cast<double>(problem_.W.rows());
    cost.contact_iterations += found.iterations;
    if (found.rounded)
      cost.contact_rounded = std::max(cost.contact_rounded, found.verdict.relative());
    cost.contact_operations += 2 * rows * rows * found.work;
    return found.converged;
  };
  pose();
  bool answered = solve_from(guess);
  if (!answered && assembly_.give_in()) {
    pose();
    answered = solve_from(guess);
  }
  while (!answered && assembly_.tighten(points_)) { // next to buckling the answer may be far away
    pose();
    answered = solve_from(guess);
  }
  if (!answered && !starts_anew()) // the forces may be a bad start
    answered = solve_from(Vector::Zero(guess.size()));
  ++cost.contact_problems;
  ++cost.answered[static_cast<std::size_t>(found.method)];
  rows_ = points_.active();
  forces_ = std::move(found.force);
  if (!answered)
    return false;
  points_.take(forces_);
  assembly_.add_forces(forces_, weight, c);
  return true;
}

template<int D> std::unique_ptr<ContactSystem> make_in(Model const& model, BulkSystem const& bulk) {
  if (contact_components(model) > 1)
    return std::make_unique<System<D, D>>(model, bulk);
  return std::make_unique<System<D, 1>>(model, bulk);
}

} // namespace

int contact_components(Model const& model) {
  auto const along = [](Pair const& pair) { return pair.law.tangential(); };
  return std::ranges::any_of(model.pairs, along) ? model.dim() : 1;
}

std::unique_ptr<ContactSystem> make_contact_system(Model const& model, BulkSystem const& bulk) {
  return model.dim() == 2 ? make_in<2>(model, bulk) : make_in<3>(model, bulk);
}

} // namespace stiction::dynamics
