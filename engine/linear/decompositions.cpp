// The one place where these templates are made.
#include "linear/decompositions.hpp"

namespace Eigen {

template LLT<stiction::Dense>& LLT<stiction::Dense>::compute(DenseBaseOf const&);
template void PartialPivLU<stiction::Dense>::compute();
template void FullPivLU<stiction::Dense>::computeInPlace();
template void HouseholderQR<stiction::Dense>::computeInPlace();
template void ColPivHouseholderQR<stiction::Dense>::computeInPlace();
template ColPivHouseholderQR<stiction::Dense>&
ColPivHouseholderQR<stiction::Dense>::compute(DenseBaseOf const&);
template void ColPivHouseholderQR<stiction::Dense>::_solve_impl(stiction::Vector const&,
                                                                stiction::Vector&) const;
template SelfAdjointEigenSolver<stiction::Dense>&
SelfAdjointEigenSolver<stiction::Dense>::compute(DenseBaseOf const&, int);
template JacobiSVD<stiction::Dense>& JacobiSVD<stiction::Dense>::compute(stiction::Dense const&,
                                                                         unsigned int);

} // namespace Eigen

namespace stiction::linear {

Dense first_columns(Eigen::HouseholderSequence<Dense, Vector> const& Q, Eigen::Index count) {
  return Q * Dense::Identity(Q.rows(), count);
}

Dense pseudo_inverse(Dense const& A) {
  Eigen::SelfAdjointEigenSolver<Dense> const parts(A);
  Vector values = parts.eigenvalues();
  double const least = 1e-10 * values[values.size() - 1];
  for (double& value : values)
    value = value > least ? 1 / value : 0;
  return parts.eigenvectors() * values.asDiagonal() * parts.eigenvectors().transpose();
}

Dense negative_part(Dense const& A) {
  Eigen::SelfAdjointEigenSolver<Dense> const parts(A);
  return parts.eigenvectors() * parts.eigenvalues().cwiseMin(0).asDiagonal() *
         parts.eigenvectors().transpose();
}

bool monotone(Dense const& A, double least) {
  Dense symmetric = 0.5 * (A + A.transpose());
  symmetric.diagonal().array() += least;
  return Eigen::LLT<Dense>(symmetric).info() == Eigen::Success;
}

} // namespace stiction::linear
