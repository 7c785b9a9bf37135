// Relaxation beside any law: Maxwell networks, the terms of Prony series of the shear and the bulk modulus.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "material/isotropic.hpp"

namespace stiction::material {

inline constexpr std::size_t most_prony_terms = 20;

/// A network of moduli G_k, K_k or both that forgets its strain in the time tau_k: G(t) = G + sum G_k exp(-t
/// / tau_k) and K(t) alike, G and K the shear and the bulk modulus of the law at rest.
struct PronyTerm {
  double share = 0;        ///< G_k / G, 1; 0: `modulus` says it
  double modulus = 0;      ///< G_k, Pa
  double time = 0;         ///< tau_k, s
  double bulk_share = 0;   ///< K_k / K, 1; 0: `bulk_modulus` says it
  double bulk_modulus = 0; ///< K_k, Pa
  [[nodiscard]] bool in_shear() const { return share > 0 || modulus > 0; }
  [[nodiscard]] bool in_volume() const { return bulk_share > 0 || bulk_modulus > 0; }
  /// G_k beside a law of this shear modulus at rest, Pa.
  [[nodiscard]] double stiffness(double shear) const { return modulus > 0 ? modulus : share * shear; }
  /// K_k beside a law of this bulk modulus at rest, Pa.
  [[nodiscard]] double bulk_stiffness(double bulk) const {
    return bulk_modulus > 0 ? bulk_modulus : bulk_share * bulk;
  }

  [[nodiscard]] core::Complaints check() const {
    core::Complaints found;
    if (share > 0 && modulus > 0)
      found.push_back({"", "share", "and modulus both say how stiff the term is; leave one of them out"});
    if (bulk_share > 0 && bulk_modulus > 0)
      found.push_back({"", "bulk_share",
                       "and bulk_modulus both say how stiff the term is in volume; leave one of them out"});
    if (!in_shear() && !in_volume())
      found.push_back({"", "share",
                       "or modulus has to be more than 0: how stiff the term is, over the law's shear "
                       "modulus at rest, or in Pa; or bulk_share or bulk_modulus, in volume"});
    return found;
  }
  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<PronyTerm>{"prony",
                                  "a term of relaxation: G(t) = G + sum G_k exp(-t / tau_k), K(t) = K + sum "
                                  "K_k exp(-t / tau_k), G and K of the law at rest",
                                  "physics.md 4"}
            .number("share", &PronyTerm::share, "1", core::non_negative, Need::optional,
                    "G_k over the shear modulus of the bulk law at rest; or give `modulus`")
            .number("modulus", &PronyTerm::modulus, "Pa", core::non_negative, Need::optional,
                    "G_k, where `share` is left out")
            .number("time", &PronyTerm::time, "s", core::positive, Need::required, "tau_k")
            .number("bulk_share", &PronyTerm::bulk_share, "1", core::non_negative, Need::optional,
                    "K_k over the bulk modulus of the bulk law at rest; or give `bulk_modulus`")
            .number("bulk_modulus", &PronyTerm::bulk_modulus, "Pa", core::non_negative, Need::optional,
                    "K_k, where `bulk_share` is left out; without both the term leaves the volume alone")
            .build();
    return made;
  }
};

/// What a network does in a step of size dt, while the metric that it follows goes straight from one to the
/// next. Volume networks of modulus K_k follow ln J in the same way. V and W are (I - A) / 2 and (I - C'^-1)
/// / 2, C' = J^-2/3 C; with small strains the network's and the body's strain deviators. dV/dt = (W - V) /
/// tau gives V1 = keep V0 + before W0 + after W1, and the lag W - V at a part y = exp(-t / tau) of the step's
/// fading is y (W0 - V0) + (1 - y) (W1 - W0) tau / dt.
struct NetworkStep {
  double modulus = 0;                     ///< G_k or K_k, Pa
  double keep = 1, before = 0, after = 0; ///< sum to 1; none is negative
  /// Integrals over the step of the products of the two parts of the lag, over tau: a matrix that is never
  /// negative.
  double fading = 0, mixed = 0, flowing = 0;
  double middle = 0.5; ///< where between A0 and A1 the weight of the lag is taken

  NetworkStep() = default;
  /// dt >= 0; 0: at present.
  NetworkStep(double stiffness, double time, double dt) : modulus(stiffness) {
    double const x = dt / time, gone = -std::expm1(-x);
    if (x == 0)
      return;
    keep = std::exp(-x);
    before = std::max(gone / x - keep, 0.0);
    after = std::max(1 - keep - before, 0.0);
    fading = gone - gone * gone / 2;
    mixed = gone * (gone / x) / 2;
    flowing = x < 1e-2 ? x * (1.0 / 3 - x * (0.25 - x * (7.0 / 60 - x * (1.0 / 24 - x * 31 / 2520))))
                       : (1 - gone / x - gone * (gone / x) / 2) / x;
    middle = (1 + 2 * keep) / (3 + 3 * keep);
  }
  /// What is left of the modulus at the step's end, Pa.
  [[nodiscard]] double left() const { return modulus * (keep + before); }
};

[[nodiscard]] inline double inverse_cbrt(double x) {
  return 1 / std::cbrt(x);
}

/// Symmetric tensor of a stress-like vector.
template<int N, class S> [[nodiscard]] Tensor<S> full(Voigt<N, S> const& v) {
  Tensor<S> T = Tensor<S>::Zero();
  T.diagonal() = v.template head<3>();
  T(0, 1) = T(1, 0) = v[3];
  if constexpr (N == 6) {
    T(1, 2) = T(2, 1) = v[4];
    T(0, 2) = T(2, 0) = v[5];
  }
  return T;
}

// Loops over a few numbers below, not expressions: Packs have no others that compilers always put in place.

/// Symmetric tensor of a strain-like vector C = I + 2 E, as stress-like vector.
template<int N, class S> [[nodiscard]] EIGEN_ALWAYS_INLINE Voigt<N, S> green_metric(Voigt<N, S> const& E) {
  Voigt<N, S> C;
  for (int i = 0; i < N; ++i)
    C[i] = i < 3 ? S(1 + 2 * E[i]) : E[i];
  return C;
}
/// det(A) A^-1 of stress-like vectors, and det(A).
template<int N, class S>
EIGEN_ALWAYS_INLINE void minors_of(Voigt<N, S> const& A, Voigt<N, S>& minors, S& determinant) {
  if constexpr (N == 4) {
    minors[0] = A[1] * A[2];
    minors[1] = A[0] * A[2];
    minors[2] = A[0] * A[1] - A[3] * A[3];
    minors[3] = -A[3] * A[2];
    determinant = A[2] * minors[2];
  } else {
    minors[0] = A[1] * A[2] - A[4] * A[4];
    minors[1] = A[0] * A[2] - A[5] * A[5];
    minors[2] = A[0] * A[1] - A[3] * A[3];
    minors[3] = A[4] * A[5] - A[3] * A[2];
    minors[4] = A[3] * A[5] - A[4] * A[0];
    minors[5] = A[3] * A[4] - A[5] * A[1];
    determinant = A[0] * minors[0] + A[3] * minors[3] + A[5] * minors[5];
  }
}
/// A : B of stress-like vectors.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE S contraction(Voigt<N, S> const& A, Voigt<N, S> const& B) {
  S sum = A[0] * B[0] + A[1] * B[1] + A[2] * B[2], shear = A[3] * B[3];
  for (int i = 4; i < N; ++i)
    shear += A[i] * B[i];
  return sum + 2 * shear;
}
/// Entry (i, j) of a stress-like vector is its component place(i, j).
[[nodiscard]] constexpr int place(int i, int j) {
  return i == j ? i : i + j == 1 ? 3 : i + j == 3 ? 4 : 5;
}
/// Are entries (i, j) where N = 4 keeps direction 3 apart?
template<int N> [[nodiscard]] constexpr bool coupled(int i, int j) {
  return N == 6 || (i == 2) == (j == 2);
}
/// A B of two symmetric tensors.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE Tensor<S> product(Voigt<N, S> const& A, Voigt<N, S> const& B) {
  Tensor<S> C;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      C(i, j) = 0;
      for (int k = 0; k < 3; ++k)
        if (coupled<N>(i, k) && coupled<N>(k, j))
          C(i, j) += A[place(i, k)] * B[place(k, j)];
    }
  return C;
}

/// All networks at one point within a step: S = J^-2/3 Dev(m I - 2 P), which derives from the energy
/// J^-2/3 (m I - 2 P) : C / 2, for what the step adds to A along C'^-1 makes no stress. With small strains
/// S = 2 m dev(E) - 2 P.
template<int N, Wanted wanted, class S>
EIGEN_ALWAYS_INLINE void add_networks(bool small, double m, Voigt<N, S> const& P, Voigt<N, S> const& strain,
                                      Response<N, S>& response) {
  auto& [energy, stress, D] = response;
  if (small) {
    S const mean = (strain[0] + strain[1] + strain[2]) / 3;
    for (int i = 0; i < N; ++i)
      stress[i] += (i < 3 ? S(2 * m * (strain[i] - mean)) : S(m * strain[i])) - 2 * P[i];
    for (int i = 0; wanted == Wanted::tangent && i < N; ++i) {
      D(i, i) += i < 3 ? 2 * m : m;
      for (int j = 0; j < 3 && i < 3; ++j)
        D(i, j) -= 2 * m / 3;
    }
    return;
  }
  Voigt<N, S> const C = green_metric<N>(strain);
  Voigt<N, S> inverse, M;
  S determinant;
  minors_of<N>(C, inverse, determinant);
  S const p = inverse_cbrt(determinant), reciprocal = 1 / determinant;
  for (int i = 0; i < N; ++i) {
    inverse[i] *= reciprocal;
    M[i] = p * (i < 3 ? S(m - 2 * P[i]) : S(-2 * P[i]));
  }
  S const trace = contraction<N>(M, C);
  for (int i = 0; i < N; ++i)
    stress[i] += M[i] - trace / 3 * inverse[i];
  if constexpr (wanted == Wanted::tangent) {
    Voigt<N, S> side;
    for (int i = 0; i < N; ++i)
      side[i] = trace / 9 * inverse[i] - 2.0 / 3 * M[i];
    D += (2.0 / 3 * trace) * symmetric_square<N>(full<N>(inverse));
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        D(i, j) += inverse[i] * side[j] + side[i] * inverse[j];
  }
}

/// (I - C'^-1) / 2 of a strain, as stress-like vector; of small strains the deviator.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE Voigt<N, S> metric_strain(bool small, Voigt<N, S> const& strain) {
  Voigt<N, S> W;
  if (small) {
    S const mean = (strain[0] + strain[1] + strain[2]) / 3;
    for (int i = 0; i < N; ++i)
      W[i] = i < 3 ? S(strain[i] - mean) : S(0.5 * strain[i]);
    return W;
  }
  S determinant;
  minors_of<N>(green_metric<N>(strain), W, determinant);
  S const p = inverse_cbrt(determinant), half = -0.5 * p * p;
  for (int i = 0; i < N; ++i)
    W[i] = i < 3 ? S(0.5 + half * W[i]) : S(half * W[i]);
  return W;
}

/// All volume networks at one point within a step: S = (m e - n) C^-1 with e = ln J, or (m e - n) I with e =
/// tr(E) of small strains, which derives from m/2 e^2 - n e.
template<int N, Wanted wanted, class S>
EIGEN_ALWAYS_INLINE void add_volume_networks(bool small, double m, S const& n, Voigt<N, S> const& strain,
                                             Response<N, S>& response) {
  auto& [energy, stress, D] = response;
  if (small) {
    S const pressed = m * (strain[0] + strain[1] + strain[2]) - n;
    for (int i = 0; i < 3; ++i) {
      stress[i] += pressed;
      for (int j = 0; wanted == Wanted::tangent && j < 3; ++j)
        D(i, j) += m;
    }
    return;
  }
  using std::log;
  Voigt<N, S> inverse;
  S determinant;
  minors_of<N>(green_metric<N>(strain), inverse, determinant);
  S const reciprocal = 1 / determinant, pressed = 0.5 * m * log(determinant) - n;
  for (int i = 0; i < N; ++i) {
    inverse[i] *= reciprocal;
    stress[i] += pressed * inverse[i];
  }
  if constexpr (wanted == Wanted::tangent) {
    D -= (2 * pressed) * symmetric_square<N>(full<N>(inverse));
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j)
        D(i, j) += m * inverse[i] * inverse[j];
  }
}

/// ln J of a strain; tr(E) of small strains.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE S volume_strain(bool small, Voigt<N, S> const& strain) {
  if (small)
    return strain[0] + strain[1] + strain[2];
  using std::log;
  Voigt<N, S> unused;
  S determinant;
  minors_of<N>(green_metric<N>(strain), unused, determinant);
  return 0.5 * log(determinant);
}

/// Per volume: energy that a network holds and what it has dissipated in a step, J/m^3.
template<class S> struct NetworkEnergy { S stored = 0, dissipated = 0; };

/// What volume network k, with a0, does while ln J goes straight from one value to the other; a1 is left in
/// a. It holds K/2 (ln J - a)^2 and dissipates K / tau (ln J - a)^2, which is integrated exactly.
template<class S>
EIGEN_ALWAYS_INLINE void pass_volume(NetworkStep const& k, S const& from, S const& to, S& a,
                                     NetworkEnergy<S>& energy) {
  S const lag = from - a, way = to - from;
  a = k.keep * a + k.before * from + k.after * to;
  S const held = to - a;
  energy.stored += k.modulus / 2 * held * held;
  energy.dissipated += k.modulus * (k.fading * lag * lag + 2 * k.mixed * lag * way + k.flowing * way * way);
}

/// The metrics of a body at a point before and after a step, which all networks there follow.
template<int N, class S> struct MetricMove {
  Voigt<N, S> from, to, way; ///< W0, W1, W1 - W0
  bool small;
  // of finite strains:
  Voigt<N, S> metric, middle; ///< C' at the end, and the inverse of the mean of C'^-1
  S trace;                    ///< of C'
  Tensor<S> flow;             ///< middle times way

  EIGEN_ALWAYS_INLINE MetricMove(bool small_strain, Voigt<N, S> const& before, Voigt<N, S> const& after)
      : from(before), to(after), small(small_strain) {
    for (int i = 0; i < N; ++i)
      way[i] = to[i] - from[i];
    if (small)
      return;
    Voigt<N, S> mean;
    for (int i = 0; i < N; ++i)
      mean[i] = 0.5 * (from[i] + to[i]);
    static_cast<void>(invert(to, metric));
    static_cast<void>(invert(mean, middle));
    trace = metric[0] + metric[1] + metric[2];
    flow = product<N>(middle, way);
  }

  /// inverse = (I - 2 V)^-1; det(I - 2 V).
  static EIGEN_ALWAYS_INLINE S invert(Voigt<N, S> const& V, Voigt<N, S>& inverse) {
    Voigt<N, S> A;
    for (int i = 0; i < N; ++i)
      A[i] = i < 3 ? S(1 - 2 * V[i]) : S(-2 * V[i]);
    S determinant;
    minors_of<N>(A, inverse, determinant);
    S const reciprocal = 1 / determinant;
    for (int i = 0; i < N; ++i)
      inverse[i] *= reciprocal;
    return determinant;
  }

  /// What network k, with V0, does; V1 is left in V. It holds G/2 (tr(C' A) - 3 - ln det A) and dissipates
  /// G / (2 tau) tr(C' Z A^-1 Z), Z = A - C'^-1, here with C' and A of within the step and the exact course
  /// of Z: never less than nothing, exact of small strains, of second order in dt otherwise.
  EIGEN_ALWAYS_INLINE void pass(NetworkStep const& k, Voigt<N, S>& V, NetworkEnergy<S>& energy) const {
    Voigt<N, S> lag, within;
    for (int i = 0; i < N; ++i) {
      S const before = V[i];
      lag[i] = from[i] - before;
      V[i] = k.keep * before + k.before * from[i] + k.after * to[i];
      within[i] = before + k.middle * (V[i] - before);
    }
    double const G = k.modulus;
    if (small) {
      for (int i = 0; i < N; ++i)
        within[i] = to[i] - V[i];
      energy.stored += G * contraction<N>(within, within);
      energy.dissipated += 2 * G *
                           (k.fading * contraction<N>(lag, lag) + 2 * k.mixed * contraction<N>(lag, way) +
                            k.flowing * contraction<N>(way, way));
      return;
    }
    using std::log;
    Voigt<N, S> weight, unused;
    static_cast<void>(invert(within, weight));
    S const determinant = invert(V, unused);
    energy.stored += G / 2 * (trace - 2 * contraction<N>(metric, V) - 3 - log(determinant));
    energy.dissipated += 2 * G * dissipated(k, lag, weight);
  }

private:
  /// tr(C Z W Z) and tr(C R W R) and twice tr(C R W Z) in their shares: R of `way`, Z the lag, W the weight.
  [[nodiscard]] EIGEN_ALWAYS_INLINE S dissipated(NetworkStep const& k, Voigt<N, S> const& lag,
                                                 Voigt<N, S> const& weight) const {
    Tensor<S> const fade = product<N>(middle, lag), left = product<N>(weight, lag),
                    right = product<N>(weight, way);
    S sum = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (coupled<N>(i, j))
          sum += (k.fading * fade(i, j) + k.mixed * flow(i, j)) * left(j, i) +
                 (k.mixed * fade(i, j) + k.flowing * flow(i, j)) * right(j, i);
    return sum;
  }
};

} // namespace stiction::material
