// The compliance of a half space's surface as a product, and what nearly undoes it.
#pragma once
#include <complex>
#include <memory>

#include "contact/problem/delassus.hpp"
#include "halfspace/green.hpp"

namespace stiction::halfspace {

/// Floating-point operations of a product: transforms of rows and of columns, there and back, and weighing.
[[nodiscard]] double product_operations(Grid const& grid, int components);

/// Forces p on the points, N, to displacements x, m: contact by contact, (n [, x [, y]]). A product is two
/// transforms a component; rows and columns of the grid are shared by threads, and give the same bits however
/// many there are. Rows of padding are neither kept nor transformed.
class Surface {
public:
  /// components: 1, 2 (on a line) or 3.
  Surface(Grid const& grid, Compliance const& compliance, int components);
  ~Surface();
  Surface(Surface const&) = delete;
  Surface& operator=(Surface const&) = delete;

  /// x += W p. Not by two threads at a time.
  void add_product(Eigen::Ref<Vector const> const& force, Eigen::Ref<Vector> x) const;
  /// force = (shift + W)^-1 x, of a periodic surface; nearly that, and as positive, of a free one. shift:
  /// m/N.
  void solve(double shift, Vector const& x, Vector& force) const;
  [[nodiscard]] contact::Delassus delassus() const;

  [[nodiscard]] Grid const& grid() const { return grid_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] Index rows() const { return components_ * grid_.size(); }
  /// Of a point on itself, m/N.
  [[nodiscard]] Dense block() const { return symbols_.block.topLeftCorner(components_, components_); }
  /// Largest of all compliances but that to the mean, m/N: of the longest wave.
  [[nodiscard]] double longest() const;
  /// Does it give under the mean pressure? A periodic one without a depth does not.
  [[nodiscard]] bool mean_gives() const { return symbols_.nn[0] > 0; }
  /// Products and solutions so far.
  [[nodiscard]] long products() const { return products_; }
  [[nodiscard]] long solutions() const { return solutions_; }
  /// Of one of them.
  [[nodiscard]] double operations() const { return product_operations(grid_, components_); }
  /// Numbers that it keeps.
  [[nodiscard]] std::size_t memory() const;

private:
  using Complex = std::complex<double>;
  struct Plans;
  struct Wave {
    Index a, b;      ///< in the tables
    double sign = 1; ///< of what is odd along y
  };
  template<int D, class Weights> void transform(double const* in, double* out, Weights const& weights) const;
  template<int D> void forward_rows(double const* in, Index first, Index last) const;
  template<int D> void backward_rows(double* out, Index first, Index last) const;
  template<int D, class Weights> void columns(Index piece, Weights const& weights) const;
  struct Columns {
    Complex* first;
    Index a, some, py; ///< waves along x from a on, points along y
    [[nodiscard]] Complex* column(int component, Index k) const;
  };
  template<int D> void forward_columns(Columns const& few) const;
  template<int D> void backward_columns(Columns const& few) const;
  template<int D>
  static void weigh(Eigen::Matrix<double, D, D> const& by, Columns const& few, Index k, Index j);
  template<int D> [[nodiscard]] Eigen::Matrix<double, D, D> symbol(Wave const& wave) const;
  template<int D> [[nodiscard]] Eigen::Matrix<double, D, D> inverse_of_mean(double shift, double least) const;
  [[nodiscard]] Eigen::Index buffered() const;
  /// For the piece of rows that begins with `first`: as many numbers as a padded row has.
  [[nodiscard]] double* row_buffer(Index first) const;
  [[nodiscard]] Complex* row(int component, Index j) const {
    return waves_.get() + (Eigen::Index{component} * grid_.ny + j) * stride_;
  }

  struct Free {
    void operator()(Complex* data) const;
  };
  Grid grid_;
  int components_;
  Symbols symbols_;
  Index stride_ = 0; ///< of rows of waves
  std::unique_ptr<Complex[], Free> waves_,
      buffers_; ///< [components][ny][stride_]; of rows, or [pieces][components][some][py]
  std::unique_ptr<Plans> plans_;
  mutable Vector padded_; ///< for columns of W
  mutable long products_ = 0, solutions_ = 0;
};

} // namespace stiction::halfspace
