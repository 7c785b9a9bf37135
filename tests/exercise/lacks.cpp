// Laws and schemes that each lack one thing: compiling them must fail with a complaint about every one.
#include "dynamics/scheme/scheme.hpp"
#include "interface/law.hpp"
#include "material/material.hpp"

namespace stiction {

template<template<class> class Owed, class... T>
constexpr bool asked = (core::every<std::variant<T>, Owed> && ...);

namespace material {

struct NoSchema : NeoHookean {
  static void schema();
};
struct NoGeometry : NeoHookean {
  using small_strain = void;
};
struct NoLinearity : NeoHookean {
  using linear = void;
};
struct LinearAtLargeStrains : NeoHookean {
  static constexpr bool linear = true;
};
struct NoResponse : NeoHookean {
  template<int N, Wanted wanted> void respond(Voigt<N> const&) const;
};
struct NoModuli : NeoHookean {
  void moduli() const;
};

template<class Law> constexpr bool ask = asked<owed::OfBulkLaw, Law>;
static_assert(ask<NeoHookean>);
bool const owing[] = {ask<NoSchema>,   ask<NoGeometry>, ask<NoLinearity>, ask<LinearAtLargeStrains>,
                      ask<NoResponse>, ask<NoModuli>};

} // namespace material

namespace interface {

struct NoSchema : Tresca {
  static void schema();
};
struct NoFollowing : Tresca {
  using follows = void;
};
struct NoStart : Tresca {
  void mu_from(Status) const;
};
struct NoWeakening : Tresca {
  void steepest_fall(double) const;
};
struct NoCoefficient : Tresca {};
template<int D> void coefficient(NoCoefficient const&, Sliding<D> const&);

template<class Law> constexpr bool ask_friction = asked<owed::OfFriction, Law>;
static_assert(ask_friction<Tresca>);
bool const sliding[] = {ask_friction<NoSchema>, ask_friction<NoFollowing>, ask_friction<NoStart>,
                        ask_friction<NoWeakening>, ask_friction<NoCoefficient>};

struct NoBondSchema : Rcc {
  static void schema();
};
struct NoSides : Rcc {
  void tangential() const;
};
struct NoRange : Rcc {
  void range() const;
};
struct NoLasting : Rcc {
  void lasts() const;
};
struct NoBeginning : Rcc {
  void initial(double) const;
};
struct NoScales : Rcc {
  void scales() const;
};
struct NoFall : Rcc {
  void steepest_fall(BondStep const&) const;
};
struct NoTraction : Rcc {};
template<int D> void adhere(NoTraction const&, BondStep const&, Local<D> const&);
struct NoNext : Rcc {};
template<int D> void advance(NoNext const&, BondStep const&, Local<D> const&);
struct NoLoss : Rcc {};
template<int D> void dissipation(NoLoss const&, BondStep const&, Local<D> const&);
struct NoEnergy : Rcc {};
void bond_energy(NoEnergy const&, Bond const&, double);
struct NoEvolution : Rcc {
  using evolves = void;
};
struct NoTime : Rcc {
  void time() const;
};
struct NoAudit : Rcc {};
void integration_loss(NoAudit const&, BondMove const&);
struct NoSpending : Rcc {};
void dissipation(NoSpending const&, BondMove const&);
struct Timeless : NoTime { // needs none
  static constexpr bool evolves = false;
};

template<class Law> constexpr bool ask = asked<owed::OfAdhesion, Law>;
static_assert(ask<Rcc> && ask<Timeless>);
bool const bonding[] = {ask<NoBondSchema>, ask<NoSides>,  ask<NoRange>,   ask<NoLasting>,
                        ask<NoBeginning>,  ask<NoScales>, ask<NoFall>,    ask<NoTraction>,
                        ask<NoNext>,       ask<NoLoss>,   ask<NoEnergy>,  ask<NoEvolution>,
                        ask<NoTime>,       ask<NoAudit>,  ask<NoSpending>};

} // namespace interface

namespace dynamics {

struct NoSchema : Newmark {
  static void schema();
};
struct NoWeights : Newmark {
  void weights() const;
};

template<class T> constexpr bool ask = asked<owed::OfScheme, T>;
static_assert(ask<Newmark>);
bool const stepping[] = {ask<NoSchema>, ask<NoWeights>};

} // namespace dynamics
} // namespace stiction
