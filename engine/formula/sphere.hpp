// A paraboloid on a half space: Hertz, and three that adhere.
#pragma once
#include "formula/formula.hpp"

namespace stiction::formula {

struct Sphere {
  double modulus = 0; ///< E*, Pa
  double radius = 0;  ///< m
};

/// Contact up to a, and a uniform pull from there to c.
struct Rim {
  double a = 0, c = 0; ///< m
  double depth = 0;    ///< m
  double traction = 0; ///< between a and c, Pa
};

/// s: contact radius over that of the sphere. a^2 = R d, P = 4/3 E* a^3 / R.
class Hertz : public Formula {
public:
  explicit Hertz(Sphere const& sphere) : sphere_(sphere) {}
  [[nodiscard]] State at(double s) const override;
  [[nodiscard]] Profile profile(double s) const override;
  [[nodiscard]] std::string_view name() const override { return "Hertz"; }
  [[nodiscard]] std::string_view source() const override { return "Hertz 1882; Johnson 1985, 4.2"; }

private:
  Sphere sphere_;
};

/// s: a over (pi w R^2 / E*)^(1/3). Adhesion of no range: d = a^2 / R - sqrt(2 pi w a / E*).
class Jkr : public Formula {
public:
  Jkr(Sphere const& sphere, double work) : sphere_(sphere), work_(work) {} ///< J/m^2
  [[nodiscard]] State at(double s) const override;
  [[nodiscard]] Profile profile(double s) const override;
  [[nodiscard]] std::string_view name() const override { return "JKR"; }
  [[nodiscard]] std::string_view source() const override { return "Johnson, Kendall and Roberts 1971"; }

private:
  Sphere sphere_;
  double work_;
};

/// s as JKR's. Adhesion that deforms nothing: Hertz under the force and 2 pi w R.
class Dmt : public Formula {
public:
  Dmt(Sphere const& sphere, double work) : sphere_(sphere), work_(work) {} ///< J/m^2
  [[nodiscard]] State at(double s) const override;
  [[nodiscard]] Profile profile(double s) const override;
  [[nodiscard]] Gives gives() const override {
    return {true, true, "what DMT's adhesion holds is that of a range, which it leaves out"};
  }
  [[nodiscard]] std::string_view name() const override { return "DMT"; }
  [[nodiscard]] std::string_view source() const override {
    return "Derjaguin, Muller and Toporov 1975; Maugis 1992";
  }

private:
  Sphere sphere_;
  double work_;
};

/// Constant traction up to a range. s < 1: nothing touches and the traction acts up to the radius s c1, in
/// which the surface rises until, at c1, it touches; beyond: s - 1 is a over (3 pi w R^2 / (4 E*))^(1/3).
class Maugis : public Formula {
public:
  Maugis(Sphere const& sphere, double work, double traction); ///< J/m^2, Pa
  [[nodiscard]] State at(double s) const override;
  [[nodiscard]] Profile profile(double s) const override;
  [[nodiscard]] std::string_view name() const override { return "Maugis"; }
  [[nodiscard]] std::string_view source() const override { return "Maugis 1992; Johnson and Greenwood 1997"; }
  /// sigma0 (9 R / (2 pi w E*^2))^(1/3): 0 DMT, endless JKR.
  [[nodiscard]] double lambda() const { return lambda_; }

private:
  struct Drawn {
    Rim rim;
    double angle; ///< cos of it: a / c
  };
  [[nodiscard]] Drawn drawn(double s) const;
  [[nodiscard]] double angle(double a) const;
  Sphere sphere_;
  double work_, traction_, lambda_;
  double first_ = 0; ///< c1, m
};

/// Maugis' parameter of a sphere whose adhesion has this work, J/m^2, and largest traction, Pa.
[[nodiscard]] double transition(Sphere const& sphere, double work, double traction);

} // namespace stiction::formula
