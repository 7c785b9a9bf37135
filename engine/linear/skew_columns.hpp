// Columns of surface unknowns beside a factored symmetric matrix, which make it unsymmetric.
#pragma once
#include <optional>

#include "linear/bulk_factor.hpp"
#include "linear/cholesky.hpp"
#include "linear/decompositions.hpp"
#include "linear/surface_columns.hpp"

namespace stiction::linear {

/// The columns B beside S = L L^T, eliminated onto the surface: of S + B the factor of the interior is that
/// of S.
class SkewColumns {
public:
  /// False if S + B is singular on the surface.
  [[nodiscard]] bool add(Cholesky& factor, std::vector<ColumnEntry> entries, Index surface);
  /// C(i, j): motion of surface unknown used[i] per load on used[j]; returns how many columns that took.
  long compliance(Indices const& used, Dense& C);
  [[nodiscard]] double numbers() const { return columns_->numbers(); }
  /// As of SurfaceColumns.
  [[nodiscard]] Indices known() const { return columns_->known(); }
  /// From z = L^-1 b the surface unknowns of (S + B)^-1 b.
  [[nodiscard]] Vector condense(Cholesky& factor, Vector const& z) const;
  /// From z = L^-1 b what L^-T makes the solution for b + surface_load; surface_load: on the surface.
  void expand(Cholesky& factor, Vector const& surface_load, Vector& z);

private:
  std::vector<ColumnEntry> entries_;
  Eigen::PartialPivLU<Dense> schur_; ///< Schur complement of S + B onto the surface
  std::optional<SurfaceColumns> columns_;
  Vector interior_;
};

} // namespace stiction::linear
