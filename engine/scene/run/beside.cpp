// Steps beside a case's own.
#include "scene/run/beside.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "record/file.hpp"

namespace stiction::scene {

namespace {

constexpr long trusted = 8;     ///< steps of which one is looked at
constexpr double rough = 1e-9;  ///< out of balance, of forces, that derivatives feel in their fourth digit
constexpr double sharp = 1e-12; ///< tolerance of contact's solver: shifts are 1e-5 of parameters

/// Why a scene can have no run beside it, in words; "" if it can.
std::string unfit(Scene const& scene) {
  if (scene.formula)
    return "";
  if (scene.half_space)
    return "they are for bodies of cells and for formulas; half spaces have differences";
  if (dynamics::weights(scene.model->scheme).explicit_forces)
    return "an explicit scheme has no factor to correct with";
  if (scene.part.schedule.accuracy)
    return "steps follow from their error (schedule.accuracy); give the stages their steps";
  if (scene.model->share)
    return "several ranks share the case";
  if (std::ranges::any_of(scene.part.bodies, [](auto const& one) { return one.second.remesh.has_value(); }))
    return "meshes follow from their error (mesh.gmsh.remesh)";
  return "";
}

bool same_motions(dynamics::Model const& one, dynamics::Model const& other) {
  return std::ranges::equal(one.motions, other.motions, [](auto const& a, auto const& b) {
    return a.component == b.component && a.nodes == b.nodes;
  });
}

bool same_schedule(SchedulePart const& one, SchedulePart const& other) {
  return std::ranges::equal(one.stages, other.stages, [](auto const& a, auto const& b) {
    return a.until == b.until && a.steps == b.steps;
  });
}

std::string difference_of_formulas(Scene const& one, Scene const& other) {
  if (!one.formula || !other.formula || one.formula->normal->name() != other.formula->normal->name() ||
      one.formula->drive != other.formula->drive)
    return "it changes the formula";
  return same_schedule(one.part.schedule, other.part.schedule) ? "" : "it changes the schedule's times";
}

/// In what but numbers two scenes differ, in words; "" if in nothing.
std::string difference(Scene const& one, Scene const& other) {
  auto const why = unfit(other);
  if (!why.empty())
    return why;
  if (one.formula || other.formula)
    return difference_of_formulas(one, other);
  auto const &a = *one.model, &b = *other.model;
  auto const points = [](auto const& p, auto const& q) { return p.size() == q.size(); };
  if (a.dofs() != b.dofs() || a.kinematics != b.kinematics || a.cells.size() != b.cells.size() ||
      a.links.size() != b.links.size())
    return "it changes the mesh";
  if (!same_motions(a, b))
    return "it changes what is driven";
  if (!same_schedule(one.part.schedule, other.part.schedule))
    return "it changes the schedule's times";
  if (a.scheme.index() != b.scheme.index())
    return "it changes the time scheme";
  if (!std::ranges::equal(a.pairs, b.pairs, points) ||
      dynamics::contact_components(a) != dynamics::contact_components(b))
    return "it changes the contact pairs";
  return "";
}

[[noreturn]] void refuse(Shifted const& asked, std::string const& why) {
  throw core::InputError(fmt::format("no derivatives with respect to {}: {}", asked.name, why));
}

void sharpen(Scene& scene) {
  if (!scene.model)
    return;
  std::visit([](auto& settings) { settings.tolerance = std::min(settings.tolerance, sharp); },
             scene.model->solver);
}

Scene built(Shifted const& shifted) {
  try {
    return build(shifted.scene);
  } catch (core::InputError const& error) {
    refuse(shifted, fmt::format("with it a little smaller there is no scene: {}", error.what()));
  }
}

/// Points that stick, slip or are open in the one state and not in the other.
long turned(dynamics::State const& one, dynamics::State const& other) {
  long count = 0;
  for (std::size_t pair = 0; pair < one.contacts.size(); ++pair)
    for (std::size_t i = 0; i < one.contacts[pair].size(); ++i)
      count += one.contacts[pair][i].status != other.contacts[pair][i].status ? 1 : 0;
  return count;
}

} // namespace

Scene scene_beside(Shifted const& shifted, Scene const& scene) {
  auto other = built(shifted);
  if (auto const why = difference(scene, other); !why.empty())
    refuse(shifted, why);
  sharpen(other);
  return other;
}

void ready_for(std::vector<Shifted> const& asked, Scene& scene) {
  if (asked.empty())
    return;
  if (auto const why = unfit(scene); !why.empty())
    refuse(asked.front(), why);
  sharpen(scene);
}

void check_beside(core::Input const& input, std::vector<Shifted> const& asked) {
  auto scene = build(input);
  ready_for(asked, scene);
  for (auto const& shifted : asked)
    static_cast<void>(scene_beside(shifted, scene));
}

void remove_runs_beside(std::filesystem::path const& folder) {
  std::error_code ignored; // what cannot be removed is overwritten or reported when written
  std::filesystem::remove_all(folder / "derivatives", ignored);
}

Beside::Beside(Shifted const& shifted, Scene const& scene, dynamics::Stepper const& lead)
    : scene_(scene_beside(shifted, scene)), stepper_(*scene_.model, lead), state_(stepper_.initial()) {
  result_.name = shifted.name;
}

void Beside::begin_files(std::filesystem::path const& folder, bool anew) {
  auto const own = folder / "derivatives" / result_.name;
  record::prepare_output(own);
  recorder_.emplace(scene_, own, anew ? nullptr : &mark_);
  if (anew)
    recorder_->step(state_, 0, 0);
}

/// Is what one correction leaves looked at in the next step?
bool Beside::looks() const {
  return result_.steps % trusted == 0;
}

void Beside::follow(std::span<std::unique_ptr<Beside> const> all, dynamics::Stepper& lead,
                    dynamics::Outcome const& made, double dt) {
  std::vector<Beside*> going;
  std::vector<dynamics::Follower> followers;
  for (auto const& one : all)
    if (one->result_.ended.empty()) {
      going.push_back(one.get());
      followers.push_back({&one->stepper_, &one->state_, !one->looks() && !one->careful_});
    }
  auto outcomes = lead.take_along(followers, dt);
  for (std::size_t k = 0; k < going.size(); ++k)
    going[k]->take(std::move(outcomes[k]), made, dt);
}

void Beside::take(dynamics::Outcome outcome, dynamics::Outcome const& made, double dt) {
  careful_ = looks() ? outcome.iterations > 1 : careful_;
  result_.iterations += outcome.iterations;
  if (!outcome.converged()) {
    result_.ended = fmt::format("at t = {:g} s its step did not follow: {}", made.state.t, outcome.reason);
    return;
  }
  state_ = std::move(outcome.state);
  state_.t = made.state.t;
  ++result_.steps;
  result_.rough += made.out_of_balance > rough ? 1 : 0;
  result_.turned += turned(state_, made.state) > 0 ? 1 : 0;
  recorder_->step(state_, dt, outcome.iterations);
}

void Beside::close() {
  recorder_->close();
}

} // namespace stiction::scene
