// Strain, force and stiffness of one quadrature point of a plane or axisymmetric cell.
#pragma once
#include <span>

#include "material/response.hpp"

namespace stiction::solid {

/// A cell with a fixed number of nodes, so that all its arithmetic is of fixed size.
template<class Law, int Nodes, bool Axisymmetric> struct Kernel {
  static constexpr int nodes = Nodes, dofs = 2 * Nodes;
  static constexpr bool axisymmetric = Axisymmetric;
  using Displacements = Eigen::Matrix<double, Nodes, 2, Eigen::RowMajor>;
  using Gradients = Eigen::Map<Displacements const>;
  using Hoop = Eigen::Map<Eigen::Matrix<double, Nodes, 1> const>;
  using Force = Eigen::Matrix<double, dofs, 1>;
  using Stiffness = Eigen::Matrix<double, dofs, dofs>;

  /// Geometry and material response at one point.
  struct PointState {
    Eigen::Matrix2d F; ///< in-plane deformation gradient that B uses (identity for small strains)
    double F33 = 1;
    double jacobian = 1; ///< det F
    material::Response<4> response;
  };

  template<material::Wanted wanted>
  static PointState evaluate(Law const& law, Gradients const& G, double const* hoop, Displacements const& u) {
    PointState point;
    Eigen::Matrix2d const H = u.transpose() * G;
    double const h = Axisymmetric ? u.col(0).dot(Hoop(hoop)) : 0.0;
    constexpr double quadratic = Law::small_strain ? 0.0 : 0.5;
    material::Voigt<4> strain;
    strain << H(0, 0) + quadratic * H.col(0).squaredNorm(), H(1, 1) + quadratic * H.col(1).squaredNorm(),
        h + quadratic * h * h, H(0, 1) + H(1, 0) + 2 * quadratic * H.col(0).dot(H.col(1));
    point.F.setIdentity();
    if constexpr (!Law::small_strain) {
      point.F += H;
      point.F33 = 1 + h;
      double const in_plane = point.F.determinant();
      point.jacobian = in_plane > 0 && point.F33 > 0 ? in_plane * point.F33 : 0.0;
    }
    if (point.jacobian > 0)
      point.response = law.template respond<4, wanted>(strain);
    return point;
  }

  /// Rows 11, 22, 33, 2*12 of dE/du.
  static Eigen::Matrix<double, 4, dofs> strain_operator(PointState const& point, Gradients const& G,
                                                        double const* hoop) {
    Eigen::Matrix<double, 4, dofs> B;
    auto const& F = point.F;
    for (int a = 0; a < Nodes; ++a)
      for (int i = 0; i < 2; ++i) {
        auto column = B.col(2 * a + i);
        column[0] = F(i, 0) * G(a, 0);
        column[1] = F(i, 1) * G(a, 1);
        column[2] = Axisymmetric && i == 0 ? point.F33 * hoop[a] : 0.0;
        column[3] = F(i, 0) * G(a, 1) + F(i, 1) * G(a, 0);
      }
    return B;
  }

  /// B^T D B + G S G^T, (41): material and initial-displacement part, then the geometric part.
  static void add_stiffness(PointState const& point, Gradients const& G, double const* hoop, double weight,
                            Stiffness& K) {
    auto const B = strain_operator(point, G, hoop);
    Eigen::Matrix<double, 4, dofs> const DB = (weight * point.response.tangent) * B;
    K.noalias() += B.transpose() * DB;
    if constexpr (!Law::small_strain) {
      auto const& S = point.response.stress;
      Eigen::Matrix2d in_plane;
      in_plane << S[0], S[3], S[3], S[1];
      Eigen::Matrix<double, Nodes, 2> const GS = weight * G * in_plane;
      for (int a = 0; a < Nodes; ++a)
        for (int b = 0; b < Nodes; ++b) {
          double const g = GS.row(a).dot(G.row(b));
          K(2 * a, 2 * b) += g;
          K(2 * a + 1, 2 * b + 1) += g;
          if constexpr (Axisymmetric)
            K(2 * a, 2 * b) += weight * S[2] * hoop[a] * hoop[b];
        }
    }
  }
};

} // namespace stiction::solid
