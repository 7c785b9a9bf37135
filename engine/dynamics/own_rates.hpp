// Contact nodes whose rates follow another rule than those of all others: what their viscosity adds to the
// symmetric effective stiffness.
#pragma once
#include "linear/cholesky.hpp"

namespace stiction::dynamics {

/// The columns B of contact unknowns beside a factored matrix S = L L^T, eliminated onto those unknowns: of
/// S + B, which is not symmetric, the factor of the interior is that of S.
class OwnRates {
public:
  struct Entry {
    Index row, column; ///< unknown; contact unknown, from the first of them on
    double value;      ///< N/m
  };

  /// False if S + B is singular on the contact unknowns.
  [[nodiscard]] bool add(linear::Cholesky& factor, std::vector<Entry> entries, Index trailing);
  /// Inverse of the Schur complement of S + B onto the contact unknowns. [trailing, trailing]
  [[nodiscard]] Dense const& inverse() const { return inverse_; }
  /// From z = L^-1 b the contact unknowns of (S + B)^-1 b.
  [[nodiscard]] Vector reduce(linear::Cholesky& factor, Vector const& z) const;
  /// From z = L^-1 b what L^-T makes the solution for b + push; push: on the contact unknowns.
  void recover(linear::Cholesky& factor, Vector const& push, Vector& z);

private:
  std::vector<Entry> entries_;
  Dense inverse_;
  Vector interior_;
};

} // namespace stiction::dynamics
