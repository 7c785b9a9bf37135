// What a bulk law answers: energy, stress and tangent of one strain, in Voigt form.
#pragma once
#include <Eigen/Core>

namespace stiction::material {

/// Strain (11, 22, 33, 2*12 [, 2*23, 2*13]) or stress (11, 22, 33, 12 [, 23, 13]).
/// N = 4 serves plane strain and axisymmetry, N = 6 three dimensions: laws always see the full 3x3 state.
/// S: double, or Pack for four cells at once.
template<int N, class S = double> using Voigt = Eigen::Matrix<S, N, 1>;
template<int N, class S = double> using VoigtMatrix = Eigen::Matrix<S, N, N>;

/// How much of a Response is filled: force passes need no tangent.
enum class Wanted { stress, tangent };

/// W [J/m^3 of the reference volume], S = dW/dE [Pa], D = dS/dE [Pa] (physics.md 4; (35), (39)).
template<int N, class S = double> struct Response {
  S energy = 0;
  Voigt<N, S> stress;
  VoigtMatrix<N, S> tangent;
};

/// Young's modulus [Pa] and Poisson's ratio of the law at rest.
struct Moduli {
  double young = 0, poisson = 0;
  [[nodiscard]] static Moduli from(double shear, double bulk) {
    double const sum = 3 * bulk + shear;
    return {9 * bulk * shear / sum, (3 * bulk - 2 * shear) / (2 * sum)};
  }
  [[nodiscard]] double shear() const { return young / (2 * (1 + poisson)); }
  [[nodiscard]] double lame() const { return young * poisson / ((1 + poisson) * (1 - 2 * poisson)); }
  [[nodiscard]] double bulk() const { return young / (3 * (1 - 2 * poisson)); }
};

} // namespace stiction::material
