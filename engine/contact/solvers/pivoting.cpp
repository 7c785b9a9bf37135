// The complementarity problem of Coulomb's friction with facets: pressures, friction along facets, slips.
#include "contact/solvers/pivoting.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contact/solvers/complementarity.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr int facets_in_space = 8;
constexpr double shaken = 1e-8;   // of q, where pivots go in circles or astray, as rows are tied
constexpr double patience = 4e10; // entries changed, of problems that have an answer
constexpr double tied = 1e-9;     // of the largest force or way: less is none

/// x = free + W (p - A rtilde) with the bonds linear about some x, and the coefficients there.
struct Linear {
  Dense W;
  Vector free, bonds; ///< bonds: A rtilde at zero x
  Dense slope;        ///< [dim n, dim] d(A rtilde)/dx by blocks
  std::vector<double> mu;
};

template<int D> Linear linear_about(Problem const& problem, Vector const& x, Vector const& force) {
  Index const n = D * problem.size();
  Linear linear{problem.W.dense(), problem.free, Vector::Zero(n), Dense::Zero(n, D), {}};
  bool bonded = false;
  for (Index i = 0; i < problem.size(); ++i) {
    Local<D> at = x.segment<D>(D * i);
    auto const state = evaluate<D>(problem, i, force.segment<D>(D * i), at, natural_scale(problem, i));
    linear.mu.push_back(state.mu);
    if (problem.points[ix(i)].adhesion < 0)
      continue;
    bonded = true;
    linear.slope.middleRows<D>(D * i) = state.adhesion_by_x;
    linear.bonds.segment<D>(D * i) = force.segment<D>(D * i) - state.dry - state.adhesion_by_x * at;
  }
  if (!bonded)
    return linear;
  Dense const W = std::move(linear.W);
  Dense system = Dense::Identity(n, n);
  for (Index i = 0; i < problem.size(); ++i)
    system.middleCols<D>(D * i).noalias() -= W.middleCols<D>(D * i) * linear.slope.middleRows<D>(D * i);
  Eigen::PartialPivLU<Dense> const factor(system);
  linear.W = factor.solve(W);
  linear.free = factor.solve(Vector(problem.free + W * linear.bonds));
  return linear;
}

/// Forces p of the dry forces.
template<int D> Vector whole(Linear const& linear, Vector const& dry) {
  Vector const x = linear.free + linear.W * dry;
  Vector force = dry + linear.bonds;
  for (Index i = 0; D * i < dry.size(); ++i)
    force.segment<D>(D * i) += linear.slope.middleRows<D>(D * i) * x.segment<D>(D * i);
  return force;
}

/// Unknowns of a point: pressure; with friction also forces along the facets, and the slip.
template<int D> class Cone {
public:
  Cone(Problem const& problem, Linear const& linear, int facets) : linear_(linear) {
    facets = D == 2 ? 2 : facets;
    for (Index i = 0; i < problem.size(); ++i) {
      first_.push_back(rows_);
      add(i, Local<D>::Unit(0));
      scale_.push_back(std::sqrt(natural_scale(problem, i)));
      for (int k = 0; k < facets && linear.mu[ix(i)] > 0; ++k)
        add(i, along(k, facets));
      slip_.push_back(linear.mu[ix(i)] > 0 ? rows_++ : -1);
    }
    shifted_ = linear.free;
    for (Index i = 0; i < problem.size(); ++i)
      shifted_.segment<D>(D * i) -= problem.points[ix(i)].shift.head<D>();
  }
  [[nodiscard]] Index rows() const { return rows_; }

  /// w = q + M z with forces over sqrt(rho) and displacements times it, about one in size.
  void fill(Dense& M, Vector& q) {
    auto const count = static_cast<Index>(ways_.size());
    Dense directions = Dense::Zero(shifted_.size(), count); // columns: force of a unit of each unknown
    for (Index k = 0; k < count; ++k) {
      auto const& way = ways_[ix(k)];
      directions.col(k).segment<D>(D * way.point) = scale_[ix(way.point)] * way.direction;
    }
    Dense const G = directions.transpose() * linear_.W * directions;
    Vector const g = directions.transpose() * shifted_;
    size_ = std::max(g.size() > 0 ? g.lpNorm<Eigen::Infinity>() : 0.0, 1e-300);
    M.setZero(rows_, rows_);
    q.setZero(rows_);
    for (Index k = 0; k < count; ++k) {
      auto const& way = ways_[ix(k)];
      q[way.row] = g[k] / size_;
      for (Index l = 0; l < count; ++l)
        M(way.row, ways_[ix(l)].row) = G(k, l);
      Index const slip = slip_[ix(way.point)];
      if (slip < 0)
        continue;
      M(slip, way.row) = way.normal ? linear_.mu[ix(way.point)] : -1;
      M(way.row, slip) = way.normal ? 0 : 1;
    }
  }

  /// The rows at rest where points do as the status of these dry forces says.
  [[nodiscard]] std::vector<Index> held(Problem const& problem, Vector const& force, From from) const {
    std::vector<Index> set;
    if (from == From::nothing)
      return set;
    Vector const x = displacement(problem, force);
    for (Index i = 0; i < problem.size(); ++i) {
      auto const state =
          evaluate<D>(problem, i, force.segment<D>(D * i), x.segment<D>(D * i), natural_scale(problem, i));
      bool const given = problem.W.diagonal(D * i) == 0; // nothing moves it
      if (given || (state.status == interface::Status::open && from == From::statuses))
        continue;
      set.push_back(first_[ix(i)]);
      if (from == From::closed || slip_[ix(i)] < 0)
        continue;
      bool const slides = state.status == interface::Status::slip;
      Local<D> const trial = state.dry - state.residual;
      Index best = -1;
      double most = 0;
      for (auto const& way : ways_)
        if (way.point == i && !way.normal && way.direction.dot(trial) > most) {
          most = way.direction.dot(trial);
          best = way.row;
        }
      if (best < 0)
        continue;
      set.push_back(best);
      if (slides)
        set.push_back(slip_[ix(i)]);
    }
    return set;
  }

  [[nodiscard]] Vector forces(Vector const& z) const {
    Vector dry = Vector::Zero(shifted_.size());
    for (auto const& way : ways_)
      dry.segment<D>(D * way.point) += size_ * scale_[ix(way.point)] * z[way.row] * way.direction;
    return dry;
  }

private:
  struct Way {
    Index point, row;
    Local<D> direction;
    bool normal;
  };
  void add(Index point, Local<D> const& direction) {
    ways_.push_back({point, rows_++, direction, direction[0] != 0});
  }
  static Local<D> along(int k, int facets) {
    Local<D> direction = Local<D>::Zero();
    double const angle = 2 * std::numbers::pi * k / facets;
    if constexpr (D == 2)
      direction[1] = k == 0 ? 1 : -1;
    if constexpr (D == 3)
      direction.template tail<2>() << std::cos(angle), std::sin(angle);
    return direction;
  }

  Linear const& linear_;
  Index rows_ = 0;
  std::vector<Way> ways_;
  std::vector<Index> first_, slip_; ///< rows of a point's pressure and of its slip, or -1
  std::vector<double> scale_;
  Vector shifted_;
  double size_ = 1;
};

/// The same a little off, each row by another part, so that no rows are tied.
Vector shake(Vector const& q) {
  constexpr double golden = 0.6180339887498949;
  Vector off = q;
  for (Index i = 0; i < q.size(); ++i)
    off[i] += shaken * (0.5 + std::fmod(golden * (i + 1), 1.0));
  return off;
}

/// Without bonds there is an answer, which may take many pivots.
long most_shaken(Problem const& problem, Index rows) {
  long const few = 10L * rows + 100;
  bool const bonded =
      std::ranges::any_of(problem.points, [](auto const& point) { return point.adhesion >= 0; });
  auto const size = static_cast<double>(rows);
  return bonded ? few : std::max(few, std::min(100L * rows, static_cast<long>(patience / (size * size))));
}

template<int D>
std::optional<PivotedForces> pivot_in(Problem const& problem, Vector const& force, From from) {
  auto const linear = linear_about<D>(problem, displacement(problem, force), force);
  Cone<D> cone(problem, linear, facets_in_space);
  if (cone.rows() > pivoting_rows || !linear.W.allFinite())
    return std::nullopt;
  Dense M;
  Vector q;
  cone.fill(M, q);
  auto found = lemke_from(M, q, cone.held(problem, force, from), 10L * cone.rows() + 100);
  PivotedForces result;
  result.pivots = found.pivots;
  result.none = from == From::nothing && found.end == Pivoted::ray && proves_none(M, q, found.z);
  if (from == From::nothing && found.end != Pivoted::answered && !result.none) {
    found = lemke(M, shake(q), most_shaken(problem, cone.rows()));
    result.pivots += found.pivots;
  }
  if (found.end == Pivoted::answered)
    result.force = whole<D>(linear, cone.forces(found.z));
  return result;
}

/// What a point may do in the plane; the slides take the sign of their friction.
enum class Does { open, stick, slide_back, slide_on };

/// The dry forces in which every point does what it is told, checked against what it then must not do;
/// `single` turns false where it may do so with many forces.
std::optional<Vector> forces_of(Linear const& linear, Vector const& free, std::vector<Does> const& told,
                                bool& single) {
  auto const n = static_cast<Index>(told.size());
  Dense A = Dense::Zero(2 * n, 2 * n);
  Vector b = Vector::Zero(2 * n);
  auto const hold = [&](Index row) { // in newtons, like all other rows
    double const largest = linear.W.row(row).cwiseAbs().maxCoeff(), unit = largest > 0 ? 1 / largest : 1;
    A.row(row) = unit * linear.W.row(row);
    b[row] = -unit * free[row];
  };
  auto const sign = [&](Index i) { return told[ix(i)] == Does::slide_on ? 1.0 : -1.0; };
  for (Index i = 0; i < n; ++i) {
    A(2 * i, 2 * i) = A(2 * i + 1, 2 * i + 1) = told[ix(i)] == Does::open ? 1 : 0;
    if (told[ix(i)] == Does::open)
      continue;
    hold(2 * i);
    if (told[ix(i)] == Does::stick) {
      hold(2 * i + 1);
    } else { // each row in its own unit
      A(2 * i + 1, 2 * i + 1) = 1;
      A(2 * i + 1, 2 * i) = -sign(i) * linear.mu[ix(i)];
    }
  }
  Eigen::FullPivLU<Dense> const factor(A);
  Vector const dry = factor.solve(b), x = linear.W * dry + free;
  double const force = tied * dry.lpNorm<Eigen::Infinity>(), way = tied * free.lpNorm<Eigen::Infinity>();
  bool fits = dry.allFinite() && (A * dry - b).lpNorm<Eigen::Infinity>() <= force;
  single = single && (!fits || factor.isInvertible());
  for (Index i = 0; i < n && fits; ++i) {
    double const r = dry[2 * i], t = dry[2 * i + 1], s = x[2 * i + 1];
    if (told[ix(i)] == Does::open)
      fits = x[2 * i] >= -way;
    else if (told[ix(i)] == Does::stick)
      fits = r >= -force && std::abs(t) <= linear.mu[ix(i)] * r + force;
    else
      fits = r >= -force && -sign(i) * s >= -way;
  }
  return fits ? std::optional(dry) : std::nullopt;
}

} // namespace

Enumerated enumerate(Problem const& problem, Vector const& force) {
  Enumerated tried;
  if (problem.dim != 2 || problem.size() > enumerated)
    return tried;
  tried.all = true;
  auto const linear = linear_about<2>(problem, displacement(problem, force), force);
  Vector free = linear.free;
  for (Index i = 0; i < problem.size(); ++i)
    free.segment<2>(2 * i) -= problem.points[ix(i)].shift.head<2>();
  std::vector<Does> told(ix(problem.size()), Does::open);
  for (long all = 1L << (2 * problem.size()), k = 0; k < all; ++k) {
    for (Index i = 0; i < problem.size(); ++i)
      told[ix(i)] = static_cast<Does>((k >> (2 * i)) & 3);
    if (auto const dry = forces_of(linear, free, told, tried.all))
      tried.answers.push_back(whole<2>(linear, *dry));
  }
  return tried;
}

std::optional<PivotedForces> pivot(Problem const& problem, Vector const& force, From from) {
  return by_dimension(problem.dim, [&]<int D>() { return pivot_in<D>(problem, force, from); });
}

} // namespace stiction::contact
