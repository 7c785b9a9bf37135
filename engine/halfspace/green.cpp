// Waves on periodic surfaces; on free ones rectangles under uniform traction and their cosine transforms.
#include "halfspace/green.hpp"

#include <cmath>
#include <fftw3.h>
#include <memory>
#include <numbers>

namespace stiction::halfspace {

using std::numbers::pi;

Compliance Compliance::of(Elastic const& body, Elastic const* counterpart) {
  Compliance sum;
  auto const add = [&](Elastic const& one, double sign) {
    double const nu = one.poisson, G = one.young / (2 * (1 + nu));
    sum.normal += (1 - nu) / G;
    sum.shear += 1 / G;
    sum.coupling += sign * (0.5 - nu) / G;
    sum.mean_normal += one.depth * (0.5 - nu) / ((1 - nu) * G);
    sum.mean_shear += one.depth / G;
  };
  add(body, 1);
  if (counterpart != nullptr)
    add(*counterpart, -1);
  return sum;
}

namespace {

Symbols sized(Grid const& grid, int components) {
  Symbols made;
  made.px = grid.px();
  made.py = grid.py();
  made.rows = made.px / 2 + 1;
  made.columns = made.py / 2 + 1;
  auto const size = Eigen::Index{made.rows} * made.columns;
  made.nn = Vector::Zero(size);
  if (components > 1)
    made.xx = made.nx = Vector::Zero(size);
  if (components > 2)
    made.yy = made.xy = made.ny = Vector::Zero(size);
  return made;
}

/// One wave (a, b) that is not the mean.
struct Direction {
  double kx = 0, ky = 0;
  bool last_x = false, last_y = false; ///< the shortest that points resolve, without a direction
};

void set(Symbols& made, Eigen::Index at, Direction const& wave, Compliance const& c) {
  double const k = std::hypot(wave.kx, wave.ky), cx = wave.kx / k, cy = wave.ky / k;
  made.nn[at] = c.normal / k;
  if (made.xx.size() == 0)
    return;
  made.xx[at] = (c.shear - c.poisson() * cx * cx) / k;
  made.nx[at] = wave.last_x ? 0 : -c.coupling * cx / k;
  if (made.yy.size() == 0)
    return;
  made.yy[at] = (c.shear - c.poisson() * cy * cy) / k;
  made.ny[at] = wave.last_y ? 0 : -c.coupling * cy / k;
  made.xy[at] = wave.last_x || wave.last_y ? 0 : -c.poisson() * cx * cy / k;
}

/// Mean of a table that is even, over all waves.
double mean_of(Vector const& table, Symbols const& made) {
  double sum = 0;
  for (Index a = 0; a < made.rows; ++a)
    for (Index b = 0; b < made.columns; ++b) {
      bool const alone_x = a == 0 || 2 * a == made.px, alone_y = b == 0 || 2 * b == made.py;
      sum += (alone_x ? 1 : 2) * (alone_y ? 1 : 2) * table[Eigen::Index{a} * made.columns + b];
    }
  return sum / (double{1} * made.px * made.py);
}

Symbols periodic(Grid const& grid, Compliance const& c, int components) {
  auto made = sized(grid, components);
  double const per_force = 1 / grid.area();
  for (Index a = 0; a < made.rows; ++a)
    for (Index b = 0; b < made.columns; ++b)
      if (a + b > 0)
        set(made, Eigen::Index{a} * made.columns + b,
            {2 * pi * a / grid.Lx, 2 * pi * b / grid.Ly, 2 * a == made.px, 2 * b == made.py}, c);
  made.nn[0] = c.mean_normal;
  for (auto* table : {&made.xx, &made.yy})
    if (table->size() > 0)
      (*table)[0] = c.mean_shear;
  Vector const* const diagonal[] = {&made.nn, &made.xx, &made.yy};
  for (auto* table : {&made.nn, &made.xx, &made.yy, &made.xy, &made.nx, &made.ny})
    *table *= per_force;
  for (int i = 0; i < components; ++i)
    made.block(i, i) = mean_of(*diagonal[i], made);
  return made;
}

// Integrals over a rectangle whose corners are seen from a point: sums of these over corners, with signs.

double one_over_r(double x, double y) { // 1 / r; Love 1929
  return x * std::asinh(y / std::abs(x)) + y * std::asinh(x / std::abs(y));
}
double xx_over_r3(double x, double y) {
  return y * std::asinh(x / std::abs(y));
}
double xy_over_r3(double x, double y) {
  return -std::hypot(x, y);
}
double x_over_r2(double x, double y) {
  return y * std::log(std::hypot(x, y)) + x * std::atan(y / x);
}

template<class Integral> double over(Integral const& integral, double x, double y, Grid const& grid) {
  double const a = 0.5 * grid.dx(), b = 0.5 * grid.dy();
  return integral(x + a, y + b) - integral(x - a, y + b) - integral(x + a, y - b) + integral(x - a, y - b);
}

/// Sums over all distances, of a table that holds them from 0 on: cosines along what it is even in, sines
/// along what it is odd in. Along x, then along y.
class Sums {
public:
  explicit Sums(Symbols const& made) : made_(&made) {}
  void along_x(Vector& table, bool odd) const {
    if (made_->rows > 1)
      transform(table, made_->rows, {made_->columns, made_->columns, 1}, odd);
  }
  void along_y(Vector& table, bool odd) const {
    if (made_->columns > 1)
      transform(table, made_->columns, {made_->rows, 1, made_->columns}, odd);
  }

private:
  struct Steps {
    Index count; ///< of transforms
    int stride;  ///< between the numbers of one
    int apart;   ///< from one to the next
  };
  static void transform(Vector& table, Index n, Steps const& steps, bool odd) {
    int const length = odd ? n - 2 : n;
    if (length < 1) { // nothing but its own opposite
      table.setZero();
      return;
    }
    fftw_r2r_kind const kind = odd ? FFTW_RODFT00 : FFTW_REDFT00;
    double* const first = table.data() + (odd ? steps.stride : 0);
    std::unique_ptr<std::remove_pointer_t<fftw_plan>, void (*)(fftw_plan)> const plan(
        fftw_plan_many_r2r(1, &length, steps.count, first, nullptr, steps.stride, steps.apart, first, nullptr,
                           steps.stride, steps.apart, &kind, FFTW_ESTIMATE),
        fftw_destroy_plan);
    fftw_execute(plan.get());
  }
  Symbols const* made_;
};

/// value(x, y) at all distances; what is odd is nothing where it would have to be its own opposite.
template<class Value> void fill(Vector& table, Symbols const& made, Grid const& grid, Value const& value) {
  for (Index a = 0; a < made.rows; ++a)
    for (Index b = 0; b < made.columns; ++b)
      table[Eigen::Index{a} * made.columns + b] = value(a * grid.dx(), b * grid.dy());
}

void clear_last(Vector& table, Symbols const& made, bool odd_x, bool odd_y) {
  Eigen::Map<Matrix> all(table.data(), made.rows, made.columns);
  if (odd_x)
    for (Index const a : {0, made.rows - 1})
      all.row(a).setZero();
  if (odd_y)
    for (Index const b : {0, made.columns - 1})
      all.col(b).setZero();
}

Symbols free_line(Grid const& grid, Compliance const& c, int components) {
  auto made = sized(grid, components);
  double const a = 0.5 * grid.dx(), far = grid.Lx, per_force = 1 / grid.area();
  auto const log_part = [far](double s) { return s == 0 ? 0 : s * (std::log(std::abs(s) / far) - 1); };
  Sums const sums(made);
  fill(made.nn, made, grid,
       [&](double x, double) { return -c.normal / pi * per_force * (log_part(x + a) - log_part(x - a)); });
  made.block(0, 0) = made.nn[0];
  if (components > 1) {
    made.xx = made.nn;
    made.block(1, 1) = made.nn[0];
    fill(made.nx, made, grid, [&](double x, double) { return x > 0 ? 0.5 * c.coupling : 0.0; });
    clear_last(made.nx, made, true, false);
    sums.along_x(made.nx, true);
    made.nx *= -1;
    sums.along_x(made.xx, false);
  }
  sums.along_x(made.nn, false);
  return made;
}

Symbols free_surface(Grid const& grid, Compliance const& c, int components) {
  auto made = sized(grid, components);
  double const scale = 1 / (2 * pi * grid.area());
  Sums const sums(made);
  auto const even = [&](Vector& table, auto const& value) {
    fill(table, made, grid, value);
    double const own = table[0];
    sums.along_x(table, false);
    sums.along_y(table, false);
    return own;
  };
  auto const I0 = [&](double x, double y) { return over(one_over_r, x, y, grid); };
  auto const Ix = [&](double x, double y) { return over(xx_over_r3, x, y, grid); };
  made.block(0, 0) = even(made.nn, [&](double x, double y) { return scale * c.normal * I0(x, y); });
  if (components == 1)
    return made;
  made.block(1, 1) = even(
      made.xx, [&](double x, double y) { return scale * (c.normal * I0(x, y) + c.poisson() * Ix(x, y)); });
  made.block(2, 2) = even(made.yy, [&](double x, double y) {
    return scale * (c.normal * I0(x, y) + c.poisson() * (I0(x, y) - Ix(x, y)));
  });
  auto const odd = [&](Vector& table, bool in_x, bool in_y, auto const& value) {
    fill(table, made, grid, value);
    clear_last(table, made, in_x, in_y);
    sums.along_x(table, in_x);
    sums.along_y(table, in_y);
    table *= -1;
  };
  odd(made.xy, true, true,
      [&](double x, double y) { return scale * c.poisson() * over(xy_over_r3, x, y, grid); });
  odd(made.nx, true, false,
      [&](double x, double y) { return scale * c.coupling * over(x_over_r2, x, y, grid); });
  odd(made.ny, false, true, [&](double x, double y) {
    return scale * c.coupling * over([](double u, double v) { return x_over_r2(v, u); }, x, y, grid);
  });
  return made;
}

} // namespace

Symbols symbols(Grid const& grid, Compliance const& compliance, int components) {
  if (grid.periodic)
    return periodic(grid, compliance, components);
  return grid.line ? free_line(grid, compliance, components) : free_surface(grid, compliance, components);
}

} // namespace stiction::halfspace
