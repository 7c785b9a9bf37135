// Supernodal Cholesky factorization with the Schur complement onto the trailing unknowns read off the factor.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "linear/pattern.hpp"

namespace stiction::linear {

/// What one factorization takes.
struct Effort {
  double entries = 0;    ///< numbers that the factor stores
  double operations = 0; ///< of floating point
};

/// Analyses a pattern once, then factors new values of it again and again without heap allocation.
class Cholesky {
public:
  /// The pattern must be in elimination order; the last `trailing` unknowns are those to eliminate onto.
  Cholesky(Pattern pattern, Index trailing);
  ~Cholesky();
  Cholesky(Cholesky const&) = delete;
  Cholesky& operator=(Cholesky const&) = delete;

  /// values[entries] of the lower triangle. False if the matrix is not positive definite; that of no
  /// unknowns is.
  [[nodiscard]] bool factorize(std::span<double const> values);
  /// Solves A x = b in place; b[n].
  void solve(Vector& b);
  /// The halves of solve: z = L^-1 b, then b = L^-T z, in place. Between them what acts on the trailing
  /// unknowns only may be added to z as (trailing factor)^-1 of it.
  void forward(Vector& b);
  void backward(Vector& z);
  /// L^-1 B in place. [n, any]
  void forward(Dense& B);
  /// Lower triangular factor of the Schur complement onto the trailing unknowns. [trailing, trailing]
  [[nodiscard]] Dense const& trailing_factor();
  /// Inverse of the Schur complement onto the trailing unknowns: the trailing block of A^-1. [trailing,
  /// trailing]
  [[nodiscard]] Dense const& trailing_inverse();
  [[nodiscard]] Pattern const& pattern() const { return pattern_; }
  [[nodiscard]] Effort effort() const;

private:
  struct Workspace;
  void solve_system(int system, Eigen::Ref<Dense> B);

  Pattern pattern_;
  Index trailing_;
  Dense trailing_factor_, inverse_;
  bool factor_ready_ = false, inverse_ready_ = false;
  std::unique_ptr<Workspace> work_;
};

/// CHOLMOD's version, for the manifest.
[[nodiscard]] std::string cholmod_version();

} // namespace stiction::linear
