// CHOLMOD behind cholesky.hpp.
#include "linear/cholesky.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <mutex>
#include <optional>

#include "core/error.hpp"
#include "core/memory.hpp"
#include "linear/cholmod_view.hpp"
#include "linear/panels.hpp"
#include "linear/recycling.hpp"
#include "linear/supernodal.hpp"

extern "C" {
void openblas_set_num_threads(int threads);
void omp_set_max_active_levels(int levels);
}

namespace stiction::linear {

namespace {

/// bytes: of the factor, as far as they are known.
void refuse_lack_of_memory(cholmod_common const& common, Pattern const& pattern, double bytes) {
  if (common.status != CHOLMOD_OUT_OF_MEMORY && common.status != CHOLMOD_TOO_LARGE)
    return;
  auto const size = bytes > 0 ? fmt::format(", {:.3g} GB", 1e-9 * bytes) : "";
  throw core::OutOfMemory(fmt::format("for the factor of {} unknowns{}", pattern.size(), size));
}

} // namespace

/// What a thread needs to solve with a factor.
struct Cholesky::Solver {
  cholmod_common common{};
  cholmod_dense *solution = nullptr, *scratch1 = nullptr, *scratch2 = nullptr;
  Vector under;                    ///< rows below a supernode
  std::vector<Pack> four, beneath; ///< right sides side by side, and rows below a supernode of theirs

  explicit Solver(cholmod_factor const& factor) {
    cholmod_start(&common);
    common.print = 0;
    auto const n = factor.n, edge = std::max<std::size_t>(factor.maxesize, 1);
    solution = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &common);
    scratch1 = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &common);
    scratch2 = cholmod_allocate_dense(edge, 1, edge, CHOLMOD_REAL, &common);
    under.resize(static_cast<Eigen::Index>(edge));
  }
  Solver(Solver const&) = delete;
  Solver& operator=(Solver const&) = delete;
  ~Solver() {
    for (auto* dense : {&solution, &scratch1, &scratch2})
      cholmod_free_dense(dense, &common);
    cholmod_finish(&common);
  }
};

struct Cholesky::Workspace {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  std::optional<Panels> panels;
  std::mutex guard; ///< of the solvers that nobody uses
  std::vector<std::unique_ptr<Solver>> solvers;
};

/// A solver while it is used.
class Cholesky::Borrowed {
public:
  explicit Borrowed(Workspace& from) : from_(&from) {
    std::lock_guard const lock(from.guard);
    if (from.solvers.empty()) {
      solver_ = std::make_unique<Solver>(*from.factor);
    } else {
      solver_ = std::move(from.solvers.back());
      from.solvers.pop_back();
    }
  }
  Borrowed(Borrowed const&) = delete;
  Borrowed& operator=(Borrowed const&) = delete;
  ~Borrowed() {
    std::lock_guard const lock(from_->guard);
    from_->solvers.push_back(std::move(solver_));
  }
  Solver* operator->() const { return solver_.get(); }

private:
  Workspace* from_;
  std::unique_ptr<Solver> solver_;
};

Cholesky::Cholesky(Pattern pattern, Index trailing, Order order)
    : pattern_(std::move(pattern)), trailing_(trailing), order_(order), work_(std::make_unique<Workspace>()) {
  recycle_suitesparse_memory();
  // cases are the unit of parallelism; CHOLMOD would start four threads for every larger supernode
  openblas_set_num_threads(1);
  omp_set_max_active_levels(0);
  auto& common = work_->common;
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SUPERNODAL;
  if (order == Order::given) {
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_NATURAL; // the pattern comes ordered
    common.postorder = 0;                        // and the trailing unknowns stay last
  }
  auto matrix = view_of(pattern_);
  work_->factor = cholmod_analyze(&matrix, &common);
  refuse_lack_of_memory(common, pattern_, sizeof(double) * common.lnz);
  core::expect(work_->factor != nullptr, "CHOLMOD to analyse the pattern");
  work_->solvers.push_back(std::make_unique<Solver>(*work_->factor));
}

Cholesky::~Cholesky() {
  auto& w = *work_;
  cholmod_free_factor(&w.factor, &w.common);
  cholmod_finish(&w.common);
}

Effort Cholesky::effort() const {
  return {static_cast<double>(work_->factor->xsize), work_->common.fl};
}

bool Cholesky::factorize(std::span<double const> values) {
  core::expect(values.size() == pattern_.rows.size(), "one value per entry of the pattern");
  auto& w = *work_;
  factor_ready_ = false;
  if (values.empty()) // nothing is unknown: CHOLMOD calls the empty matrix singular
    return true;
  if (!w.panels) { // the first time
    cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, w.factor, &w.common);
    refuse_lack_of_memory(w.common, pattern_, sizeof(double) * static_cast<double>(w.factor->xsize));
    w.panels.emplace(*w.factor, pattern_);
  }
  return w.panels->factorize(values, static_cast<double*>(w.factor->x));
}

void Cholesky::solve_system(int system, Eigen::Ref<Dense> B) {
  if (B.size() == 0)
    return;
  Borrowed const solver(*work_);
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = static_cast<std::size_t>(B.rows());
  rhs.ncol = static_cast<std::size_t>(B.cols());
  rhs.nzmax = rhs.nrow * rhs.ncol;
  rhs.x = B.data();
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  int const solved = cholmod_solve2(system, work_->factor, &rhs, nullptr, &solver->solution, nullptr,
                                    &solver->scratch1, &solver->scratch2, &solver->common);
  core::expect(solved == 1, "CHOLMOD to solve with its factor");
  std::copy_n(static_cast<double const*>(solver->solution->x), B.size(), B.data());
}

void Cholesky::solve(Vector& b) {
  auto const* order = static_cast<int const*>(work_->factor->Perm);
  Vector z(b.size());
  for (Index k = 0; k < static_cast<Index>(b.size()); ++k)
    z[k] = b[order[k]];
  forward(z);
  backward(z);
  for (Index k = 0; k < static_cast<Index>(b.size()); ++k)
    b[order[k]] = z[k];
}
void Cholesky::solve(Dense& B) {
  solve_system(CHOLMOD_A, B);
}
void Cholesky::forward(Vector& b) {
  if (b.size() > 0)
    solve_lower(*work_->factor, b, Borrowed(*work_)->under);
}
void Cholesky::backward(Vector& z) {
  if (z.size() > 0)
    solve_upper(*work_->factor, z, Borrowed(*work_)->under);
}

/// order: of elimination; null: that of the vectors.
template<class Halves>
void Cholesky::by_fours(std::span<Vector* const> all, int const* order, Halves const& halves) {
  constexpr std::size_t lanes = Pack::lanes;
  Borrowed const solver(*work_);
  for (std::size_t first = 0; first < all.size(); first += lanes) {
    auto const some = all.subspan(first, std::min(lanes, all.size() - first));
    auto const n = static_cast<std::size_t>(some.front()->size());
    auto& four = solver->four;
    four.assign(n, 0.0);
    auto const from = [&](std::size_t k) {
      return order != nullptr ? Index{order[k]} : static_cast<Index>(k);
    };
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t lane = 0; lane < some.size(); ++lane)
        four[k].set(static_cast<int>(lane), (*some[lane])[from(k)]);
    halves(four, solver->beneath);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t lane = 0; lane < some.size(); ++lane)
        (*some[lane])[from(k)] = four[k][static_cast<int>(lane)];
  }
}

void Cholesky::solve(std::span<Vector* const> all) {
  by_fours(all, static_cast<int const*>(work_->factor->Perm), [this](auto& four, auto& work) {
    solve_lower(*work_->factor, four, work);
    solve_upper(*work_->factor, four, work);
  });
}
void Cholesky::forward(std::span<Vector* const> all) {
  by_fours(all, nullptr, [this](auto& four, auto& work) { solve_lower(*work_->factor, four, work); });
}
void Cholesky::backward(std::span<Vector* const> all) {
  by_fours(all, nullptr, [this](auto& four, auto& work) { solve_upper(*work_->factor, four, work); });
}

void Cholesky::forward(Dense& B) {
  solve_system(CHOLMOD_L, B);
}

Dense const& Cholesky::trailing_factor() {
  if (factor_ready_)
    return trailing_factor_;
  core::expect(order_ == Order::given, "the trailing unknowns to be eliminated last");
  cholmod_factor const& L = *work_->factor;
  auto const* super = static_cast<int const*>(L.super);
  auto const* pi = static_cast<int const*>(L.pi);
  auto const* px = static_cast<int const*>(L.px);
  auto const* s = static_cast<int const*>(L.s);
  auto const* x = static_cast<double const*>(L.x);
  int const first = static_cast<int>(L.n) - trailing_;
  trailing_factor_.setZero(trailing_, trailing_);
  for (std::ptrdiff_t q = static_cast<std::ptrdiff_t>(L.nsuper) - 1; q >= 0; --q) {
    int const begin = super[q], end = super[q + 1], rows = pi[q + 1] - pi[q];
    if (end <= first)
      break;
    for (int j = std::max(begin, first); j < end; ++j)
      for (int r = j - begin; r < rows; ++r)
        trailing_factor_(s[pi[q] + r] - first, j - first) =
            x[px[q] + static_cast<std::ptrdiff_t>(j - begin) * rows + r];
  }
  factor_ready_ = true;
  return trailing_factor_;
}

std::string cholmod_version() {
  return fmt::format("{}.{}.{}", CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION);
}

} // namespace stiction::linear
