// Samples of every adhesion and friction law, and what the tests of all of them share.
#pragma once
#include <algorithm>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "interface/law.hpp"

namespace stiction::test {

using namespace interface;

struct NamedAdhesion {
  std::string name;
  AdhesionLaw law;
};
struct NamedFriction {
  std::string name;
  FrictionLaw law;
};

inline Rcc rcc_sample(double b) {
  Rcc law;
  law.w = 3;
  law.C_n = 5e3;
  law.C_t = law.C_t2 = 7e3;
  law.b = b;
  law.beta0 = 1;
  return law;
}
inline Bilinear bilinear_sample(ModeMix mix = ModeMix::benzeggagh_kenane) {
  Bilinear law{5e4, 120, 160, 3, 7};
  law.mix = mix;
  law.exponent = 2.2;
  return law;
}
inline Exponential exponential_sample(Memory memory, double q, double r = 0) {
  Exponential law{3, 45, 0.04, q, r};
  law.memory = memory;
  return law;
}
inline Dugdale dugdale_sample(Memory memory) {
  Dugdale law{60, 0.05, 0.2};
  law.memory = memory;
  return law;
}

/// By the units of its parameters; pure numbers 0.4.
template<class Law> Law plain_sample() {
  static std::map<std::string, double> const sizes{{"J/m^2", 3}, {"N/m^3", 5e3},  {"Pa", 60},  {"m", 0.02},
                                                   {"m/s", 0.2}, {"N s/m", 0.11}, {"s", 0.04}, {"1", 0.4}};
  Law law;
  for (auto const& parameter : Law::schema().parameters)
    if (parameter.kind == core::Parameter::Kind::number && parameter.need == core::Need::required)
      parameter.set(&law, core::Value{sizes.at(parameter.unit)});
  return law;
}

/// Adds a sample of each alternative of which there is none.
template<class Named, class... Laws>
std::vector<Named> completed(std::vector<Named> all, std::type_identity<std::variant<Laws...>>) {
  auto const add = [&]<class Law>(std::type_identity<Law>) {
    if (std::ranges::none_of(all, [](auto const& named) { return std::holds_alternative<Law>(named.law); }))
      all.push_back({Law::schema().name, plain_sample<Law>()});
  };
  (add(std::type_identity<Laws>{}), ...);
  return all;
}

/// Works of separation of 3 J/m^2 and openings of some 0.01 m; each alternative at least once.
inline std::vector<NamedAdhesion> adhesions() {
  auto bilinear_damage = bilinear_sample();
  bilinear_damage.friction = BondFriction::damage;
  auto exponential_damage = exponential_sample(Memory::irreversible, 0.6);
  exponential_damage.friction = BondFriction::damage;
  std::vector<NamedAdhesion> const known = {
      {"rcc", rcc_sample(0.11)},
      {"rcc without viscosity", rcc_sample(0)},
      {"bilinear", bilinear_sample()},
      {"bilinear, linear mix", bilinear_sample(ModeMix::linear)},
      {"bilinear, damaged friction", bilinear_damage},
      {"exponential", exponential_sample(Memory::irreversible, 1.4)},
      {"exponential, damaged friction", exponential_damage},
      {"exponential, reversible", exponential_sample(Memory::reversible, 1)},
      {"exponential, reversible, coupled", exponential_sample(Memory::reversible, 0.6, 0.3)},
      {"dugdale", dugdale_sample(Memory::reversible)},
      {"dugdale, irreversible", dugdale_sample(Memory::irreversible)},
      {"potential", Potential{3, 0.02}},
      {"attraction", Attraction{3, 0.02}}};
  return completed(known, std::type_identity<AdhesionLaw>{});
}

inline std::vector<NamedFriction> frictions() {
  PressureFriction thirion{0.9, 0.1, 40};
  thirion.decay = PressureDecay::thirion;
  std::vector<NamedFriction> const known = {{"coulomb", Coulomb{0.5}},
                                            {"tresca", Tresca{0.5, 30}},
                                            {"pressure", PressureFriction{0.9, 0.2, 80}},
                                            {"pressure, rising", PressureFriction{0.3, 0.7, 80}},
                                            {"pressure, thirion", thirion},
                                            {"velocity", VelocityFriction{0.4, 0.7, 0.2}},
                                            {"velocity, falling", VelocityFriction{0.7, 0.5, 0.2}},
                                            {"static_kinetic", StaticKinetic{0.6, 0.4}}};
  return completed(known, std::type_identity<FrictionLaw>{});
}

/// Is the damage of a law what its beta counts down from?
inline bool irreversible(AdhesionLaw const& law) {
  return !evolves(law) && std::visit([](auto const& l) { return l.lasts(); }, law);
}
inline bool reversible(AdhesionLaw const& law) {
  return !std::visit([](auto const& l) { return l.lasts(); }, law);
}

/// One walk of a bond: positions x(t) in space, t in [0, 1], in equal steps.
template<class Position> struct Walk {
  AdhesionLaw law;
  Position position;   ///< Eigen::Vector3d(double t), m
  double duration = 1; ///< s
};

struct Account {
  double work = 0;                       ///< of the traction, trapezoidal, J/m^2
  double stored = 0;                     ///< change of the bond's energy
  double dissipated = 0, least = 0;      ///< all, and the least of a step
  double largest = 0;                    ///< traction, Pa
  double predicted = 0, by_moves = 0;    ///< what work is more than stored and dissipated, by the law
  double exact_work = 0, exact_loss = 0; ///< of the straight ways between the steps, J/m^2
  Bond bond;                             ///< at the end
  Local<3> traction = Local<3>::Zero();
};

template<class Position> Account account(Walk<Position> const& walk, int steps) {
  auto const position = [&](int k) -> Eigen::Vector3d {
    return walk.position(static_cast<double>(k) / steps);
  };
  Account result;
  result.bond = initial_bond(walk.law, position(0)[0]);
  double const start = bond_energy(walk.law, result.bond, position(0)[0]);
  for (int k = 1; k <= steps; ++k) {
    Eigen::Vector3d const move = position(k) - position(k - 1);
    BondStep const step{result.bond, walk.duration / steps, false};
    Local<3> const x(position(k)[0], move[1], move[2]);
    Local<3> const pull = -adhere<3>(walk.law, step, x).traction;
    double const taken = dissipation<3>(walk.law, step, x);
    Local<3> const to = opening<3>(x, result.bond);
    Local<3> const from(std::max(position(k - 1)[0], 0.0), to[1] - move[1], to[2] - move[2]);
    BondMove const bond_move{from, to, result.bond.beta, adhere<3>(walk.law, step, x).beta, step.dt};
    result.predicted += integration_loss(walk.law, bond_move);
    result.by_moves += dissipation(walk.law, bond_move);
    result.exact_loss += dissipation<3>(walk.law, step, position(k - 1)[0], x);
    if (!evolves(walk.law))
      result.exact_work -= work_along(walk.law, step, {position(k - 1)[0], 0, 0}, x);
    result.work += 0.5 * (result.traction + pull).dot(move);
    result.dissipated += taken;
    result.least = std::min(result.least, taken);
    result.largest = std::max(result.largest, pull.norm());
    result.traction = pull;
    result.bond = advance<3>(walk.law, step, x);
  }
  result.stored = bond_energy(walk.law, result.bond, position(steps)[0]) - start;
  return result;
}
template<class Position> Account account(AdhesionLaw const& law, Position const& position, int steps) {
  return account(Walk<Position>{law, position}, steps);
}

/// Along a straight line from contact.
inline Account straight(AdhesionLaw const& law, Eigen::Vector3d const& end, int steps) {
  return account(
      law, [&](double t) -> Eigen::Vector3d { return t * end; }, steps);
}

} // namespace stiction::test
