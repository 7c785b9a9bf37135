// Four numbers that are computed with as one, side by side in a vector register.
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <cstring>
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

  /// Four numbers that follow each other in memory.
  [[nodiscard]] static Pack load(double const* from) {
    Pack result;
    std::memcpy(&result.v_, from, sizeof result.v_);
    return result;
  }
  void store(double* to) const { std::memcpy(to, &v_, sizeof v_); }

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
  /// a^(-1/3) of positive, normal numbers, to the last digits: of a = t 2^(3k), t in [1/2, 4), a polynomial
  /// within 3 %, then twice y (1 - h)^(-1/3) in powers of h = 1 - t y^3 up to the third.
  friend Pack inverse_cbrt(Pack const& a) {
    using Bits = unsigned long long __attribute__((vector_size(32)));
    constexpr double whole = 0x1.8p52; // beside it numbers are rounded to integers
    Bits const bits = Bits(a.v_), one = Bits(Pack(1).v_), two_52 = Bits(Pack(0x1p52).v_);
    Lanes const m = Lanes((bits & 0xfffffffffffffULL) | one),
                e = Lanes((bits >> 52) | two_52) - (0x1p52 + 1023), k = (e / 3 + whole) - whole,
                left = e - 3 * k,
                t = left > 0   ? 2 * m
                    : left < 0 ? 0.5 * m
                               : m;
    Lanes y = 1.5186457 + t * (-0.67441915 + t * (0.19491008 - t * 0.020547832));
    for (int i = 0; i < 2; ++i) {
      Lanes const h = 1 - t * y * y * y;
      y += y * h * (1.0 / 3 + h * (2.0 / 9 + h * (14.0 / 81)));
    }
    return Pack(y * Lanes(Bits(0x1p52 + 1023 - k) << 52));
  }
  /// Of positive, normal numbers, to the last digits: with m = a / 2^e in [1/sqrt(2), sqrt(2)] and s =
  /// (m - 1) / (m + 1) it is e ln 2 + 2 (s + s^3 / 3 + s^5 / 5 + ...).
  friend Pack log(Pack const& a) {
    using Bits = unsigned long long __attribute__((vector_size(32)));
    constexpr double root = 1.4142135623730951, high = 0x1.62e42fefa39efp-1, low = 0x1.abc9e3b39803fp-56;
    Bits const bits = Bits(a.v_), one = Bits(Pack(1).v_), two_52 = Bits(Pack(0x1p52).v_);
    Lanes m = Lanes((bits & 0xfffffffffffffULL) | one), e = Lanes((bits >> 52) | two_52) - (0x1p52 + 1023);
    auto const over = m > Pack(root).v_;
    m = over ? 0.5 * m : m;
    e = over ? e + 1 : e;
    Lanes const s = (m - 1) / (m + 1), z = s * s;
    Lanes sum = z * (1.0 / 21) + 1.0 / 19;
    for (double const n : {17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0})
      sum = sum * z + 1 / n;
    return Pack(e * high + (2 * s * sum + e * low));
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
