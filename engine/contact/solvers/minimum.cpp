// Newton's method on the potential in the coordinates z, where that of the bodies is |z|^2 / 2.
#include "contact/solvers/minimum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "contact/solvers/complementarity.hpp"
#include "contact/solvers/kept_hessian.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr double no_way = 1e-15; // over the least opening of a law: forces are all but zero
constexpr double enough_step = 1e-11, rounded_step = 1e-9; // over z; where it shrinks no more
constexpr double quick_contraction = 0.03;                 // of steps, with which the stiffness is kept
constexpr double slow_contraction = 0.3;                   // with which it is made anew
constexpr double slight_change = 1e-3; // of a bond's stiffness beside what else holds its point
constexpr double downhill_part = 1e-4; // of the descent that the gradient foretells
constexpr double longest_stride = 0.5; // of a law's opening
constexpr double harmless_stride = 1e-5;
constexpr int work_panels = 4; // of Simpson's rule for the work of a bond in one step

/// F of W = F F^T, by Cholesky, with pivots where W is singular; W scaled to a diagonal of one. Rows of W
/// that are zero, of points whose place is given, are zero in F.
struct Root {
  Dense F;        ///< [dim n, rank]
  Indices pivots; ///< rows of F that make a lower triangle
  bool sound = false;
};

/// Of a matrix of unit diagonal.
void factorize_with_pivots(Dense const& W, double least, Root& root) {
  Eigen::Index const n = W.rows();
  root.F.setZero(n, n);
  root.pivots.clear();
  Vector left = W.diagonal();
  Eigen::Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    if (!(left.maxCoeff(&pivot) > least))
      break;
    Vector column = W.col(pivot);
    column.noalias() -= root.F.leftCols(rank) * root.F.row(pivot).head(rank).transpose();
    column /= std::sqrt(left[pivot]);
    for (Index const before : root.pivots)
      column[before] = 0;
    root.F.col(rank) = column;
    left -= column.cwiseAbs2();
    left[pivot] = 0;
    root.pivots.push_back(pivot);
  }
  root.F.conservativeResize(n, rank);
  root.sound = left.minCoeff() > -100 * least;
}

Root root_of(Dense const& W) {
  auto const n = static_cast<Index>(W.rows());
  Root root;
  Indices rows;
  for (Index i = 0; i < n; ++i) {
    if (!(W(i, i) >= 0))
      return root;
    if (W(i, i) > 0)
      rows.push_back(i);
  }
  root.F.setZero(n, static_cast<Index>(rows.size()));
  root.sound = rows.empty();
  if (rows.empty())
    return root;
  auto const count = static_cast<Index>(rows.size());
  Vector const scale = Vector(W.diagonal()(rows)).cwiseSqrt();
  double const least = static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  Root own;
  own.F.resize(count, count); // of diagonal one; below it the factor takes its place
  for (Index j = 0; j < count; ++j)
    for (Index i = j; i < count; ++i) {
      Index const row = rows[ix(i)], column = rows[ix(j)];
      own.F(i, j) = own.F(j, i) = 0.5 * (W(row, column) + W(column, row)) / (scale[i] * scale[j]);
    }
  Eigen::LLT<Eigen::Ref<Dense>> const factor(own.F);
  own.sound = factor.info() == Eigen::Success && own.F.diagonal().minCoeff() > std::sqrt(least);
  if (own.sound) {
    own.pivots.resize(rows.size());
    std::iota(own.pivots.begin(), own.pivots.end(), Index{0});
    own.F.triangularView<Eigen::StrictlyUpper>().setZero();
  } else {
    Dense sound = own.F.selfadjointView<Eigen::Upper>();
    sound.diagonal().setOnes();
    factorize_with_pivots(sound, least, own);
  }
  root.sound = own.sound;
  root.F.setZero(n, own.F.cols());
  for (Index k = 0; k < own.F.cols(); ++k)
    for (Index i = 0; i < count; ++i)
      root.F(rows[ix(i)], k) = scale[i] * own.F(i, k);
  for (Index const pivot : own.pivots)
    root.pivots.push_back(rows[ix(pivot)]);
  return root;
}

template<int D> struct Kept : MinimumMemory {
  explicit Kept(Dense const& of) : W(of), root(root_of(of)), hessian(root.F) {}
  void forget() override {
    hessian.forget();
    programme.reset();
    active.clear();
    counted = false;
  }
  Dense W;
  Root root;
  KeptHessian<D> hessian;
  std::optional<ConvexComplementarity> programme; ///< of the pressures, with this hessian
  std::vector<bool> active;                       ///< points that the last answer holds closed
  /// Is the root, as work? Once after each forget, so that no count tells that it was kept.
  bool counted = false;
};

template<int D> class Minimum {
public:
  Minimum(Problem const& problem, Kept<D>& kept)
      : problem_(problem), kept_(kept), root_(kept.root), hessian_(kept.hessian) {
    for (auto const& law : problem.adhesions)
      opening_ = std::min(opening_, interface::scales(law).opening);
    kept_.active.resize(ix(problem.size()), false);
  }
  [[nodiscard]] std::optional<Descended> run(Vector const& guess, long iterations) {
    start_from(guess);
    auto model = hessian_.made() ? Model::kept : Model::exact;
    double before = 0;
    for (long k = 1; k <= iterations; ++k) {
      differentiate();
      if (!(model == Model::kept ? solve_model() : find_step(model == Model::near ? slight_change : 0)))
        return std::nullopt;
      double const way = step_.norm(), whole = (z_ + step_).norm();
      bool const stalls = model == Model::exact && way <= rounded_step * whole && way >= 0.5 * before;
      bool const faded = moved_.template lpNorm<Eigen::Infinity>() <= no_way * opening_;
      bool const last = quadratic_ || stalls || faded || way <= enough_step * whole;
      double const length = walk();
      bool const failed = length == 0;
      if (failed ? model == Model::exact : last)
        return end(k, !failed);
      model = next(model, length, k == 1 ? quick_contraction : way / before);
      before = way;
    }
    return end(iterations, false);
  }

private:
  /// The bonds' stiffness in a step: that of an earlier one, but for what changed slightly, or as it is.
  enum class Model { kept, near, exact };
  /// After a step of this length that was so much shorter than the one before.
  [[nodiscard]] static Model next(Model last, double length, double contraction) {
    if (length < 1 || (last != Model::kept && contraction > slow_contraction))
      return Model::exact;
    return contraction < quick_contraction ? Model::kept : Model::near;
  }

  [[nodiscard]] double shift(Index point) const { return problem_.points[ix(point)].shift[0]; }
  [[nodiscard]] interface::Adhesion<D> bond(Index point, Local<D> const& x) const {
    auto const& data = problem_.points[ix(point)];
    return data.adhesion < 0 ? interface::Adhesion<D>{}
                             : interface::adhere<D>(problem_.adhesions[ix(data.adhesion)], data.bond, x);
  }

  /// z of the problem's start, of the guess where it has none.
  void
  start_from(Vector const& guess) {
    quadratic_ = std::none_of(problem_.points.begin(), problem_.points.end(),
                              [](auto const& point) { return point.adhesion >= 0; });
    if (problem_.start.size() == 0) {
      z_ = root_.F.transpose() * guess;
    } else {
      Vector x = problem_.start;
      for (Index i = 0; i < problem_.size(); ++i)
        x[D * i] = std::max(x[D * i], shift(i));
      Dense const triangle = root_.F(root_.pivots, Eigen::all);
      z_ = triangle.triangularView<Eigen::Lower>().solve(Vector((x - problem_.free)(root_.pivots)));
    }
    if (!z_.allFinite())
      z_.setZero(root_.F.cols());
    x_ = problem_.free + root_.F * z_;
  }

  /// Forces, gradient and stiffness of the bonds.
  void differentiate() {
    bonds_.setZero(x_.size());
    stiffness_.assign(ix(problem_.size()), LocalMatrix<D>::Zero());
    for (Index i = 0; i < problem_.size(); ++i) {
      if (problem_.points[ix(i)].adhesion < 0)
        continue;
      double const area = problem_.points[ix(i)].area;
      Local<D> at = x_.segment<D>(D * i);
      bonds_.segment<D>(D * i) = area * bond(i, at).traction;
      if (std::abs(at[0]) < touching * opening_) // where it can only open, the slope on that side
        at[0] = touching * opening_;
      LocalMatrix<D> const slope = bond(i, at).traction_by_x;
      stiffness_[ix(i)] = -0.5 * area * (slope + slope.transpose());
    }
    gradient_ = z_ - root_.F.transpose() * bonds_;
  }

  /// Of the bonds, with a part of what softens.
  [[nodiscard]] std::vector<LocalMatrix<D>> softened(double part) const {
    auto blocks = stiffness_;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      blocks[i] = part * stiffness_[i];
      blocks[i].diagonal() = blocks[i].diagonal().cwiseMax(stiffness_[i].diagonal());
    }
    return blocks;
  }

  /// The minimum of the quadratic model, less and less softened until it is convex; false if no x is
  /// admitted.
  bool find_step(double slight) {
    for (double const part : {1.0, 0.5, 0.25, 0.1, 0.0})
      if (hessian_.set(softened(part), slight)) {
        kept_.programme.emplace(hessian_.normal_compliance());
        return solve_model();
      }
    return false;
  }

  bool solve_model() {
    Vector const free = hessian_.solve(gradient_);
    Vector q = -(hessian_.normal() * free);
    for (Index i = 0; i < problem_.size(); ++i)
      q[i] += x_[D * i] - shift(i);
    auto const answer = kept_.programme->solve(q, kept_.active);
    if (!answer)
      return false;
    pressure_ = *answer;
    step_ = hessian_.solve(hessian_.normal().transpose() * pressure_) - free;
    moved_ = root_.F * step_;
    return step_.allFinite();
  }

  /// The largest part of any bond's opening that the step moves an attracted point.
  [[nodiscard]] double stride() const {
    double largest = 0;
    for (Index i = 0; i < problem_.size(); ++i)
      if (problem_.points[ix(i)].adhesion >= 0 && !bonds_.segment<D>(D * i).isZero(0))
        largest = std::max(
            largest, moved_.segment<D>(D * i).norm() /
                         interface::scales(problem_.adhesions[ix(problem_.points[ix(i)].adhesion)]).opening);
    return largest;
  }

  /// What the potential less the work of the model's pressures gains, J.
  [[nodiscard]] double gain(double length) const {
    double sum = length * (z_.dot(step_) + 0.5 * length * step_.squaredNorm());
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const from = x_.segment<D>(D * i), change = length * moved_.segment<D>(D * i);
      sum -= pressure_[i] * change[0];
      if (problem_.points[ix(i)].adhesion < 0)
        continue;
      double work = 0;
      for (int k = 0; k <= 2 * work_panels; ++k) {
        double const weight = k == 0 || k == 2 * work_panels ? 1 : (k % 2 == 1 ? 4 : 2);
        work += weight * bond(i, from + k / (2.0 * work_panels) * change).traction.dot(change);
      }
      sum -= problem_.points[ix(i)].area * work / (6 * work_panels);
    }
    return sum;
  }

  /// As far as the potential falls: the part of the step that was gone, 0 if none. A step too small to leap
  /// over anything is taken at once.
  double walk() {
    double const foretold = step_.dot(gradient_) - pressure_.dot(Vector(hessian_.normal() * step_));
    double const longest = quadratic_ ? 0 : stride();
    double length = std::min(1.0, longest_stride / longest);
    while (length > 1e-6) {
      bool const harmless = length * moved_.template lpNorm<Eigen::Infinity>() < harmless_stride * opening_;
      if (!quadratic_ && !harmless && !(gain(length) <= downhill_part * length * foretold)) {
        length *= 0.5;
        continue;
      }
      z_ += length * step_;
      x_ = problem_.free + root_.F * z_;
      return length;
    }
    return 0;
  }

  /// Half a product each for F z, F^T p, F_n twice and the four triangles of two solutions.
  [[nodiscard]] Descended end(long iterations, bool settled) {
    constexpr double products = 5;
    return {force(), iterations, products * static_cast<double>(iterations) + hessian_.spent(), settled};
  }

  [[nodiscard]] Vector force() {
    differentiate();
    Vector p = bonds_;
    for (Index i = 0; i < problem_.size(); ++i)
      p[D * i] += pressure_[i];
    return p;
  }

  Problem const& problem_;
  Kept<D>& kept_;
  Root const& root_;
  KeptHessian<D>& hessian_;
  bool quadratic_ = false;                                   ///< without bonds
  double opening_ = std::numeric_limits<double>::infinity(); ///< least of the laws, m
  Vector z_, x_, bonds_, gradient_, step_, moved_;
  Vector pressure_; ///< multipliers of x_n >= shift, N
  std::vector<LocalMatrix<D>> stiffness_;
};

} // namespace

std::optional<Descended> minimise(Problem const& problem, Vector const& guess, long iterations,
                                  std::unique_ptr<MinimumMemory>& memory) {
  return by_dimension(problem.dim, [&]<int D>() -> std::optional<Descended> {
    Dense const& W = problem.W.dense();
    auto const* kept = dynamic_cast<Kept<D> const*>(memory.get());
    if (kept == nullptr || kept->W.rows() != W.rows() || kept->W != W)
      memory = std::make_unique<Kept<D>>(W);
    auto& now = static_cast<Kept<D>&>(*memory);
    if (!now.root.sound)
      return std::nullopt;
    auto end = Minimum<D>(problem, now).run(guess, iterations);
    if (end && !std::exchange(now.counted, true))
      end->work += static_cast<double>(W.rows()) / 6;
    return end;
  });
}

} // namespace stiction::contact
