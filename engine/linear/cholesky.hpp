// Supernodal Cholesky factorization with the Schur complement onto the trailing unknowns read off the factor.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "linear/bulk_factor.hpp"

namespace stiction::linear {

/// The order of elimination: that of the pattern, or CHOLMOD's own, behind the same numbers of unknowns.
enum class Order { given, free };

/// Analyses a pattern once, then factors new values of it again and again without heap allocation.
class Cholesky {
public:
  /// The last `trailing` unknowns are those to eliminate onto, in the given order.
  Cholesky(Pattern pattern, Index trailing, Order order = Order::given);
  ~Cholesky();
  Cholesky(Cholesky const&) = delete;
  Cholesky& operator=(Cholesky const&) = delete;

  /// values[entries] of the lower triangle. False if the matrix is not positive definite; that of no
  /// unknowns is.
  [[nodiscard]] bool factorize(std::span<double const> values);
  /// Solves A x = b in place; b[n], B[n, any]. Several threads may solve at the same time.
  void solve(Vector& b);
  void solve(Dense& B);
  /// The halves of solve, in the given order: z = L^-1 b, then b = L^-T z, in place. Between them what acts
  /// on the trailing unknowns only may be added to z as (trailing factor)^-1 of it.
  void forward(Vector& b);
  void backward(Vector& z);
  /// Those of several right sides at once, each in place: the factor is read once for four. What comes of
  /// one does not depend on the others.
  void solve(std::span<Vector* const> all);
  void forward(std::span<Vector* const> all);
  void backward(std::span<Vector* const> all);
  /// L^-1 B in place. [n, any]
  void forward(Dense& B);
  /// Lower triangular factor of the Schur complement onto the trailing unknowns. [trailing, trailing]
  [[nodiscard]] Dense const& trailing_factor();
  [[nodiscard]] Pattern const& pattern() const { return pattern_; }
  [[nodiscard]] Order order() const { return order_; }
  [[nodiscard]] Effort effort() const;

private:
  struct Workspace;
  struct Solver;
  class Borrowed;
  void solve_system(int system, Eigen::Ref<Dense> B);
  template<class Halves> void by_fours(std::span<Vector* const> all, int const* order, Halves const& halves);

  Pattern pattern_;
  Index trailing_;
  Order order_;
  Dense trailing_factor_;
  bool factor_ready_ = false;
  std::unique_ptr<Workspace> work_;
};

/// CHOLMOD's version, for the manifest.
[[nodiscard]] std::string cholmod_version();

} // namespace stiction::linear
