// Eigen's decompositions of dense matrices, made once: in every file that uses them they cost seconds to
// compile.
#pragma once
#include <Eigen/Dense>

#include "core/types.hpp"

namespace Eigen {

// Of what is used, each member: explicit instantiations of classes leave out the templates among these.
using DenseBaseOf = EigenBase<stiction::Dense>;
extern template LLT<stiction::Dense>& LLT<stiction::Dense>::compute(DenseBaseOf const&);
extern template void PartialPivLU<stiction::Dense>::compute();
extern template void FullPivLU<stiction::Dense>::computeInPlace();
extern template void HouseholderQR<stiction::Dense>::computeInPlace();
extern template void ColPivHouseholderQR<stiction::Dense>::computeInPlace();
extern template ColPivHouseholderQR<stiction::Dense>&
ColPivHouseholderQR<stiction::Dense>::compute(DenseBaseOf const&);
extern template void ColPivHouseholderQR<stiction::Dense>::_solve_impl(stiction::Vector const&,
                                                                       stiction::Vector&) const;
extern template SelfAdjointEigenSolver<stiction::Dense>&
SelfAdjointEigenSolver<stiction::Dense>::compute(DenseBaseOf const&, int);
extern template JacobiSVD<stiction::Dense>& JacobiSVD<stiction::Dense>::compute(stiction::Dense const&,
                                                                                unsigned int);

} // namespace Eigen

namespace stiction::linear {

/// The first columns of Q of one of the decompositions Q R.
[[nodiscard]] Dense first_columns(Eigen::HouseholderSequence<Dense, Vector> const& Q, Eigen::Index count);

/// Of a symmetric matrix; eigenvalues below 1e-10 of the largest count as zero.
[[nodiscard]] Dense pseudo_inverse(Dense const& A);

/// Of a symmetric matrix, the modes whose eigenvalues are negative.
[[nodiscard]] Dense negative_part(Dense const& A);

/// Is the symmetric part positive semi-definite, but for `least`?
[[nodiscard]] bool monotone(Dense const& A, double least);

} // namespace stiction::linear
