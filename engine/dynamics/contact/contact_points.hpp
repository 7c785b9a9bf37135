// The contact points of a step: which take part, their forces, and what they leave.
#pragma once
#include "dynamics/contact/contact_geometry.hpp"
#include "dynamics/contact/step_point.hpp"
#include "dynamics/contact/twins.hpp"

namespace stiction::dynamics {

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> class ContactPoints {
public:
  using Point = StepPoint<D, C>;
  /// Both must outlive it; `problem` gets the laws of all pairs.
  ContactPoints(Model const& model, contact::Problem& problem);

  void begin(State const& old, double t1, double dt);
  /// As ContactSystem::follow.
  void follow(ContactPoints const& lead);
  /// As ContactSystem::keep and restore.
  void keep() { kept_ = points_; }
  void restore() { points_ = kept_; }
  /// As ContactSystem::locate.
  void locate(Vector const& u, bool settle);
  /// As ContactSystem::reaction.
  void reaction(Vector& force, int pair) const;
  /// Takes the answer of the problem whose rows the active points are; its forces: [C active], N.
  void take(Vector const& forces);
  /// As ContactSystem::residual.
  [[nodiscard]] double residual() const;
  [[nodiscard]] double force_scale() const;
  /// The points after the step, from the present kinematics and forces; the turn of free rigid bodies.
  void finish(State& next) const;

  [[nodiscard]] std::vector<Point> const& all() const { return points_; }
  [[nodiscard]] Indices const& active() const { return active_; } ///< into all()
  [[nodiscard]] Point const& active(std::size_t row) const { return points_[ix(active_[row])]; }
  [[nodiscard]] ContactGeometry<D> const& geometry() const { return geometry_; }
  [[nodiscard]] Pair const& pair_of(Point const& point) const { return model_->pairs[ix(point.id.pair)]; }
  /// At the step's start.
  [[nodiscard]] ContactState const& before(Point const& point) const {
    return old_->contacts[ix(point.id.pair)][ix(point.id.index)];
  }

private:
  void add_pair(int number);
  template<class Act> void each_point(Act const& act);
  void limit_rates(Point& point, double dt) const;
  [[nodiscard]] double own_area(Point const& point) const { return pair_of(point).areas[ix(point.id.index)]; }
  void pair_twins();
  void choose_active(Point& point) const;
  void settle_closing(Point& point);
  void add_force(Point const& point, contact::Local<C> const& p, Vector& force) const;
  [[nodiscard]] contact::Local<C> part_of(Point const& point, Point const& lead) const;
  void pass_load(Point const& lead, Point const& point, State& next) const;
  void finish(Point const& point, ContactState& after, State& next) const;

  Model const* model_;
  contact::Problem const* problem_;
  StepWeights weights_;
  ContactGeometry<D> geometry_;
  Twins twins_;
  std::vector<Point> points_, kept_;
  Indices active_;
  State const* old_ = nullptr;
  bool bonding_changed_ = false;
};

} // namespace stiction::dynamics
