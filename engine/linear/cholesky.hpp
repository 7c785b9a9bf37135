// Supernodal Cholesky factorization with the Schur complement onto the trailing unknowns read off the factor.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "linear/pattern.hpp"

namespace stiction::linear {

/// Analyses a pattern once, then factors new values of it again and again without heap allocation.
class Cholesky {
public:
  /// The pattern must be in elimination order; the last `trailing` unknowns are those to eliminate onto.
  Cholesky(Pattern pattern, Index trailing);
  ~Cholesky();
  Cholesky(Cholesky const&) = delete;
  Cholesky& operator=(Cholesky const&) = delete;

  /// values[entries] of the lower triangle. False if the matrix is not positive definite.
  [[nodiscard]] bool factorize(std::span<double const> values);
  /// Solves A x = b in place; b[n].
  void solve(Vector& b);
  /// Inverse of the Schur complement onto the trailing unknowns: the trailing block of A^-1. [trailing,
  /// trailing]
  [[nodiscard]] Dense const& trailing_inverse();
  [[nodiscard]] Pattern const& pattern() const { return pattern_; }

private:
  struct Workspace;
  void gather_trailing_factor();

  Pattern pattern_;
  Index trailing_;
  Dense inverse_;
  bool inverse_ready_ = false;
  std::unique_ptr<Workspace> work_;
};

/// CHOLMOD's version, for the manifest.
[[nodiscard]] std::string cholmod_version();

} // namespace stiction::linear
