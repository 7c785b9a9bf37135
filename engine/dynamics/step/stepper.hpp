// One step from a state to the next: Newton on the bulk, the contact problem solved exactly inside each
// iteration.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dynamics/bulk/bulk_system.hpp"
#include "dynamics/contact/contact_system.hpp"
#include "dynamics/contact/tunnelling.hpp"
#include "dynamics/model/state.hpp"
#include "dynamics/step/carried.hpp"
#include "dynamics/step/mixing.hpp"

namespace stiction::dynamics {

/// unstable: an explicit scheme was asked for a step above its stability limit, and did nothing, or a step
/// made more energy than there was. interrupted: not brought to its end.
enum class StepVerdict {
  converged,
  not_converged,
  inverted_cell,
  contact_failed,
  indefinite,
  unstable,
  passed,
  interrupted
};

/// A step's answer: the state it reached if converged, and how it went.
struct Outcome {
  State state;
  StepVerdict verdict = StepVerdict::not_converged;
  std::string reason; ///< empty when converged
  std::string leap;   ///< why a shorter step is wanted if there is one, although this has converged; or empty
  int iterations = 0;
  double out_of_balance = 0; ///< of force_scale, at the last iteration
  double force_scale = 0;    ///< largest nodal force, N
  [[nodiscard]] bool converged() const { return verdict == StepVerdict::converged; }
};

class Stepper;

/// One that follows another stepper, from a state near that one's.
struct Follower {
  Stepper* stepper;
  State const* old;
  bool trusting = false; ///< where it can be, one correction is taken for enough, and not looked at
};

/// Owns workspace only; every call starts from the state it is given.
class Stepper {
public:
  /// Of one made for the beginning alone only `initial` and `contact` may be asked.
  explicit Stepper(Model const& model, Purpose purpose = Purpose::steps);
  /// Makes its steps beside those of `lead`, whose model differs from this one in its numbers alone; only
  /// `initial`, `take_along` and what is asked may be called.
  Stepper(Model const& model, Stepper const& lead);

  /// The state at t = 0: reference positions, initial velocities, bonds as their laws say.
  [[nodiscard]] State initial();
  /// Is asked in every iteration whether to leave off.
  void interrupt_when(std::function<bool()> enough) { enough_ = std::move(enough); }
  [[nodiscard]] Outcome step(State const& old, double dt);
  /// Steps end with iterations with a factor of where they end, for those that follow.
  void lead() { leads_others_ = true; }
  /// The step that this one has just made, of all that follow: corrected with its factor, the first time all
  /// at once, from its forces and with the bonds that it closed. What comes of one does not depend on others.
  [[nodiscard]] std::vector<Outcome> take_along(std::span<Follower const> followers, double dt);
  /// Takes up where another stepper of the same model left off with these factors, having taken so much:
  /// steps go on to the last bit as its would have, and cost what they would have.
  void go_on(std::vector<FactorSource> const& made, Cost const& cost) {
    bulk_.make_again(made, weights_);
    cost_ = cost;
  }

  /// What the works of a run are rounded by, J; infinite where all nodes are driven and no step seeks a
  /// balance.
  [[nodiscard]] double rounding_energy(State const& state) const;
  [[nodiscard]] Cost const& cost() const { return cost_; }
  [[nodiscard]] ContactSystem const& contact() const { return *contact_; }
  [[nodiscard]] BulkSystem const& bulk() const { return bulk_; }
  [[nodiscard]] BulkSystem& bulk() { return bulk_; }

private:
  void learn_of_model();
  /// Calls set(degree of freedom, value_of(its motion)) for all that are driven.
  template<class Value, class Set> void each_driven(Value const& value_of, Set const& set) const {
    double value = 0;
    Motion const* last = nullptr;
    for (Index const dof : driven_) {
      if (auto const* motion = driver_[ix(dof)]; motion != last)
        value = value_of(*(last = motion));
      set(dof, value);
    }
  }
  [[nodiscard]] std::string makes_energy(State const& old, State const& next) const;
  /// Where iterations start: from the old rates, from rest, or from rest with problems that do not know the
  /// turn of normals.
  enum class Start { onward, rest, unturned };
  [[nodiscard]] Outcome attempt(State const& old, double dt, Start start);
  void gather_external(double t, Vector& force) const;
  void gather_external(State const& old, double dt);
  void add_following(Vector const& u, double t, Gases const& gas, Vector& force) const;
  void follow(double t);
  [[nodiscard]] Vector stored_forces(Vector const& u, double t, double& energy) const;
  void predict(State const& old, double dt, Start start);
  void arrive(State const& old, double t1);
  /// value = force(u) becomes what the tangent says of force(u + lead), by a difference.
  template<class Force> void look_ahead(Force const& force, Vector& value) {
    double const part = 1e-6 * bulk_.cell_size() / lead_.lpNorm<Eigen::Infinity>();
    Vector ahead;
    force(u_ + part * lead_, ahead);
    if (ahead.allFinite())
      value += (ahead - value) / part;
  }
  [[nodiscard]] bool balance(State const& old, double dt, Outcome& outcome);
  solid::Pass internal(Vector const& u, double t, Vector& force) const;
  void damping(Instant const& now, Vector& force) const;
  [[nodiscard]] bool internal_forces(double t, Outcome& outcome);
  [[nodiscard]] bool shorten(State const& old, double dt, Outcome& outcome);
  void accelerate(State const& old, double dt);
  void spin(State const& old, double dt);
  void turn_rates(State const& old, double dt, State& next) const;
  [[nodiscard]] double spin_energy(State const& state) const;
  [[nodiscard]] double spin_loss(State const& old, State const& next) const;
  void start_rates(State& state);
  void set_explicit_rates(State const& old, double dt, State& next) const;
  [[nodiscard]] std::optional<Outcome> too_long(State const& old, double dt);
  /// Contact nodes that balance by themselves.
  [[nodiscard]] bool apart(Index dof) const { return apart_[ix(dof)] != 0; }
  [[nodiscard]] double largest_way(Vector const& way) const;
  [[nodiscard]] double largest_force(Vector const& force) const;
  [[nodiscard]] double imbalance() const;
  [[nodiscard]] double rounded() const;
  [[nodiscard]] bool converged(Outcome& outcome);
  [[nodiscard]] bool correct(State const& old, double dt, Outcome& outcome);
  [[nodiscard]] bool apply_factor();
  void load_correction();
  [[nodiscard]] bool answer_contact();
  [[nodiscard]] bool take_correction();
  /// Of one that follows: what was wrong with the step at first and before the last correction, N.
  struct Wrong {
    double first = 0, before = 0;
  };
  enum class Next { correct, finish, leave_off };
  [[nodiscard]] bool start_after(Stepper& lead, State const& old, double dt, Outcome& outcome);
  [[nodiscard]] Next weigh(State const& old, Wrong& wrong, Outcome& outcome);
  [[nodiscard]] std::vector<bool> correct_together(std::vector<Stepper*> const& all);
  void go_after(Follower const& how, double dt, Wrong wrong, Outcome& outcome);
  [[nodiscard]] bool near(Outcome const& outcome) const;
  [[nodiscard]] bool balance_on(State const& old, double dt, Outcome& outcome);
  [[nodiscard]] bool polish(State const& old, double dt, Outcome& outcome);
  void finish(State const& old, double dt, Outcome& outcome);
  [[nodiscard]] double viscous_loss(State const& old, State const& next) const;
  void account(State const& old, State& next);
  [[nodiscard]] double rubbed(ContactState const& before, ContactState const& after) const;
  void drive_against(Vector const& force, Vector& drive) const;
  void account_springs(State const& old, State& next) const;
  void set_momenta(State& state) const;
  void tally(State const& old, State& next) const;
  void audit(State const& old, State& next) const;
  [[nodiscard]] Vector unmet_balance(State const& old, State const& next) const;
  [[nodiscard]] double path_work(State const& old, State const& next) const;
  [[nodiscard]] double work_within(State const& old) const;
  [[nodiscard]] double relaxing_work(State const& old) const;
  void audit_contact(State const& old, State& next) const;
  [[nodiscard]] double obstacle_work(std::size_t pair, State const& old, State const& next) const;

  void watch(Outcome const& outcome);
  [[nodiscard]] std::string come_off(State const& old, double imbalance) const;
  [[nodiscard]] Outcome with_remedy(Outcome outcome) const;
  [[nodiscard]] std::string unanswered() const;
  [[nodiscard]] std::string held_and_pressed() const;

  static constexpr int settle_after = 6; ///< iterations after which no point changes its mind about bonding

  Model const* model_;
  std::function<bool()> enough_;
  Start start_ = Start::rest; ///< of the last attempt
  bool follows_ = false;      ///< another stepper
  bool leads_others_ = false; ///< other steppers follow
  bool along_ = false;        ///< the last correction was along linear forces
  StepWeights weights_;
  BulkSystem bulk_;
  std::unique_ptr<ContactSystem> contact_;
  std::optional<Skin> rim_; ///< of one that follows: the cells of driven nodes, where others need no look
  Tunnelling tunnelling_;
  Carried carried_;
  Cost cost_;
  std::vector<Motion const*> driver_; ///< [degrees of freedom], null if free
  Indices driven_;                    ///< degrees of freedom, motion by motion
  Indices own_;                       ///< degrees of freedom that balance by themselves
  std::vector<char> apart_;           ///< [degrees of freedom], of those 1
  Vector arms_;                       ///< of the model
  // workspace of one step
  Vector d_, u_, rate_change_, gained_, internal_, inertia_, unbalanced_, reaction_, gathered_, correction_,
      surface_, surface_load_;
  Vector mass_rate_, damping_;
  Vector lead_;                    ///< what driven unknowns lack to where they are driven, m
  bool leads_ = false;             ///< the next correction moves them by it
  Vector skin_old_;                ///< force of the skin at the step's start, N
  Vector excess_;                  ///< what its end adds to the mean internal force, N
  double onset_ = 0;               ///< of the step's state, s
  Vector external_old_, external_; ///< dead load and loads at the step's ends, N
  Vector mean_drive_;              ///< of motions, that does the ledger's work, N
  Vector prescribed_;           ///< of external_ what does not follow surfaces, N; empty where nothing does
  Gases gas_old_, gas_;         ///< at the step's ends
  std::vector<double> volumes_; ///< [gases] that gas_ is of, m^3; empty at first
  Vector inverse_mass_;         ///< explicit schemes: of the lumped mass, [dim nodes], 1/kg
  double critical_step_ = 0;
  int critical_age_ = 0;                    ///< as State::critical_age, after the step
  material::NetworkEnergy<double> relaxed_; ///< of the step that ends, J
  double strain_ = 0, force_scale_ = 0;
  double previous_imbalance_ = 0, contraction_ = 0; ///< progress with the present factor
  double contraction_before_ = 0;                   ///< of the iteration before
  double previous_worst_ = 0;                       ///< imbalance or contact's residual, N
  int slow_ = 0;                                    ///< corrections in a row that hardly contracted
  bool mixes_ = false;                              ///< corrections by the matrix alone lead nowhere
  Mixing mixing_;
  double extent_ = 0; ///< largest coordinate of a node, m
};

} // namespace stiction::dynamics
