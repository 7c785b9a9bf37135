// Doubts of single steps put together, and the energy of the scheme.
#include "scene/run/remarks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <utility>

#include "contact/solvers/answers.hpp"
#include "scene/description/human.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

namespace {

/// Parts of the largest energy of a run from which on what its scheme made or lost is told.
constexpr double worth_telling_made = 0.01, worth_telling_lost = 0.1;
/// Of the energy that a step without inertia turns over, what its works miss where it follows its bonds.
constexpr double leapt = 0.01;
/// Change of a cell's edge over its length from which on a law for small strains is far off, and the part of
/// a body's cells from which on that is told: peaks at corners are not.
constexpr double large_strain = 0.1, worth_telling_cells = 0.1;
/// Part of a facet from which on is told how deep the other side has dug in: chords of arcs take less.
constexpr double worth_telling_dug = 0.1;

/// Largest change of a way from the first node to another one of a cell, over its length.
double largest_change(dynamics::Model const& model, std::span<Index const> nodes, Index first_node,
                      Vector const& u) {
  int const dim = model.dim();
  Index const from = first_node + nodes.front();
  double most = 0;
  for (Index const node : nodes.subspan(1)) {
    Index const to = first_node + node;
    most = std::max(most, (u.segment(dim * to, dim) - u.segment(dim * from, dim)).norm() /
                              (model.reference.row(to) - model.reference.row(from)).norm());
  }
  return most;
}

/// Cells of laws for small strains of a body: how many, and how many of them change by more than that.
std::pair<Index, Index> cells_beyond(dynamics::Model const& model, std::size_t b, Vector const& u) {
  auto const& body = *model.bodies[b];
  Index cells = 0, beyond = 0;
  for (std::size_t block = 0; block < body.mesh.blocks.size(); ++block) {
    if (!solid::small_strain(body.law_of(block)))
      continue;
    std::span<Index const> const nodes = body.mesh.blocks[block].nodes;
    auto const size = static_cast<std::size_t>(mesh::info(body.mesh.blocks[block].kind).nodes);
    for (std::size_t first = 0; first < nodes.size(); first += size, ++cells)
      beyond +=
          largest_change(model, nodes.subspan(first, size), model.first_node[b], u) > large_strain ? 1 : 0;
  }
  return {cells, beyond};
}

contact::Doubts doubts(dynamics::ContactSystem const& contact, contact::Checked which,
                       contact::Snapped snapped) {
  auto const& problem = contact.problem();
  if (problem.points.empty() || problem.W.together())
    return {};
  return contact::doubts(problem, contact.forces(), contact::displacement(problem, contact.forces()), which,
                         snapped);
}

/// "2 answers were found ..." to the last problem.
std::string answers_of(dynamics::ContactSystem const& contact) {
  auto const& problem = contact.problem();
  auto const text = words(contact::seek_answers(problem, contact.forces()), problem.dim);
  return text.empty() ? "others were not sought, as it is large" : text;
}

/// "point 17 of pair floor", counted from one as in the pair's line of points.
std::string words_of(Scene const& scene, std::size_t pair, Index point) {
  return fmt::format("point {} of pair {}", point + 1, scene.pairs[pair]);
}

std::string words_of(Scene const& scene, dynamics::ContactSystem const& contact, Index row) {
  auto const point = contact.point_of(row);
  return words_of(scene, static_cast<std::size_t>(point.pair), point.index);
}

/// What makes no energy where the present scheme does: when contact ends, or in finite rotations.
char const* tamer_scheme(Scene const& scene) {
  auto const& model = *scene.model;
  auto const relaxes = [](auto const& body) { return !body->relaxing.empty(); };
  if (dynamics::weights(model.scheme).skin || std::ranges::any_of(model.bodies, relaxes))
    return "a scheme that damps (theta = xi = 1)";
  if (model.pairs.empty() || std::ranges::any_of(model.motions, [](auto const& one) { return !!one.turn; }))
    return "a scheme that damps what swings in bodies that turn (theta = xi = 0.6)";
  return "scheme.theta_xi{contact_inertia = \"cells\"}, which makes none when contact ends";
}

} // namespace

void Remarks::examine(dynamics::ContactSystem const& contact, double t, double lost) {
  bool const inertia = dynamics::weights(scene_->model->scheme).inertia;
  note(contact, t,
       doubts(contact, contact::Checked::bearing,
              !inertia && lost > leapt ? contact::Snapped::yes : contact::Snapped::unknown));
}

void Remarks::examine_unanswered(dynamics::ContactSystem const& contact, double t) {
  note(contact, t, doubts(contact, contact::Checked::all, contact::Snapped::unknown));
}

void Remarks::note(dynamics::ContactSystem const& contact, double t, contact::Doubts const& found) {
  ++steps_;
  auto const add = [&](Remark& remark, auto const& doubt) {
    if (++remark.steps == 1)
      remark.text = fmt::format("at t = {}, {}: {}; here {}", human(t, "s"),
                                words_of(*scene_, contact, doubt.worst), words(doubt), answers_of(contact));
  };
  if (found.friction.any())
    add(friction_, found.friction);
  if (found.softening.any())
    add(softening_, found.softening);
  if (found.weakening.any())
    add(weakening_, found.weakening);
}

void Remarks::seek_met(dynamics::State const& state) {
  constexpr double met = -std::numeric_limits<double>::infinity();
  for (std::size_t pair = 0; pair < state.contacts.size(); ++pair)
    if (nearest_[pair] > met)
      for (auto const& point : state.contacts[pair]) {
        if (point.status != interface::Status::open || !point.adhesion.isZero(0))
          nearest_[pair] = met;
        else if (point.foot.found() && !point.beneath)
          nearest_[pair] = std::min(nearest_[pair], point.gap);
      }
}

/// Surfaces apart from the bodies go by backward Euler, which takes from what turns or swings.
std::string Remarks::losing_less() const {
  bool const unmet = std::ranges::all_of(nearest_, [](double gap) { return gap >= 0; });
  bool const apart = !nearest_.empty() && dynamics::weights(scene_->model->scheme).surface_apart();
  if (!unmet || !apart)
    return "smaller steps and a finer mesh where bodies land lose less";
  bool const free = std::ranges::any_of(scene_->model->rigids, &dynamics::RigidBody::free);
  return fmt::format(
      "nothing touched, and contact surfaces and free rigid bodies go by backward Euler, which "
      "takes energy and angular momentum from what turns or swings; smaller steps take less, "
      "contact_inertia = \"full\"{} hardly any",
      free ? "" : " or \"none\"");
}

void Remarks::add_unmet(std::vector<std::string>& all) const {
  for (std::size_t pair = 0; pair < nearest_.size() && steps_ > 0; ++pair)
    if (std::isfinite(nearest_[pair]))
      all.push_back(
          fmt::format("pair {}: nothing of it touched or adhered in the run; no point came nearer than {}",
                      scene_->pairs[pair], human(nearest_[pair], "m")));
    else if (nearest_[pair] > 0)
      all.push_back(fmt::format(
          "pair {}: nothing of it touched or adhered in the run; no point came within reach of the "
          "other side: do the two look at each other?",
          scene_->pairs[pair]));
}

void Remarks::seek_beneath(dynamics::State const& state) {
  for (std::size_t pair = 0; pair < state.contacts.size(); ++pair) {
    auto const& points = state.contacts[pair];
    auto const lost =
        std::find_if(points.begin(), points.end(), [](auto const& point) { return point.beneath; });
    if (lost == points.end())
      continue;
    if (++beneath_.steps == 1)
      beneath_.text = fmt::format(
          "at t = {}, {} came in past a border of its counterpart's surface and lies {} beneath it, where no "
          "contact holds it: let the primary go on round the corner, or make the finer side the secondary "
          "one",
          human(state.t, "s"), words_of(*scene_, pair, static_cast<Index>(lost - points.begin())),
          human(-lost->gap, "m"));
    return;
  }
}

void Remarks::seek_let_go(dynamics::State const& old, dynamics::State const& next) {
  for (std::size_t pair = 0; pair < next.contacts.size(); ++pair) {
    auto const &before = old.contacts[pair], &after = next.contacts[pair];
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (before[i].bond.beta < interface::lasting_beta || !before[i].foot.found() || after[i].foot.found())
        continue;
      if (++let_go_.steps == 1)
        let_go_.text = fmt::format(
            "at t = {}, {} loses its counterpart, past the border or far off, and with it {} "
            "of its bond: let the primary go on beyond what is bonded to it",
            human(next.t, "s"), words_of(*scene_, pair, static_cast<Index>(i)), percent(before[i].bond.beta));
      return;
    }
  }
}

void Remarks::seek_large_strain(dynamics::State const& state) {
  auto const& model = *scene_->model;
  for (std::size_t b = 0; b < model.bodies.size() && strained_.empty(); ++b) {
    auto const& body = *model.bodies[b];
    auto const [cells, beyond] = cells_beyond(model, b, state.u);
    if (static_cast<double>(beyond) > worth_telling_cells * static_cast<double>(cells))
      strained_ = fmt::format(
          "at t = {} {} of the cells of body {} are strained or turned by more than {}, and {} knows small "
          "strains and rotations only: material.neo_hookean{{young = ..., poisson = ...}} knows large ones",
          human(state.t, "s"), percent(static_cast<double>(beyond) / static_cast<double>(cells)), body.name,
          percent(large_strain),
          std::visit([](auto const& law) { return law.schema().name; }, body.material));
  }
}

void Remarks::seek_dug_in(dynamics::State const& state) {
  auto const& model = *scene_->model;
  for (std::size_t pair = 0; pair < state.contacts.size(); ++pair) {
    if (digs_.size() == pair)
      digs_.emplace_back(model, pair);
    auto const found = digs_[pair].deepest(state.u, std::max(worth_telling_dug, dug_part_));
    if (found.node < 0)
      continue;
    dug_part_ = found.part;
    Vector const at =
        model.reference.row(found.node).transpose() + state.u.segment(model.dim() * found.node, model.dim());
    dug_in_ = fmt::format(
        "at t = {}, a node of the primary of pair {}, at ({:.4g}) m, lies {} within the body of the "
        "secondary, {:.2g} of a facet: it digs in between points that do not see it, and forces there are "
        "missing; make the side with sharp corners or the finer mesh the secondary one, or give "
        "discretisation = \"mortar\"",
        human(state.t, "s"), scene_->pairs[pair], fmt::join(at, ", "), human(found.depth, "m"), found.part);
  }
}

/// What a snap of quasi-static steps loses is no fault of a scheme.
void Remarks::weigh(dynamics::Ledger const& old, dynamics::Ledger const& ledger, double rounded) {
  if (!std::exchange(weighed_, true)) {
    surface_ = old.surface; // gamma A of all of it is no energy that anything turns over
    turned_over_ = old.kinetic + old.strain;
  }
  stabilised_ = ledger.stabilisation_loss;
  turned_over_ = std::max({turned_over_, ledger.kinetic + ledger.strain, std::abs(ledger.motion_work),
                           std::abs(ledger.load_work), std::abs(ledger.potential), std::abs(ledger.bond),
                           ledger.spring, std::abs(ledger.surface - surface_)});
  if (double const made = -ledger.scheme_loss(); made > rounded)
    made_ = std::max(made_, made);
  if (dynamics::weights(scene_->model->scheme).inertia) {
    lost_ = ledger.scheme_loss();
    double const taken = ledger.bond + ledger.bonding_loss - old.bond - old.bonding_loss;
    double const free = old.scheme_loss() - ledger.scheme_loss();
    torn_ += std::max(0.0, taken);
    torn_free_ += free > rounded ? std::clamp(taken, 0.0, free) : 0;
  } else
    spent_ = std::max({spent_, ledger.bonding_loss, ledger.friction_loss});
}

/// Where hardly anything acts, as in free flight, an imbalance is small beside the forces of the run.
void Remarks::balance(dynamics::Outcome const& outcome) {
  force_ = std::max(force_, outcome.force_scale);
  if (outcome.out_of_balance > scene_->model->control.force_tolerance)
    unmet_ = std::max(unmet_, outcome.out_of_balance * outcome.force_scale);
}

/// Tolerances that rounding did not let the run meet.
void Remarks::add_rounded(std::vector<std::string>& all) const {
  double const asked = scene_->model->control.force_tolerance;
  double const sharp = std::visit([](auto const& solver) { return solver.tolerance; }, scene_->model->solver);
  auto const add = [&](char const* what, double tolerance, double reached, char const* of) {
    all.push_back(fmt::format(
        "{} = {:g} is less than rounding allows and was met as far as that goes, to {:.1e} of the "
        "largest {}",
        what, tolerance, reached, of));
  };
  bool const acts = unmet_ < 0.5 * force_; // else nothing does but rounding, as in free flight
  if (acts && unmet_ > asked * force_)
    add("control.force_tolerance", asked, unmet_ / force_, "force");
  if (contact_ > sharp)
    add("solver.tolerance", sharp, contact_, "traction");
}

std::vector<std::string> Remarks::texts() const {
  std::vector<std::string> all;
  for (auto const* remark : {&friction_, &softening_, &weakening_, &beneath_, &let_go_})
    if (remark->steps > 0)
      all.push_back(fmt::format("{} ({} of {} steps)", remark->text, remark->steps, steps_));
  for (auto const* text : {&strained_, &dug_in_})
    if (!text->empty())
      all.push_back(*text);
  add_unmet(all);
  add_rounded(all);
  bool const inertia = dynamics::weights(scene_->model->scheme).inertia;
  double const turned_over = std::max(turned_over_, spent_);
  if (!inertia && made_ > worth_telling_lost * turned_over)
    all.push_back(
        fmt::format("the time steps made energy, {} of the largest of the run: too much opens, snaps "
                    "or goes round in one of them; take smaller ones",
                    percent(made_ / turned_over)));
  else if (inertia && made_ > worth_telling_made * turned_over_)
    all.push_back(
        fmt::format("the time steps made energy, {} of the largest of the run: take smaller steps, or {}",
                    percent(made_ / turned_over_), tamer_scheme(*scene_)));
  else if (lost_ > worth_telling_lost * turned_over_)
    all.push_back(fmt::format("the time steps lost energy, {} of the largest of the run: {}",
                              percent(lost_ / turned_over_), losing_less()));
  if (torn_free_ > worth_telling_lost * torn_)
    all.push_back(fmt::format(
        "bonds were torn off in steps too long to see them pull: {} of the energy that they took, the time "
        "scheme made; take smaller steps there, or `accuracy`",
        percent(torn_free_ / torn_)));
  if (double const part = dynamics::weights(scene_->part.scheme).stabilisation; part > 0)
    all.push_back(
        fmt::format("stabilisation = {:g}: its viscous force took {} of the largest energy of the run{}",
                    part, percent(turned_over_ > 0 ? stabilised_ / turned_over_ : 0),
                    stabilised_ > worth_telling_made * turned_over_
                        ? ": take less of it, or let the end rest for some steps, and see whether the "
                          "results stay"
                        : ""));
  return all;
}

double lost_part(dynamics::Ledger const& old, dynamics::Ledger const& next) {
  double const turned_over =
      std::max({std::abs(next.motion_work - old.motion_work), std::abs(next.load_work - old.load_work),
                std::abs(next.potential - old.potential), std::abs(next.strain - old.strain),
                std::abs(next.bond - old.bond) + std::abs(next.bonding_loss - old.bonding_loss),
                std::abs(next.spring - old.spring), std::abs(next.surface - old.surface)});
  return turned_over > 0 ? (next.scheme_loss() - old.scheme_loss()) / turned_over : 0;
}

std::string unseen_by_accuracy(Scene const& scene) {
  auto const& model = *scene.model;
  if (!scene.part.schedule.accuracy || dynamics::weights(model.scheme).inertia)
    return "";
  bool const flows = std::ranges::any_of(
      model.bodies, [](auto const& body) { return !body->relaxing.empty() || body->damping; });
  bool const rubs =
      std::ranges::any_of(model.pairs, [](auto const& pair) { return pair.law.friction.has_value(); });
  if (!flows && !rubs)
    return "";
  return fmt::format(
      "without inertia `accuracy` sees bonds and events alone, not how {}: give it as `largest` "
      "the step that this needs, or the stages their steps",
      flows && rubs ? "bodies flow and surfaces rub"
      : flows       ? "bodies flow"
                    : "surfaces rub");
}

} // namespace stiction::scene
