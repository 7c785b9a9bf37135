// The bulk side of a step: numbering of unknowns, mass, internal force, effective stiffness and its factor.
#pragma once
#include <memory>
#include <optional>

#include "dynamics/bulk/links.hpp"
#include "dynamics/bulk/skin.hpp"
#include "dynamics/bulk/springs.hpp"
#include "dynamics/bulk/surface_loads.hpp"
#include "dynamics/model/mass.hpp"
#include "dynamics/model/state.hpp"
#include "linear/bulk_factor.hpp"

namespace stiction::linear {
struct NodesOfUnknowns;
struct UnknownsOfRanks;
} // namespace stiction::linear

namespace stiction::dynamics {

/// Seconds and counts of the phases of a run.
struct Cost {
  double assembly = 0, factorization = 0, contact = 0, solve = 0; ///< s
  long force_passes = 0, stiffness_passes = 0, factorizations = 0, shifted_factorizations = 0, solves = 0;
  long newton_iterations = 0, contact_iterations = 0, contact_problems = 0;
  contact::Methods
      answered{}; ///< contact problems by what answered them; the one of an unconverged step: none
  double contact_rounded = 0; ///< largest residual that rounding kept a contact solver at, of its yardstick
  double contact_operations = 0; ///< of the contact solver, floating-point, leading terms
  long compliance_columns = 0;   ///< of the surface, solved for
  double compliance_operations = 0;
  void add(linear::Spent const& spent) {
    compliance_columns += spent.columns;
    compliance_operations += spent.operations;
  }
};

/// What a system is for: steps, or the state before the first, which wants forces and mass and no matrix.
enum class Purpose { steps, beginning };

/// Of bodies that relax: with their networks, or of their laws alone.
enum class Forces { all, laws };

/// Where loads that follow paths and volumes are.
struct LoadsAt {
  double t = 0;   ///< s
  Gases gas = {}; ///< empty: without gas
};

/// Model nodes of every contact surface, secondary and primary, and of free rigid bodies, [nodes].
[[nodiscard]] std::vector<bool> contact_nodes(Model const& model);

class BulkSystem {
public:
  BulkSystem(Model const& model, StepWeights const& weights, Purpose purpose = Purpose::steps);
  /// Of a model with the same unknowns as `lead`, beside it: it has their numbers, and no matrix of its own.
  BulkSystem(Model const& model, StepWeights const& weights, BulkSystem const& lead);
  /// Solves with the present factor of `lead` until this is called again.
  void borrow_factor(BulkSystem& lead);

  [[nodiscard]] Index unknowns() const { return static_cast<Index>(dof_of_.size()); }
  /// Number of the free unknown behind a degree of freedom; contact unknowns come last. Negative if it is
  /// driven or follows others.
  [[nodiscard]] Index unknown_of(Index dof) const { return unknown_of_[ix(dof)]; }
  /// That, or of a degree of freedom that moves as another one the unknown behind that; -1: there is none.
  [[nodiscard]] Index moved_with(Index dof) const {
    Index const own = unknown_of(dof);
    return own >= -1 ? own : links_.carrier(own, unknown_of_);
  }
  [[nodiscard]] Links const& links() const { return links_; }
  [[nodiscard]] Index dof_of(Index unknown) const { return dof_of_[ix(unknown)]; }
  [[nodiscard]] Index first_contact_unknown() const { return unknowns() - trailing_; }
  /// True for nodes of contact surfaces and of free rigid bodies.
  [[nodiscard]] bool on_surface(Index node) const { return on_surface_[ix(node)]; }
  [[nodiscard]] bool surface_dof(Index dof) const { return on_surface_[ix(dof / dim_)]; }

  /// F_int(u) of the cells over all degrees of freedom, with the strain energy of the laws: with what
  /// networks do in the step that remember_from has begun, or of the laws alone.
  [[nodiscard]] solid::Pass internal_force(Vector const& u, Vector& force, Forces what = Forces::all) const;
  /// Has any body networks that relax?
  [[nodiscard]] bool relaxing() const { return relaxing_; }
  /// What they remember at rest; null without them.
  [[nodiscard]] std::shared_ptr<Memory const> memory_at_rest() const;
  /// A step of size dt begins with this memory.
  void remember_from(std::shared_ptr<Memory const> memory, double dt);
  /// It ends at u: what they remember then, and their energies, J.
  [[nodiscard]] std::shared_ptr<Memory const> relax(Vector const& u, material::NetworkEnergy<double>& energy);
  /// "cell 12 of body tape, at (0.1, 0.2) m" where it lies at rest; the number counts all bodies' from 0.
  [[nodiscard]] std::string cell_words(Index cell) const;
  /// Internal force of the skin, weighted by how much more it counts at the step's end than that of all
  /// cells, N; call only where the scheme has a skin.
  void skin_force(Vector const& u, Vector& force) const;
  [[nodiscard]] Springs const& springs() const { return springs_; }
  [[nodiscard]] SurfaceLoads const& surface_loads() const { return surface_loads_; }
  /// Has any body a viscosity, or a spring a dashpot?
  [[nodiscard]] bool damped() const { return damped_; }
  /// A(u) v of the cells over all degrees of freedom, N.
  void damping_force(Vector const& u, Vector const& v, Vector& force) const;
  /// What the stabilisation acts on, [degrees of freedom], N/m: E / L^2 per volume of each body (L: diagonal
  /// of its box); 0 at driven unknowns, empty where nothing asks for it.
  [[nodiscard]] Vector const& grip() const { return grip_; }
  /// Mass and dead load; no values in quasi-statics without gravity.
  [[nodiscard]] Mass const& mass() const { return mass_; }

  /// Builds and factors xi K(u) + xi A(u) / (rate dt) + M / (mass dt^2), (49), with rate = 1 in the columns
  /// of contact nodes that balance by themselves; of explicit schemes the lumped M alone, without any pass
  /// over the cells. The change of A with u is left out. Where that is not positive definite by itself but
  /// would be with the contact surfaces held, as a law that softens under a punch, the factor holds them.
  /// False if that does not help. at: beside u, what springs and loads are at.
  [[nodiscard]] bool factorize(Vector const& u, StepWeights const& weights, double dt, Cost& cost,
                               LoadsAt const& at = {});
  /// Takes up a factor for these coefficients, of whatever u; false if none is kept. One that `recall` wants
  /// and that has been overwritten is made again.
  [[nodiscard]] bool take_factor(StepWeights const& weights, double dt, Cost& cost);
  /// Keeps these factors and no others: what a step that failed has left is as if it had not been. Factors
  /// that do not depend on u all stay.
  void recall(std::vector<FactorSource> const& wanted, StepWeights const& weights);
  /// Keeps these factors and no others, made now, with all that they carry.
  void make_again(std::vector<FactorSource> const& wanted, StepWeights const& weights);
  /// Those kept, the last used first; none where they do not depend on u and carry nothing.
  [[nodiscard]] std::vector<FactorSource> sources() const;
  /// Those kept that do not depend on u, whether carrying or not: who goes on elsewhere makes them again.
  [[nodiscard]] std::vector<FactorSource> lasting() const;
  /// This one with what its factor carries by now, if that is made, though the present step may have put it
  /// aside.
  [[nodiscard]] std::optional<FactorSource> held(FactorSource const& wanted) const;
  /// Keeps the factors of so many step sizes, those used last, instead of one; each takes the memory of one.
  /// Where it is more than one, one more is held for a step that may yet be given up.
  void keep_factors(std::size_t count) { kept_at_most_ = count; }
  /// True if the matrix does not depend on u, so that a factor for these coefficients is exact.
  [[nodiscard]] bool linear() const { return linear_; }
  /// True if the internal force, springs included, is linear in u, and no load follows it.
  [[nodiscard]] bool linear_bodies() const { return linear_bodies_; }
  /// The present one; its surface are the contact unknowns.
  [[nodiscard]] linear::BulkFactor& factor() { return lent_ != nullptr ? *lent_ : *kept_.front().factor; }
  [[nodiscard]] linear::BulkFactor const& factor() const {
    return lent_ != nullptr ? *lent_ : *kept_.front().factor;
  }
  [[nodiscard]] linear::Effort effort() const { return factor().effort(); }
  /// Largest diagonal entry of the present factor's matrix, N/m: sets the floor of rounding.
  [[nodiscard]] double stiffness_scale() const { return kept_.front().scale; }
  /// The same of the bodies alone, without mass, N/m.
  [[nodiscard]] double bodies_stiffness() const { return kept_.front().bodies; }
  /// Largest distance of a cell's nodes from its first, m: a displacement that makes grad u about 1.
  [[nodiscard]] double cell_size() const { return cell_size_; }

private:
  enum class Matrix { own, of_another, none };
  BulkSystem(Model const& model, StepWeights const& weights, Matrix matrix, BulkSystem const* lead);
  void number_as(BulkSystem const& lead);

  /// A factor, and what it is the factor of.
  struct Kept {
    std::unique_ptr<linear::BulkFactor> factor;
    FactorSource source;          ///< no u: nothing is kept here
    bool made = false;            ///< false: to be made from the source when it is asked for
    bool wanted = false;          ///< by the state that the present step starts from
    double xi = 0, mass = 0;      ///< coefficients of K and of M, 1 and 1/s^2
    double relaxed = 0;           ///< step size that it holds for, s; 0: where it does no more than those
    double scale = 0, bodies = 0; ///< N/m
    /// relaxing: does the matrix depend on dt for that too?
    void is_of(FactorSource from, StepWeights const& weights, bool relaxing);
    [[nodiscard]] bool is(StepWeights const& weights, double dt, bool relaxing) const;
    [[nodiscard]] bool comes_from(FactorSource const& other) const {
      return source.u == other.u && source.dt == other.dt;
    }
  };
  [[nodiscard]] bool make(StepWeights const& weights, Cost& cost);
  void choose_factor(FactorSource source, StepWeights const& weights);
  [[nodiscard]] std::unique_ptr<linear::BulkFactor> spare();
  void make_matrix(Model const& model, StepWeights const& weights);
  void number_unknowns(Model const& model);
  void set_mass(StepWeights const& weights);
  void add_mass(Index row, Index column, double value);
  [[nodiscard]] bool moves(Index node) const;
  [[nodiscard]] linear::NodesOfUnknowns nodes_of_unknowns(Model const& model) const;
  [[nodiscard]] linear::UnknownsOfRanks unknowns_of_ranks(Model const& model) const;
  [[nodiscard]] Indices places(Indices const& nodes) const;
  [[nodiscard]] static Dense motions(Model const& model, Indices const& nodes);
  /// Is an unknown's node this rank's, or is there but one?
  [[nodiscard]] bool own(Index unknown) const {
    return !model_->share || model_->share->own(dof_of(unknown) / dim_);
  }
  [[nodiscard]] solid::Pass together(solid::Pass mine, Vector& force) const;
  [[nodiscard]] std::shared_ptr<Memory> memory_to_fill();
  [[nodiscard]] std::vector<solid::Networks> networks_of(Memory const* memory, double dt) const;
  void build_maps(Model const& model);
  void gather_grip(Model const& model);
  void add_stiffness(FactorSource const& at, StepWeights const& weights, Cost& cost);
  void add_damping(FactorSource const& at, double factor, std::vector<double>& values) const;
  [[nodiscard]] std::vector<linear::ColumnEntry> own_columns(double share) const;

  Model const* model_;
  int dim_;
  bool diagonal_; ///< explicit: the effective stiffness is the lumped mass
  Indices unknown_of_, dof_of_;
  Index trailing_ = 0;
  std::vector<bool> on_surface_;
  Mass mass_;
  Springs springs_;
  SurfaceLoads surface_loads_;
  Links links_;
  Vector grip_;
  double grip_in_matrix_ = 0;
  std::vector<double> mass_in_matrix_;  ///< M in the pattern of the effective stiffness
  std::vector<solid::ScatterMap> maps_; ///< [bodies]
  std::optional<Skin> skin_;
  double skin_more_ = 0; ///< weight of the skin's stress at the step's end beside that of all cells
  std::vector<double> values_,
      viscous_;              ///< viscous_: what A adds, where contact nodes have rates of their own
  std::vector<Kept> kept_;   ///< the present one first, then by when they were used; at least one
  std::vector<Kept> parked_; ///< wanted, but overwritten by the present step; at most one
  std::vector<std::unique_ptr<linear::BulkFactor>> spare_; ///< memory of factors that nobody wants
  std::size_t kept_at_most_ = 1;
  linear::BulkFactor* lent_ = nullptr; ///< by another system
  bool linear_ = false, linear_bodies_ = false, damped_ = false, relaxing_ = false;
  std::shared_ptr<Memory const> memory_;        ///< at the start of the present step
  std::vector<std::shared_ptr<Memory>> filled_; ///< by the last steps; who wants one holds it too
  double relax_dt_ = 0;                         ///< its size, s
  std::vector<solid::Networks> networks_;       ///< [bodies], in it; empty without bodies that relax
  bool own_rates_ = false;                      ///< of damped bodies' contact nodes
  double cell_size_ = 0;                        ///< m
  Vector arms_;                                 ///< of the model
};

} // namespace stiction::dynamics
