// Conjugate gradients and GMRES with a preconditioner, for operators that are functions.
#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/threads.hpp"

namespace stiction::linear {

/// How an iteration ended.
struct KrylovEnd {
  int iterations = 0;
  bool converged = false;
};

/// How GMRES keeps its vectors: as they are.
struct KeptWhole {
  using Kept = Vector;
  /// Of length one, from one of this length.
  [[nodiscard]] static Kept kept(Vector&& a, double length) {
    a /= length;
    return std::move(a);
  }
  [[nodiscard]] static Vector const& whole(Kept const& a) { return a; }
  static void add(double part, Kept const& a, Vector& to) { to += part * a; }
};

/// Of vectors that one process has whole.
struct WholeVectors : KeptWhole {
  [[nodiscard]] double inner(Vector const& a, Vector const& b) const { return a.dot(b); }
  [[nodiscard]] double length(Vector const& a) const { return a.norm(); }
  [[nodiscard]] bool zero(Vector const& a) const { return a.isZero(0); }
};

/// Those that GMRES keeps are kept in single precision: half of the room, for answers that need few digits.
/// Threads share them, with the same bits however many there are.
class ShortVectors {
public:
  using Kept = Eigen::VectorXf;
  [[nodiscard]] static Kept kept(Vector const& a, double length) {
    Kept to(a.size());
    core::each_piece(static_cast<Index>(a.size()), least, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i)
        to[i] = static_cast<float>(a[i] / length);
    });
    return to;
  }
  [[nodiscard]] Vector const& whole(Kept const& a) const {
    whole_.resize(a.size());
    add(1, a, whole_.setZero());
    return whole_;
  }
  static void add(double part, Kept const& a, Vector& to) {
    core::each_piece(static_cast<Index>(to.size()), least, [&](Index first, Index last) {
      for (Index i = first; i < last; ++i)
        to[i] += part * static_cast<double>(a[i]);
    });
  }
  [[nodiscard]] static double inner(Kept const& a, Vector const& b) {
    return sum(static_cast<Index>(b.size()), [&](Index i) { return static_cast<double>(a[i]) * b[i]; });
  }
  [[nodiscard]] static double length(Vector const& a) {
    return std::sqrt(sum(static_cast<Index>(a.size()), [&](Index i) { return a[i] * a[i]; }));
  }

private:
  static constexpr Index least = 4096; ///< numbers that a thread takes at a time
  /// In lanes, as the processor adds them.
  template<class Term> [[nodiscard]] static double sum(Index n, Term const& term) {
    return core::sum_of_pieces(n, least, [&](Index first, Index last) {
      constexpr Index lanes = 16;
      std::array<double, lanes> sums{};
      Index const end = last - (last - first) % lanes;
      for (Index i = first; i < end; i += lanes)
        for (Index k = 0; k < lanes; ++k)
          sums[ix(k)] += term(i + k);
      for (Index i = end; i < last; ++i)
        sums[0] += term(i);
      double all = 0;
      for (double const one : sums)
        all += one;
      return all;
    });
  }
  mutable Vector whole_;
};

/// When an iteration ends: at this part of the right-hand side, or after so many; how it takes products.
template<class Vectors = WholeVectors> struct KrylovLimits {
  double tolerance;
  int most;
  Vectors vectors{};
  bool linear = false; ///< is what the preconditioner makes of a sum the sum of what it makes?
};

/// A x = b from the x given, A symmetric. apply(x, y): y = A x; precondition(r, z). Ends at |r| <= tolerance
/// |b|; not converged after `most`, and where A or the preconditioner is not positive definite.
template<class Apply, class Precondition, class Vectors = WholeVectors>
KrylovEnd conjugate_gradients(Apply const& apply, Precondition const& precondition, Vector const& b,
                              Vector& x, KrylovLimits<Vectors> const& limits) {
  auto const& vectors = limits.vectors;
  Vector r = b, z, p, Ap;
  if (!vectors.zero(x)) {
    apply(x, Ap);
    r -= Ap;
  }
  double const enough = limits.tolerance * vectors.length(b);
  double before = 0;
  KrylovEnd end;
  for (;; ++end.iterations) {
    double const left = vectors.length(r);
    end.converged = left <= enough;
    if (end.converged || end.iterations == limits.most || !std::isfinite(left))
      return end;
    precondition(r, z);
    double const now = vectors.inner(r, z);
    if (!(now > 0))
      return end;
    p = end.iterations == 0 ? z : Vector(z + (now / before) * p);
    before = now;
    apply(p, Ap);
    double const curvature = vectors.inner(p, Ap);
    if (!(curvature > 0))
      return end;
    double const length = now / curvature;
    x += length * p;
    r -= length * Ap;
  }
}

/// A x = b from zero by GMRES (Saad & Schultz 1986), preconditioned from the right, so that what it makes
/// small is |b - A x|. Keeps `most` vectors, twice unless the preconditioner is linear, when it is applied
/// once more instead; does not restart.
template<class Apply, class Precondition, class Vectors = WholeVectors>
KrylovEnd gmres(Apply const& apply, Precondition const& precondition, Vector const& b, Vector& x,
                KrylovLimits<Vectors> const& limits) {
  auto const& vectors = limits.vectors;
  std::vector<typename Vectors::Kept> v, kept_z;
  double const whole = vectors.length(b);
  KrylovEnd end;
  x.setZero(b.size());
  if (!(whole > 0) || !std::isfinite(whole)) {
    end.converged = whole == 0;
    return end;
  }
  v.push_back(vectors.kept(Vector(b), whole));
  Dense H = Dense::Zero(limits.most + 1, limits.most);
  Vector g = Vector::Zero(limits.most + 1), cosine(limits.most), sine(limits.most);
  g[0] = whole;
  Index k = 0;
  for (; k < limits.most && !end.converged; ++k) {
    Vector w, z;
    precondition(vectors.whole(v[ix(k)]), z);
    apply(z, w);
    if (!limits.linear)
      kept_z.push_back(vectors.kept(std::move(z), 1));
    for (Index i = 0; i <= k; ++i) {
      H(i, k) = vectors.inner(v[ix(i)], w);
      vectors.add(-H(i, k), v[ix(i)], w);
    }
    H(k + 1, k) = vectors.length(w);
    if (!std::isfinite(H(k + 1, k)))
      return end;
    v.push_back(vectors.kept(std::move(w), H(k + 1, k) > 0 ? H(k + 1, k) : 1));
    for (Index i = 0; i < k; ++i) {
      double const upper = cosine[i] * H(i, k) + sine[i] * H(i + 1, k);
      H(i + 1, k) = cosine[i] * H(i + 1, k) - sine[i] * H(i, k);
      H(i, k) = upper;
    }
    double const size = std::hypot(H(k, k), H(k + 1, k));
    if (!(size > 0))
      return end;
    cosine[k] = H(k, k) / size;
    sine[k] = H(k + 1, k) / size;
    H(k, k) = size;
    g[k + 1] = -sine[k] * g[k];
    g[k] *= cosine[k];
    end.converged = std::abs(g[k + 1]) <= limits.tolerance * whole;
    end.iterations = k + 1;
  }
  Vector const parts = H.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
  auto const& kept = limits.linear ? v : kept_z;
  for (Index i = 0; i < k; ++i)
    vectors.add(parts[i], kept[ix(i)], x);
  if (limits.linear && k > 0) {
    Vector z;
    precondition(x, z);
    x.swap(z);
  }
  return end;
}

} // namespace stiction::linear
