// One quasi-static step of a half space: the drive moves, contact and bonds answer together.
#pragma once
#include <functional>

#include "halfspace/model.hpp"
#include "halfspace/solver.hpp"

namespace stiction::halfspace {

struct Outcome {
  State state;
  bool converged = false;
  bool interrupted = false;
  std::string reason; ///< empty when converged
  long iterations = 0;
};

struct Cost {
  long iterations = 0, krylov = 0, products = 0, solutions = 0; ///< of all steps
  template<class Archive> void visit(Archive& archive) { archive(iterations, krylov, products, solutions); }
};

/// Owns workspace only; every call starts from the state it is given.
class Stepper {
public:
  explicit Stepper(Model const& model);
  [[nodiscard]] State initial() const;
  [[nodiscard]] Outcome step(State const& old, double dt);
  /// Is asked in every iteration whether to leave off.
  void interrupt_when(std::function<bool()> enough) { enough_ = std::move(enough); }
  [[nodiscard]] Surface const& surface() const { return surface_; }
  [[nodiscard]] Cost const& cost() const { return cost_; }
  void go_on(Cost const& cost) { cost_ = cost; }

private:
  void begin(State const& old, State const& next, double dt);
  /// Whether points touch, as bonds are told, has changed with this answer.
  [[nodiscard]] bool closing_changed(Answer const& answer);
  void settle(State const& old, Answer const& answer, State& next) const;
  template<int D> void settle_point(State const& old, Answer const& answer, Index i, State& next) const;
  template<int D> void settle_bond(contact::Local<D> const& x, Index i, State& next) const;
  void account(State const& old, State& next) const;

  Model const* model_;
  Surface surface_;
  Solver solver_;
  Problem problem_;
  std::function<bool()> enough_;
  Cost cost_;
};

} // namespace stiction::halfspace
