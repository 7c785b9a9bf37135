// Conjugate gradients and GMRES with a preconditioner, for operators that are functions.
#pragma once
#include <cmath>
#include <limits>
#include <vector>

#include "core/types.hpp"

namespace stiction::linear {

/// How an iteration ended.
struct KrylovEnd {
  int iterations = 0;
  bool converged = false;
};

/// Of vectors that one process has whole.
struct WholeVectors {
  [[nodiscard]] double inner(Vector const& a, Vector const& b) const { return a.dot(b); }
  [[nodiscard]] double length(Vector const& a) const { return a.norm(); }
  [[nodiscard]] bool zero(Vector const& a) const { return a.isZero(0); }
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
  std::vector<Vector> v{b}, z;
  double const whole = vectors.length(b);
  KrylovEnd end;
  x.setZero(b.size());
  if (!(whole > 0) || !std::isfinite(whole)) {
    end.converged = whole == 0;
    return end;
  }
  v[0] /= whole;
  Dense H = Dense::Zero(limits.most + 1, limits.most);
  Vector g = Vector::Zero(limits.most + 1), cosine(limits.most), sine(limits.most);
  g[0] = whole;
  Index k = 0;
  for (; k < limits.most && !end.converged; ++k) {
    if (z.empty() || !limits.linear)
      z.emplace_back();
    precondition(v[ix(k)], z.back());
    v.emplace_back();
    apply(z.back(), v.back());
    Vector& w = v.back();
    for (Index i = 0; i <= k; ++i) {
      H(i, k) = vectors.inner(v[ix(i)], w);
      w -= H(i, k) * v[ix(i)];
    }
    H(k + 1, k) = vectors.length(w);
    if (!std::isfinite(H(k + 1, k)))
      return end;
    if (H(k + 1, k) > 0)
      w /= H(k + 1, k);
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
  auto const& kept = limits.linear ? v : z;
  for (Index i = 0; i < k; ++i)
    x += parts[i] * kept[ix(i)];
  if (limits.linear && k > 0) {
    precondition(x, z.back());
    x.swap(z.back());
  }
  return end;
}

} // namespace stiction::linear
