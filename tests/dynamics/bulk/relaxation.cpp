// Bodies that relax, over time: relaxation, creep, moduli over frequency, large shear, ledger.
#include <Eigen/QR>

#include "dynamics/space.hpp"

using namespace stiction;

namespace {

constexpr double G = 400; // Pa, E = 1000, nu = 0.25
constexpr double pi = 3.14159265358979323846;

struct Term {
  double share, time, bulk = 0; ///< 1, s, 1
};
using Terms = std::vector<Term>;

test::Input series(Terms const& terms) {
  core::List all;
  for (auto const& term : terms)
    all.push_back(test::make("prony", {{"share", test::value(term.share)},
                                       {"time", test::value(term.time, "s")},
                                       {"bulk_share", test::value(term.bulk)}}));
  return test::list(std::move(all));
}
test::Input neo_hookean() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.25)}});
}

/// One cell of 1 m whose bottom is held and whose top goes along x; top: path or load of it.
test::Input sheared(test::Input law, Terms const& terms) {
  auto table = test::make("scene");
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 1}, {1, 1}}, std::move(law));
  test::at(table, "bodies.bar.relaxing") = series(terms);
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}
test::Input along(test::Input table, std::vector<double> const& times, std::vector<double> const& x,
                  double rise = 0) {
  std::vector<double> y(times.size(), rise);
  y.front() = 0;
  test::at(table, "schedule") = test::schedule({{times.back(), 1}});
  test::at(table, "motions") = test::list({test::fix("bar.bottom"), test::drive("bar.top", times, x, y)});
  return table;
}

struct Marched {
  std::vector<double> force, push; ///< on the top along x and y, N
  dynamics::State end;
};
Marched march(test::Input const& table, double end, int steps) {
  auto const scene = scene::build(table);
  scene.model->control.force_tolerance = 1e-13;
  dynamics::Stepper stepper(*scene.model);
  Marched marched;
  marched.end = test::march(stepper, stepper.initial(), end / steps, steps,
                            [&](dynamics::State const&, dynamics::State const& next) {
                              auto const force = test::force_on(scene, next, "bar.top");
                              marched.force.push_back(force.x());
                              marched.push.push_back(force.y());
                            });
  return marched;
}

/// Force on the top after a ramp to this shear within t1, of small strains.
double relaxed(Terms const& terms, double shear, double t1, double t) {
  double force = G * shear;
  for (auto const& [share, time, bulk] : terms)
    force += share * G * shear / t1 * time * -std::expm1(-t1 / time) * std::exp(-(t - t1) / time);
  return force;
}

/// Shear and stretch at most, 1; both grow evenly until 1 s.
struct Stretched {
  double shear, stretch;
  [[nodiscard]] Eigen::Matrix3d at(double t) const {
    Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
    F(0, 1) = shear * std::min(t, 1.0);
    F(1, 1) = 1 + (stretch - 1) * std::min(t, 1.0);
    return F;
  }
};

/// dA/dt = (C'^-1 - A) / tau of one network, by Runge and Kutta's method; the force on the top along x with
/// the law's own.
double finite_force(Term const& term, Stretched const& way, double t) {
  auto const metric = [&](double at) -> Eigen::Matrix3d {
    Eigen::Matrix3d const F = way.at(at);
    return F.transpose() * F / std::cbrt(F.determinant() * F.determinant());
  };
  auto const slope = [&](double at, Eigen::Matrix3d const& A) -> Eigen::Matrix3d {
    return (metric(at).inverse() - A) / term.time;
  };
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  int const steps = 4000; // the path's knot is the end of one
  double const h = t / steps;
  for (int i = 0; i < steps; ++i) {
    double const at = i * h;
    Eigen::Matrix3d const a = slope(at, A), b = slope(at + h / 2, A + h / 2 * a),
                          c = slope(at + h / 2, A + h / 2 * b), d = slope(at + h, A + h * c);
    A += h / 6 * (a + 2 * b + 2 * c + d);
  }
  // the part along C^-1, of the volume too, makes no force along x
  Eigen::Matrix3d const M = G * (Eigen::Matrix3d::Identity() + term.share * A), F = way.at(t);
  return (F * M)(0, 1) / std::cbrt(F.determinant() * F.determinant());
}

/// One cube of 1 m in space whose sides at the origin are held.
test::Input cube(Terms const& terms) {
  auto table = test::space();
  test::at(table, "bodies.bar") =
      test::box({.size = {1, 1, 1}, .cells = {1, 1, 1}}, test::linear_elastic(1000, 0.25));
  test::at(table, "bodies.bar.relaxing") = series(terms);
  test::at(table, "motions") = test::list(
      {test::fix_in("bar.left", "x"), test::fix_in("bar.bottom", "z"), test::fix_in("bar.front", "y")});
  return table;
}
core::List& list_of(test::Input& table, char const* name) {
  auto& found = test::at(table, name);
  if (found.list() == nullptr)
    found = test::list({});
  return std::get<core::List>(found.value);
}

/// Storage and loss modulus from the force on a block that swings, its transients fitted with it.
std::pair<double, double> moduli(Terms const& terms, double omega) {
  constexpr int steps = 800, amplitude_steps = 400; // two periods
  double const end = 4 * pi / omega, amplitude = 1e-3;
  std::vector<double> times, x;
  for (int i = 0; i <= steps; ++i) {
    times.push_back(i * end / steps);
    x.push_back(amplitude * std::sin(2 * pi * i / amplitude_steps));
  }
  auto const force =
      march(along(sheared(test::linear_elastic(1000, 0.25), terms), times, x), end, steps).force;
  auto const columns = static_cast<Eigen::Index>(2 + terms.size());
  Dense basis(steps, columns);
  Vector values(steps);
  for (int i = 0; i < steps; ++i) {
    double const t = times[static_cast<std::size_t>(i) + 1];
    basis(i, 0) = std::sin(omega * t);
    basis(i, 1) = std::cos(omega * t);
    for (std::size_t k = 0; k < terms.size(); ++k)
      basis(i, static_cast<Eigen::Index>(2 + k)) = std::exp(-t / terms[k].time);
    values[i] = force[static_cast<std::size_t>(i)];
  }
  Vector const fit = basis.completeOrthogonalDecomposition().solve(values);
  return {fit[0] / amplitude, fit[1] / amplitude};
}

/// A bar of rubber that starts with a velocity, its foot held; ledger after 0.5 s.
struct Swing {
  dynamics::Ledger ledger;
  bool falls = false; ///< did the loss ever?
};
Swing swing(test::Input scheme, test::Input law, int steps) {
  auto table = test::make("scene");
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 1}, {2, 2}}, std::move(law), 3);
  test::at(table, "bodies.bar.relaxing") = series({{0.8, 0.05, 0.3}, {0.5, 3e-3}, {0, 0.02, 0.6}});
  test::at(table, "scheme") = std::move(scheme);
  test::at(table, "schedule") = test::schedule({{0.5, steps}});
  test::at(table, "motions") = test::list({test::fix("bar.bottom")});
  test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
  auto const scene = scene::build(table);
  for (Index const node : test::nodes_of(scene, "bar.all"))
    scene.model->velocity.row(node) = 3 * scene.model->reference(node, 1) * Eigen::RowVector2d(1, 0.4);
  scene.model->control.force_tolerance = 1e-12;
  dynamics::Stepper stepper(*scene.model);
  Swing found;
  found.ledger = test::march(stepper, stepper.initial(), 0.5 / steps, steps,
                             [&](dynamics::State const& old, dynamics::State const& next) {
                               found.falls =
                                   found.falls || next.ledger.relaxation_loss < old.ledger.relaxation_loss;
                             })
                     .ledger;
  return found;
}

} // namespace

TEST_CASE("a linear body that relaxes has a matrix for every step size: no step is corrected twice") {
  auto table = along(sheared(test::linear_elastic(1000, 0.25), {{4, 1}}), {0, 100}, {0, 0.01});
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 1}, {2, 2}}, test::linear_elastic(1000, 0.25));
  test::at(table, "bodies.bar.relaxing") = series({{4, 1}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto state = stepper.initial();
  int first = 0;
  for (double const dt : {0.01, 10.0, 0.3}) {
    auto outcome = stepper.step(state, dt);
    REQUIRE(outcome.converged());
    first = first == 0 ? outcome.iterations : first;
    CHECK(outcome.iterations == first);
    state = std::move(outcome.state);
  }
}

TEST_CASE("a ramp of small strain relaxes as its Prony series says, whatever the step") {
  Terms const terms{{0.5, 0.03}, {1.5, 1}, {0.2, 50}};
  for (int const steps : {4, 40}) {
    auto const marched =
        march(along(sheared(test::linear_elastic(1000, 0.25), terms), {0, 1, 4}, {0, 1e-3, 1e-3}), 4, steps);
    for (int i = steps / 4; i <= steps; i += steps / 4) {
      CAPTURE(i);
      CHECK(marched.force[static_cast<std::size_t>(i) - 1] ==
            doctest::Approx(relaxed(terms, 1e-3, 1, 4.0 * i / steps)).epsilon(1e-11));
    }
    auto const& ledger = marched.end.ledger;
    CHECK(ledger.relaxation_loss > 0.2 * ledger.motion_work);
  }
  // rubber of small strains does the same
  auto const rubber = march(along(sheared(neo_hookean(), terms), {0, 1, 4}, {0, 1e-5, 1e-5}), 4, 40);
  CHECK(rubber.force.back() == doctest::Approx(relaxed(terms, 1e-5, 1, 4)).epsilon(1e-6));
}

TEST_CASE("times from a billionth to a billion of the run: gone at once, or a spring beside the law") {
  for (auto const& [time, left] : {std::pair{1e-9, 0.0}, {1e9, 0.4}})
    for (bool const rubber : {false, true}) {
      auto law = rubber ? neo_hookean() : test::linear_elastic(1000, 0.25);
      auto const marched = march(along(sheared(std::move(law), {{0.4, time}}), {0, 1}, {0, 0.01}), 1, 10);
      CAPTURE(time);
      CHECK(marched.force.back() == doctest::Approx(G * 0.01 * (1 + left)).epsilon(1e-6));
      CHECK(std::abs(marched.end.ledger.scheme_loss()) <
            0.11 * marched.end.ledger.strain); // backward in time
      CHECK(marched.end.ledger.relaxation_loss < 1e-7 * marched.end.ledger.strain);
    }
}

TEST_CASE("creep under a growing force nears its closed form as dt^2") {
  double const g = 1.5, time = 0.4, rate = 2; // Pa/s
  auto const error = [&](int steps) {
    auto table = sheared(test::linear_elastic(1000, 0.25), {{g, time}});
    test::at(table, "motions") = test::list({test::fix("bar.bottom"), test::fix("bar.top", false, true)});
    test::at(table, "loads") =
        test::list({test::make("load.traction", {{"set", test::text("bar.top")},
                                                 {"times", test::values({0, 1}, "s")},
                                                 {"x", test::values({0, rate}, "Pa")}})});
    auto const scene = scene::build(table);
    scene.model->control.force_tolerance = 1e-13;
    dynamics::Stepper stepper(*scene.model);
    auto const end = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
    double const slow = time * (1 + g), exact = rate / G * (1 + g / (1 + g) * slow * std::expm1(-1 / slow));
    return end.u[2 * test::nodes_of(scene, "bar.top")[0]] / exact - 1;
  };
  double const a = std::abs(error(20)), b = std::abs(error(40)), c = std::abs(error(400));
  CHECK(std::log2(a / b) == doctest::Approx(2).epsilon(0.03));
  CHECK(c < 1e-6);
}

TEST_CASE("pressed from all sides a cube relaxes by its volume terms alone") {
  Terms const terms{{5, 0.1}, {0.3, 0.5, 0.8}, {0, 4, 1.5}};
  double const e = 1e-3, t1 = 1, end = 4;
  for (int const steps : {4, 40}) {
    auto table = cube(terms);
    auto& motions = list_of(table, "motions");
    std::vector<double> const times{0, t1, end}, path{0, e, e};
    motions.push_back(test::drive("bar.right", times, {{path, {}, {}}}));
    motions.push_back(test::drive("bar.back", times, {{{}, path, {}}}));
    motions.push_back(test::drive("bar.top", times, {{{}, {}, path}}));
    test::at(table, "schedule") = test::schedule({{end, steps}});
    auto const scene = scene::build(table);
    scene.model->control.force_tolerance = 1e-13;
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), end / steps, steps);
    double const K = G * 5 / 3; // nu = 0.25
    double exact = K * 3 * e;
    for (auto const& [share, time, bulk] : terms)
      exact += bulk * K * 3 * e / t1 * time * -std::expm1(-t1 / time) * std::exp(-(end - t1) / time);
    CHECK(test::drive_on(scene, state, "bar.right").x() == doctest::Approx(exact).epsilon(1e-11));
    CHECK(test::drive_on(scene, state, "bar.top").z() == doctest::Approx(exact).epsilon(1e-11));
    CHECK(state.ledger.relaxation_loss > 0.1 * state.ledger.motion_work);
  }
}

TEST_CASE("a cube drawn from all sides by a growing traction creeps in volume, in error as dt^2") {
  double const k = 1.5, time = 0.4, pull = 2; // Pa/s
  auto const error = [&](int steps) {
    auto table = cube({{0.7, 0.1, 0}, {0, time, k}});
    auto& loads = list_of(table, "loads");
    int component = 0;
    for (char const* set : {"bar.right", "bar.back", "bar.top"})
      loads.push_back(
          test::make("load.traction", {{"set", test::text(set)},
                                       {"times", test::values({0, 1}, "s")},
                                       {std::string(1, "xyz"[component++]), test::values({0, pull}, "Pa")}}));
    test::at(table, "schedule") = test::schedule({{1, steps}});
    auto const scene = scene::build(table);
    scene.model->control.force_tolerance = 1e-13;
    dynamics::Stepper stepper(*scene.model);
    auto const end = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
    double const slow = time * (1 + k), K = G * 5 / 3,
                 exact = pull / K * (1 + k / (1 + k) * slow * std::expm1(-1 / slow)) / 3;
    return end.u[3 * test::nodes_of(scene, "bar.right")[0]] / exact - 1;
  };
  double const a = std::abs(error(20)), b = std::abs(error(40)), c = std::abs(error(400));
  CHECK(std::log2(a / b) == doctest::Approx(2).epsilon(0.03));
  CHECK(c < 1e-6);
}

TEST_CASE("a confined block relaxes in shear and volume at once, each by its own times") {
  Terms const terms{{0.5, 0.03, 0.2}, {0, 1, 0.9}, {2, 5, 0}};
  double const e = 1e-3, K = G * 5 / 3, M = K + 4 * G / 3;
  for (int const steps : {4, 40}) {
    auto const marched =
        march(along(sheared(test::linear_elastic(1000, 0.25), terms), {0, 1, 4}, {0, 0, 0}, e), 4, steps);
    double exact = M * e;
    for (auto const& [share, time, bulk] : terms)
      exact += (bulk * K + share * G * 4 / 3) * e * time * -std::expm1(-1 / time) * std::exp(-3 / time);
    CHECK(marched.push.back() == doctest::Approx(exact).epsilon(1e-11));
  }
}

TEST_CASE("equal shares leave Poisson's ratio: a bar relaxes as E (1 + s exp(-t/tau)), whatever the step") {
  double const e = 1e-3, share = 4, time = 1, end = 2, t1 = 0.5;
  for (int const steps : {4, 40}) {
    auto table = cube({{share, time, share}});
    list_of(table, "motions").push_back(test::drive("bar.right", {0, t1, end}, {{{0, e, e}, {}, {}}}));
    test::at(table, "schedule") = test::schedule({{end, steps}});
    auto const scene = scene::build(table);
    scene.model->control.force_tolerance = 1e-13;
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), end / steps, steps);
    double const exact =
        1000 * e * (1 + share * time / t1 * -std::expm1(-t1 / time) * std::exp((t1 - end) / time));
    CHECK(test::drive_on(scene, state, "bar.right").x() == doctest::Approx(exact).epsilon(1e-11));
    CHECK(state.u[3 * test::nodes_of(scene, "bar.top")[0] + 2] == doctest::Approx(-0.25 * e).epsilon(1e-10));
  }
}

TEST_CASE("large compression relaxes in volume as the equation of its network, to second order") {
  double const time = 0.6, bulk = 1.5, stretch = 0.6, K = G * 5 / 3;
  auto const path = [&](double t) { return std::log(1 + (stretch - 1) * std::min(t, 1.0)); };
  double a = 0;
  int const pieces = 4000;
  double const h = 2.0 / pieces; // Runge and Kutta's method
  for (int i = 0; i < pieces; ++i) {
    auto const slope = [&](double t, double at) { return (path(t) - at) / time; };
    double const t = i * h, k1 = slope(t, a), k2 = slope(t + h / 2, a + h / 2 * k1),
                 k3 = slope(t + h / 2, a + h / 2 * k2), k4 = slope(t + h, a + h * k3);
    a += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  double const exact = bulk * K * (std::log(stretch) - a) / stretch;
  auto const push = [&](Terms const& terms, int steps) {
    return march(along(sheared(neo_hookean(), terms), {0, 1, 2}, {0, 0, 0}, stretch - 1), 2, steps);
  };
  // networks of a modulus next to 0 leave the law alone
  double const law = push({{0, 1, 1e-12}}, 4).push.back();
  auto const error = [&](int steps) {
    return std::abs((push({{0, time, bulk}}, steps).push.back() - law) / exact - 1);
  };
  double const coarse = error(20), fine = error(40);
  CHECK(coarse < 1e-2);
  CHECK(std::log2(coarse / fine) == doctest::Approx(2).epsilon(0.05));
  CHECK(error(2000) < 1e-6);
  auto const few = push({{0, time, bulk}}, 50).end.ledger, many = push({{0, time, bulk}}, 500).end.ledger;
  CHECK(many.relaxation_loss > 0.1 * many.motion_work);
  CHECK(std::abs(many.scheme_loss()) < 0.11 * std::abs(few.scheme_loss()));
}

TEST_CASE("storage and loss modulus over four decades of frequency") {
  Terms const terms{{2, 1}, {3, 0.05}};
  for (double const omega : {0.02, 0.2, 2.0, 20.0, 200.0}) {
    double storage = G, loss = 0;
    for (auto const& [share, time, bulk] : terms) {
      double const x = omega * time;
      storage += share * G * x * x / (1 + x * x);
      loss += share * G * x / (1 + x * x);
    }
    auto const [found, lost] = moduli(terms, omega);
    CAPTURE(omega);
    CHECK(found == doctest::Approx(storage).epsilon(1e-4));
    CHECK(lost == doctest::Approx(loss).epsilon(5e-4));
  }
}

TEST_CASE("large shear relaxes as the equation of its network, to second order") {
  Term const term{1.5, 0.6};
  Stretched const way{1.2, 0.7};
  double const exact = finite_force(term, way, 2);
  auto const table =
      along(sheared(neo_hookean(), {term}), {0, 1, 2}, {0, way.shear, way.shear}, way.stretch - 1);
  auto const error = [&](int steps) { return std::abs(march(table, 2, steps).force.back() / exact - 1); };
  double const coarse = error(20), fine = error(40);
  CHECK(coarse < 1e-2);
  CHECK(std::log2(coarse / fine) == doctest::Approx(2).epsilon(0.05));
  CHECK(error(2000) < 1e-6);
  auto const ledger = [&](int steps) { return march(table, 2, steps).end.ledger; };
  auto const few = ledger(50), many = ledger(500);
  CHECK(many.relaxation_loss > 0.1 * many.motion_work);
  CHECK(std::abs(many.scheme_loss()) <
        0.11 * std::abs(few.scheme_loss())); // ends do the work of quasi-statics
}

TEST_CASE("every scheme with inertia keeps the account of bodies that relax") {
  for (bool const rubber : {false, true})
    for (char const* name : {"scheme.theta_xi", "scheme.newmark", "scheme.central_difference"}) {
      CAPTURE(name);
      CAPTURE(rubber);
      auto const law = [&] { return rubber ? neo_hookean() : test::linear_elastic(1000, 0.25); };
      auto const coarse = swing(test::make(name), law(), 400), fine = swing(test::make(name), law(), 800);
      CHECK_FALSE(coarse.falls);
      CHECK(fine.ledger.relaxation_loss > 0.2 * fine.ledger.start);
      CHECK(std::abs(fine.ledger.scheme_loss()) < 2e-3 * fine.ledger.start);
      CHECK(std::log2(std::abs(coarse.ledger.scheme_loss() / fine.ledger.scheme_loss())) > 1.6);
      CHECK(std::abs(fine.ledger.unaccounted()) < 1e-6 * fine.ledger.start);
    }
}

TEST_CASE("a step a million times too long for a network is stable") {
  for (bool const rubber : {false, true}) {
    auto law = rubber ? neo_hookean() : test::linear_elastic(1000, 0.25);
    auto const found = swing(test::make("scheme.theta_xi"), std::move(law), 20);
    CHECK_FALSE(found.falls);
    CHECK(found.ledger.kinetic + found.ledger.strain < found.ledger.start);
  }
}
