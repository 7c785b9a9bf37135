// What a step is off by: an estimate that needs no other solve.
#pragma once
#include "dynamics/adaptivity/point_history.hpp"
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::dynamics {

/// The contact points of bodies.
struct BodyPoints {
  using State = dynamics::State;
  using Kept = std::vector<std::vector<ContactState>>; ///< [pairs][points]
  Model const* model;

  [[nodiscard]] static std::size_t pairs(State const& state) { return state.contacts.size(); }
  [[nodiscard]] static std::size_t size(State const& state, std::size_t pair) {
    return state.contacts[pair].size();
  }
  [[nodiscard]] static ContactState const& at(State const& state, std::size_t pair, std::size_t point) {
    return state.contacts[pair][point];
  }
  [[nodiscard]] static ContactState const& at(Kept const& kept, std::size_t pair, std::size_t point) {
    return kept[pair][point];
  }
  [[nodiscard]] static double beta(State const& state, std::size_t pair, std::size_t point) {
    return state.contacts[pair][point].bond.beta;
  }
  [[nodiscard]] static Kept keep(State const& state) { return state.contacts; }
  [[nodiscard]] std::optional<interface::AdhesionLaw> const& adhesion(std::size_t pair) const {
    return model->pairs[pair].law.adhesion;
  }
  static void set_beta(State& state, std::size_t pair, std::size_t point, double beta) {
    state.contacts[pair][point].bond.beta = beta;
  }
  [[nodiscard]] bool audited() const { return model->audited; }
};

/// Compares steps of bodies with the steps before them: bonds as PointHistory does, and u.
///
/// u: the step's increment against the integral of the parabola through the velocities at its ends and at the
/// start of the step before. Of whatever scheme, this is the local error of u: of the trapezoidal rule
/// -dt^3 v''/12, of backward Euler dt^2 v'/2. Without inertia u integrates nothing and has no error of its
/// own.
class History : public PointHistory<BodyPoints> {
public:
  History(BulkSystem const& bulk, Model const& model);

  [[nodiscard]] StepError error(State const& old, State const& next) const;
  /// `next` follows; steps no longer than `within` may hold events.
  void accept(State const& old, State const& next, double within);
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    PointHistory::visit(archive);
    archive(v_, scale_);
  }

private:
  [[nodiscard]] double displacement_error(State const& old, State const& next) const;
  [[nodiscard]] double mean_square(Vector const& u) const;

  BulkSystem const* bulk_;
  Model const* model_;
  Vector v_;         ///< at the start of the step before, m/s
  double scale_ = 0; ///< largest mean square of u so far, or of what motions ask for, kg m^2
};

extern template class PointHistory<BodyPoints>;

} // namespace stiction::dynamics
