// The contact problem of the present kinematics: bulk, turning normals and grip of bonds condensed onto
// points.
#pragma once
#include "dynamics/contact/condensation.hpp"
#include "dynamics/contact/contact_points.hpp"

namespace stiction::dynamics {

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> class ProblemAssembly {
public:
  using Points = ContactPoints<D, C>;
  ProblemAssembly(Model const& model, BulkSystem const& bulk);

  /// As ContactSystem::begin, turned and turning.
  void begin(State const& old, double dt, bool turning);
  /// Has the matrix to know of bodies that turn with an inertia tensor, be there contact or not?
  [[nodiscard]] bool spins() const { return spins_; }
  [[nodiscard]] bool turned() const { return turned_; }
  [[nodiscard]] bool turning() const { return turning_; }
  [[nodiscard]] bool overturned() const { return unstable_ != Unstable::unmet; }
  /// The linear problem of the active points, with the laws that it holds; returns their present forces.
  [[nodiscard]] Vector pose(Points const& points, linear::BulkFactor& bulk, Vector const& y, double weight,
                            contact::Problem& problem);
  /// What the surface does without contact, m, and the weight of reactions.
  struct Unloaded {
    Vector const& y;
    double weight;
  };
  /// The same for points at the state where `lead` posed its last problem, or very near, by what that is made
  /// of, all but its W; none where it is of another matrix.
  [[nodiscard]] std::optional<Vector> pose_as(ProblemAssembly const& lead, Points const& points,
                                              linear::BulkFactor& bulk, Unloaded const& now,
                                              contact::Problem& problem);
  /// Lets the problems to come of this attempt know that normals turn although the bulk is unstable with
  /// that. False where that has not kept it from them, and where it was tried before.
  [[nodiscard]] bool insist();
  /// Takes it from them again, as the last one has no answer; false where nothing is taken.
  [[nodiscard]] bool give_in();
  /// Lets bonds hold the bodies more tightly in the problems to come of this attempt. False where they hold
  /// as tightly as they may, where there are none, and with inertia: then a shorter step has an answer.
  [[nodiscard]] bool tighten(Points const& points);
  /// Of the problem last posed: c += weight (K_geo du + H^T p) for its forces p.
  void add_forces(Vector const& forces, double weight, Vector& c) const {
    condensation_.add_forces(forces, weight, c);
  }

private:
  [[nodiscard]] Vector fill(Points const& points, contact::Problem& problem) const;
  [[nodiscard]] bool pose_again(Points const& points, linear::BulkFactor& bulk, Unloaded const& now,
                                contact::Problem& problem);
  [[nodiscard]] bool eliminate_as(ProblemAssembly const& lead, Points const& points, linear::BulkFactor& bulk,
                                  Unloaded const& now, contact::Problem& problem);
  [[nodiscard]] static Vector forces_of(Points const& points);
  void gather(Points const& points, double weight);
  void couple(linear::CoupledBulk& bulk, Vector const& y, double weight, contact::Problem& problem);
  void add_spins(Points const& points, double weight);
  void add_shared_stiffness(Points const& points, int pair);
  void add_stiffness(Indices const& nodes, Eigen::Ref<Dense const> const& K);
  [[nodiscard]] Indices const& unknowns_of(Indices const& nodes);

  Model const* model_;
  BulkSystem const* bulk_;
  State const* old_ = nullptr;
  double dt_ = 0;
  bool spins_;
  double last_digit_ = 0;                ///< of positions, m
  double grip_ = 0;                      ///< part of the stiffness of bonds that the matrix has
  bool turning_ = true, turned_ = false; ///< may problems know that normals turn; has one known it
  /// May they although the bulk is unstable with that: not now, as one would be; yes; never again.
  enum class Unstable : std::uint8_t { unmet, met, insisted, given_in };
  Unstable unstable_ = Unstable::unmet;
  Indices unknowns_; ///< surface unknowns of one point
  Vector reaction_;  ///< H^T p of present forces, N
  Condensation condensation_;
};

} // namespace stiction::dynamics
