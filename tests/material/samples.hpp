// One instance of every bulk law, filled through its schema so that new laws join the tests by themselves.
#pragma once
#include <string>
#include <vector>

#include "core/types.hpp"
#include "material/material.hpp"

namespace stiction::test {

/// Distinct moduli of the order of 1 MPa; pure numbers lie in their range, 0.3 where that fits. Lists have
/// three numbers of changing sign, so that products of two lists are positive.
template<class Law> Law sample_law() {
  Law law;
  double stiffness = 1e6;
  for (auto const& parameter : Law::schema().parameters) {
    bool const pure = parameter.unit.empty() || parameter.unit == "1";
    if (parameter.kind == core::Parameter::Kind::numbers)
      parameter.set(&law, pure ? core::Numbers{1.3, -2.2, 4.1} : core::Numbers{5e5, -2e5, 3e4});
    if (parameter.kind != core::Parameter::Kind::number)
      continue;
    double const fraction = parameter.range.contains(0.3) ? 0.3 : parameter.range.low + 1;
    parameter.set(&law, core::Value{pure ? fraction : stiffness});
    stiffness *= 1.7;
  }
  return law;
}

namespace detail {
template<class Act, class... Laws> void each(Act const& act, std::variant<Laws...> const*) {
  (act(sample_law<Laws>()), ...);
}
} // namespace detail

/// Calls act(law) for one sample of every alternative of Material.
template<class Act> void each_law(Act const& act) {
  detail::each(act, static_cast<material::Material const*>(nullptr));
}

/// The samples as Materials, with their names.
inline std::vector<std::pair<std::string, material::Material>> sample_materials() {
  std::vector<std::pair<std::string, material::Material>> all;
  each_law([&](auto const& law) { all.emplace_back(law.schema().name, law); });
  return all;
}

/// E = 1/2 (F^T F - I) in Voigt form; N = 4 takes the in-plane part and 33.
template<int N> material::Voigt<N> green(Matrix3 const& F) {
  Matrix3 const E = 0.5 * (F.transpose() * F - Matrix3::Identity());
  material::Voigt<N> v;
  v.template head<4>() << E(0, 0), E(1, 1), E(2, 2), 2 * E(0, 1);
  if constexpr (N == 6)
    v.template tail<2>() << 2 * E(1, 2), 2 * E(0, 2);
  return v;
}

/// The symmetric tensor of a stress in Voigt form.
inline Matrix3 tensor(material::Voigt<6> const& S) {
  Matrix3 T;
  T << S[0], S[3], S[5], S[3], S[1], S[4], S[5], S[4], S[2];
  return T;
}

} // namespace stiction::test
