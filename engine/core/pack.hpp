// Four numbers that are computed with as one, side by side in a vector register.
#pragma once
#include <Eigen/Core>
#include <cmath>
#ifdef __AVX__
#include <immintrin.h>
#endif

namespace stiction {

/// One lane each of four cells. Arithmetic is that of double in every lane.
class Pack {
  using Lanes = double __attribute__((vector_size(32)));

public:
  static constexpr int lanes = 4;

  Pack() = default;
  Pack(double all) : v_{all, all, all, all} {}

  [[nodiscard]] double operator[](int lane) const { return v_[lane]; }
  void set(int lane, double value) { v_[lane] = value; }

  Pack& operator+=(Pack const& b) { return *this = Pack(v_ + b.v_); }
  Pack& operator-=(Pack const& b) { return *this = Pack(v_ - b.v_); }
  Pack& operator*=(Pack const& b) { return *this = Pack(v_ * b.v_); }
  Pack& operator/=(Pack const& b) { return *this = Pack(v_ / b.v_); }
  friend Pack operator+(Pack const& a, Pack const& b) { return Pack(a.v_ + b.v_); }
  friend Pack operator-(Pack const& a, Pack const& b) { return Pack(a.v_ - b.v_); }
  friend Pack operator*(Pack const& a, Pack const& b) { return Pack(a.v_ * b.v_); }
  friend Pack operator/(Pack const& a, Pack const& b) { return Pack(a.v_ / b.v_); }
  friend Pack operator-(Pack const& a) { return Pack(-a.v_); }

  /// a where `test` is > 0, else 0.
  friend Pack where_positive(Pack const& test, Pack const& a) {
    return Pack(test.v_ > Pack(0).v_ ? a.v_ : Pack(0).v_);
  }
  friend Pack sqrt(Pack const& a) {
#ifdef __AVX__
    return Pack(Lanes(_mm256_sqrt_pd(__m256d(a.v_))));
#else
    return a.each([](double x) { return std::sqrt(x); });
#endif
  }
  friend Pack cbrt(Pack const& a) {
    return a.each([](double x) { return std::cbrt(x); });
  }
  friend Pack pow(Pack const& a, double exponent) {
    return a.each([exponent](double x) { return std::pow(x, exponent); });
  }

private:
  explicit Pack(Lanes v) : v_(v) {}
  template<class Of> [[nodiscard]] Pack each(Of const& of) const {
    Pack result;
    for (int lane = 0; lane < lanes; ++lane)
      result.v_[lane] = of(v_[lane]);
    return result;
  }

  Lanes v_;
};

} // namespace stiction

template<> struct Eigen::NumTraits<stiction::Pack> : Eigen::GenericNumTraits<stiction::Pack> {
  enum { // NOLINTBEGIN(readability-identifier-naming): Eigen's names
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  }; // NOLINTEND(readability-identifier-naming)
};
