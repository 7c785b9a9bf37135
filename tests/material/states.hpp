// Deformation gradients that every law is asked for, and the Cauchy stress of one.
#pragma once
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <vector>

#include "material/samples.hpp"

namespace stiction::test {

inline Matrix3 rotation() {
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

/// Two and three equal stretches, and such that nearly are, in directions off the axes.
template<int N> std::vector<Matrix3> coalescing() {
  Matrix3 const Q = N == 6 ? rotation() : Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<Matrix3> all;
  for (double const gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    double const near = 1.2 * (1 + gap), nearer = 1.2 * (1 + 0.3 * gap);
    for (auto const& stretches : {Eigen::Vector3d(1.2, near, nearer), Eigen::Vector3d(1.2, near, 0.9),
                                  Eigen::Vector3d(1.2, 0.9, near), Eigen::Vector3d(0.9, 1.2, near)})
      all.emplace_back(stretches.asDiagonal() * Q);
  }
  return all;
}

/// Rest, moderate, stretched twofold with shear, squeezed to a third, then the coalescing ones.
template<int N> std::vector<Matrix3> states() {
  Matrix3 moderate, stretched, squeezed;
  moderate << 1.08, 0.05, 0.02, -0.04, 0.93, 0.03, 0.01, -0.02, 1.04;
  stretched << 2.0, 0.9, 0.3, 0.1, 0.8, -0.2, -0.1, 0.25, 1.3;
  squeezed << 0.35, 0.02, 0.1, -0.05, 1.2, 0.0, 0.05, 0.1, 0.7;
  std::vector<Matrix3> all{Matrix3::Identity(), moderate, stretched, squeezed};
  if (N == 4)
    for (auto& F : all)
      F(0, 2) = F(2, 0) = F(1, 2) = F(2, 1) = 0;
  for (auto const& F : coalescing<N>())
    all.push_back(F);
  return all;
}

template<class Law> material::Response<6> respond(Law const& law, Matrix3 const& F) {
  return law.template respond<6>(green<6>(F));
}

/// F S F^T / J.
template<class Law> Matrix3 cauchy(Law const& law, Matrix3 const& F) {
  return F * tensor(respond(law, F).stress) * F.transpose() / F.determinant();
}

/// Simple shear in the plane 12.
inline Matrix3 shear(double g) {
  Matrix3 F = Matrix3::Identity();
  F(0, 1) = g;
  return F;
}

} // namespace stiction::test
