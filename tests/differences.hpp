// Central differences and the rate at which they approach a claimed derivative.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

#include "core/types.hpp"

namespace stiction::test {

/// Errors of central differences at steps h, h/10, h/100, h/1000.
struct Rate {
  std::array<double, 4> errors{};
  double scale = 0;          ///< largest entry of the derivative
  bool second_order = false; ///< each decade of step gains nearly two of error, until rounding takes over
  [[nodiscard]] std::string words() const {
    std::string text = "errors of central differences:";
    for (double const e : errors)
      text.append(" ").append(std::to_string(std::log10(std::max(e, 1e-300))));
    return text + " (log10), derivative " + std::to_string(scale);
  }
};

/// [f, x] by central differences with step h.
template<class F> Dense jacobian(F const& f, Vector const& x, double h) {
  Dense J;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Vector up = x, down = x;
    up[k] += h;
    down[k] -= h;
    Vector const column = (f(up) - f(down)) / (2 * h);
    if (J.size() == 0)
      J.resize(column.size(), x.size());
    J.col(k) = column;
  }
  return J;
}

/// How differences of `f` (Vector to Vector) approach `exact` = df/dx. `noise`: size of the terms that cancel
/// in f, which sets the floor of rounding; at least the size of f itself.
template<class F> Rate rate(F const& f, Dense const& exact, Vector const& x, double h, double noise = 0) {
  Rate result;
  result.scale = exact.cwiseAbs().maxCoeff();
  noise = std::max(noise, f(x).cwiseAbs().maxCoeff() + result.scale * h);
  result.second_order = true;
  for (std::size_t k = 0; k < result.errors.size(); ++k, h /= 10) {
    result.errors[k] = (jacobian(f, x, h) - exact).cwiseAbs().maxCoeff();
    double const floor = 2e-14 * noise / h;
    if (k > 0 && result.errors[k] > std::max(result.errors[k - 1] * 0.016, floor))
      result.second_order = false;
  }
  return result;
}

/// Second order, and a small error at the third step.
inline void check_rate(Rate const& rate, char const* what) {
  CHECK_MESSAGE(rate.second_order, what << ": " << rate.words());
  CHECK(rate.errors[2] <= 1e-5 * (1 + rate.scale));
}

} // namespace stiction::test
