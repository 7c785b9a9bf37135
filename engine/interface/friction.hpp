// What friction laws are asked and answer: the coefficient at one point, with its derivatives.
#pragma once
#include "core/schema.hpp"
#include "interface/cone.hpp"

namespace stiction::interface {

/// Of friction: with larger ones the cone takes what rounding leaves of slips for openings.
inline constexpr core::Range coefficients{0, 1e6};

/// The state that a coefficient may depend on.
template<int D> struct Sliding {
  Local<D> dry = Local<D>::Zero(); ///< rbar, Pa
  Local<D> x = Local<D>::Zero();   ///< (x_n, slip of the step), m
  double dt = 0;                   ///< s; > 0
};

/// The coefficient of friction and its derivatives by rbar and x.
template<int D> struct Coefficient {
  double mu = 0;
  Local<D> by_dry = Local<D>::Zero(); ///< 1/Pa
  Local<D> by_x = Local<D>::Zero();   ///< 1/m
};

} // namespace stiction::interface
