// Transforms by rows, then by columns, where waves are weighed, and back.
#include "halfspace/surface.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <fftw3.h>

#include "contact/problem/problem.hpp"
#include "core/error.hpp"
#include "core/threads.hpp"

namespace stiction::halfspace {

namespace {

constexpr Index together = 4; ///< columns at a time: a line of the cache

fftw_complex* raw(std::complex<double>* data) {
  return reinterpret_cast<fftw_complex*>(data);
}

std::complex<double>* allocate(Eigen::Index count) {
  auto* data = fftw_alloc_complex(static_cast<std::size_t>(count));
  if (data == nullptr)
    throw core::RunError("not enough memory for the transforms of a half space");
  return reinterpret_cast<std::complex<double>*>(data);
}

using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, void (*)(fftw_plan)>;

Plan held(fftw_plan plan) {
  core::expect(plan != nullptr, "FFTW to have a plan for every length");
  return {plan, fftw_destroy_plan};
}

constexpr Index least_rows = 4; ///< that a thread takes at a time

/// Pieces of columns that threads share: as many whatever the number of threads.
Index pieces(Index columns) {
  return std::min<Index>(core::most_pieces, (columns + together - 1) / together);
}

} // namespace

double product_operations(Grid const& grid, int components) {
  double const D = components, px = grid.px(), py = grid.py(), waves = px / 2 + 1;
  return 5 * D * (grid.ny * px * std::log2(px) + 2 * waves * py * std::log2(py)) + 8 * D * D * waves * py;
}

void Surface::Free::operator()(Complex* data) const {
  fftw_free(data);
}

/// Of single rows, from a buffer and into it, and of columns in place. Estimated, not measured: the same on
/// every run.
struct Surface::Plans {
  Plan row, row_back, column, column_back;
};

Surface::Surface(Grid const& grid, Compliance const& compliance, int components)
    : grid_(grid), components_(components), symbols_(symbols(grid, compliance, components)),
      stride_(symbols_.rows) {
  waves_.reset(allocate(Eigen::Index{components} * grid.ny * stride_));
  buffers_.reset(allocate(buffered()));
  auto* const wave = raw(waves_.get());
  auto* const number = row_buffer(0);
  auto* const buffer = raw(buffers_.get());
  plans_ = std::make_unique<Plans>(
      Plans{held(fftw_plan_dft_r2c_1d(symbols_.px, number, wave, FFTW_ESTIMATE)),
            held(fftw_plan_dft_c2r_1d(symbols_.px, wave, number, FFTW_ESTIMATE)),
            held(fftw_plan_dft_1d(symbols_.py, buffer, buffer, FFTW_FORWARD, FFTW_ESTIMATE)),
            held(fftw_plan_dft_1d(symbols_.py, buffer, buffer, FFTW_BACKWARD, FFTW_ESTIMATE))});
}

Surface::~Surface() = default;

double Surface::longest() const {
  return symbols_.nn.tail(symbols_.nn.size() - 1).cwiseAbs().maxCoeff();
}

std::size_t Surface::memory() const {
  auto const& s = symbols_;
  Eigen::Index count = 2 * Eigen::Index{components_} * grid_.ny * stride_ + 2 * buffered() + padded_.size();
  for (auto const* table : {&s.nn, &s.xx, &s.yy, &s.xy, &s.nx, &s.ny})
    count += table->size();
  return static_cast<std::size_t>(count);
}

/// Rows and columns take turns.
Eigen::Index Surface::buffered() const {
  Eigen::Index const columns = Eigen::Index{pieces(symbols_.rows)} * components_ * together * symbols_.py,
                     rows =
                         Eigen::Index{core::piece_of(grid_.ny, least_rows, grid_.ny - 1) + 1} * symbols_.rows;
  return std::max(columns, rows);
}

double* Surface::row_buffer(Index first) const {
  return reinterpret_cast<double*>(buffers_.get()) +
         2 * symbols_.rows * core::piece_of(grid_.ny, least_rows, first);
}

template<int D> void Surface::forward_rows(double const* in, Index first, Index last) const {
  double* const numbers = row_buffer(first);
  std::fill(numbers + grid_.nx, numbers + symbols_.px, 0.0);
  for (int c = 0; c < D; ++c)
    for (Index j = first; j < last; ++j) {
      double const* const from = in + Eigen::Index{j} * grid_.nx * D + c;
      for (Index i = 0; i < grid_.nx; ++i)
        numbers[i] = from[Eigen::Index{i} * D];
      fftw_execute_dft_r2c(plans_->row.get(), numbers, raw(row(c, j)));
    }
}

template<int D> void Surface::backward_rows(double* out, Index first, Index last) const {
  double const scale = 1 / (double{1} * symbols_.px * symbols_.py);
  double* const numbers = row_buffer(first);
  for (int c = 0; c < D; ++c)
    for (Index j = first; j < last; ++j) {
      fftw_execute_dft_c2r(plans_->row_back.get(), raw(row(c, j)), numbers);
      double* const to = out + Eigen::Index{j} * grid_.nx * D + c;
      for (Index i = 0; i < grid_.nx; ++i)
        to[Eigen::Index{i} * D] += scale * numbers[i];
    }
}

Surface::Complex* Surface::Columns::column(int component, Index k) const {
  return first + (Eigen::Index{component} * together + k) * py;
}

template<int D> void Surface::forward_columns(Columns const& few) const {
  for (int c = 0; c < D; ++c) {
    for (Index j = 0; j < grid_.ny; ++j)
      for (Index k = 0; k < few.some; ++k)
        few.column(c, k)[j] = row(c, j)[few.a + k];
    for (Index k = 0; k < few.some; ++k) {
      std::fill(few.column(c, k) + grid_.ny, few.column(c, k) + few.py, Complex{});
      fftw_execute_dft(plans_->column.get(), raw(few.column(c, k)), raw(few.column(c, k)));
    }
  }
}

template<int D> void Surface::backward_columns(Columns const& few) const {
  for (int c = 0; c < D; ++c) {
    for (Index k = 0; k < few.some; ++k)
      fftw_execute_dft(plans_->column_back.get(), raw(few.column(c, k)), raw(few.column(c, k)));
    for (Index j = 0; j < grid_.ny; ++j)
      for (Index k = 0; k < few.some; ++k)
        row(c, j)[few.a + k] = few.column(c, k)[j];
  }
}

/// The waves that are real in the tables: the normal component turned by a quarter.
template<int D>
void Surface::weigh(Eigen::Matrix<double, D, D> const& by, Columns const& few, Index k, Index j) {
  if constexpr (D == 1) {
    few.column(0, k)[j] *= by(0, 0);
  } else {
    std::array<Complex, D> old;
    for (int c = 0; c < D; ++c)
      old[ix(c)] = few.column(c, k)[j];
    old[0] = Complex(old[0].imag(), -old[0].real());
    for (int c = 0; c < D; ++c) {
      Complex sum = by(c, 0) * old[0];
      for (int d = 1; d < D; ++d)
        sum += by(c, d) * old[ix(d)];
      few.column(c, k)[j] = c > 0 ? sum : Complex(-sum.imag(), sum.real());
    }
  }
}

/// The piece's columns forward, each of their waves weighed by weights(wave), and back.
template<int D, class Weights> void Surface::columns(Index piece, Weights const& weights) const {
  Index const count = pieces(symbols_.rows), width = (symbols_.rows + count - 1) / count, py = symbols_.py;
  Index const end = std::min(symbols_.rows, (piece + 1) * width);
  for (Index a = piece * width; a < end; a += together) {
    Columns const few{buffers_.get() + Eigen::Index{piece} * D * together * py, a,
                      std::min(together, end - a), py};
    forward_columns<D>(few);
    for (Index k = 0; k < few.some; ++k) {
      for (Index j = 0; j <= py / 2; ++j)
        weigh<D>(weights(Wave{a + k, j, 1}), few, k, j);
      for (Index j = py / 2 + 1; j < py; ++j)
        weigh<D>(weights(Wave{a + k, py - j, -1}), few, k, j);
    }
    backward_columns<D>(few);
  }
}

template<int D, class Weights>
void Surface::transform(double const* in, double* out, Weights const& weights) const {
  core::each_piece(grid_.ny, least_rows, [&](Index first, Index last) { forward_rows<D>(in, first, last); });
  core::each(pieces(symbols_.rows), [&](Index piece) { columns<D>(piece, weights); });
  core::each_piece(grid_.ny, least_rows,
                   [&](Index first, Index last) { backward_rows<D>(out, first, last); });
}

template<int D> Eigen::Matrix<double, D, D> Surface::symbol(Wave const& wave) const {
  auto const at = Eigen::Index{wave.a} * symbols_.columns + wave.b;
  Eigen::Matrix<double, D, D> W;
  W(0, 0) = symbols_.nn[at];
  if constexpr (D > 1) {
    W(1, 1) = symbols_.xx[at];
    W(0, 1) = W(1, 0) = symbols_.nx[at];
  }
  if constexpr (D > 2) {
    W(2, 2) = symbols_.yy[at];
    W(0, 2) = W(2, 0) = wave.sign * symbols_.ny[at];
    W(1, 2) = W(2, 1) = wave.sign * symbols_.xy[at];
  }
  return W;
}

namespace {

/// (shift + W)^-1; what a free surface's padding has left indefinite without what couples, by sizes.
template<int D>
Eigen::Matrix<double, D, D> inverse(Eigen::Matrix<double, D, D> W, double shift, double least) {
  if constexpr (D == 1) {
    W(0, 0) = 1 / (shift + std::max(std::abs(W(0, 0)), least));
    return W;
  } else {
    W.diagonal().array() += shift;
    Eigen::LLT<Eigen::Matrix<double, D, D>> const factor(W);
    if (factor.info() == Eigen::Success)
      return W.inverse();
    Eigen::Matrix<double, D, 1> const sizes = W.diagonal().cwiseAbs().array().max(least);
    return sizes.cwiseInverse().asDiagonal();
  }
}

} // namespace

/// Of the mean, where it meets no compliance, that of the longest wave by sizes.
template<int D> Eigen::Matrix<double, D, D> Surface::inverse_of_mean(double shift, double least) const {
  if (symbols_.nn[0] > 0)
    return inverse<D>(symbol<D>({0, 0, 1}), shift, least);
  bool const along = symbols_.rows > 1;
  Eigen::Matrix<double, D, 1> const sizes =
      (symbol<D>({along ? 1 : 0, along ? 0 : 1, 1}).diagonal().array() + (D > 1 ? shift : 0))
          .abs()
          .max(least);
  return (sizes.array() + (D == 1 ? shift : 0)).inverse().matrix().asDiagonal();
}

void Surface::add_product(Eigen::Ref<Vector const> const& force, Eigen::Ref<Vector> x) const {
  ++products_;
  contact::by_dimension(components_, [&]<int D>() {
    transform<D>(force.data(), x.data(), [this](Wave const& wave) { return symbol<D>(wave); });
  });
}

void Surface::solve(double shift, Vector const& x, Vector& force) const {
  ++solutions_;
  force.setZero();
  double const least = 1e-3 * symbols_.block(0, 0) / std::max(symbols_.px, symbols_.py);
  contact::by_dimension(components_, [&]<int D>() {
    auto const of_mean = inverse_of_mean<D>(shift, least);
    transform<D>(x.data(), force.data(), [&, this](Wave const& wave) -> Eigen::Matrix<double, D, D> {
      if (wave.a + wave.b == 0)
        return of_mean;
      return inverse<D>(symbol<D>(wave), shift, least);
    });
  });
}

contact::Delassus Surface::delassus() const {
  return {grid_.size(), block(), [this](Index first, auto const& force, auto x) {
            if (force.size() == rows())
              return add_product(force, x);
            padded_.setZero(rows());
            padded_.segment(first, force.size()) = force;
            add_product(padded_, x);
          }};
}

} // namespace stiction::halfspace
