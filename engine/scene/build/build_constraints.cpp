// Constraints of a scene: sums of displacement components that stay 0, solved for one component each.
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

#include "dynamics/bulk/bulk_system.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

constexpr double rounded = 1e-12;      ///< of the largest coefficient, and of the largest displacement
constexpr double alike = 1e-6;         ///< of a side's size: how far a partner may lie from its place
constexpr double same_speed = 1e-9;    ///< of the largest speed at the start
constexpr double on_the_way = 0.38197; ///< part of the way between two knots: turns are looked at there too

Vec3 place_of(dynamics::Model const& model, Index node) {
  Vec3 X = Vec3::Zero();
  X.head(model.dim()) = model.reference.row(node).transpose();
  return X;
}

/// Do these motions keep the sum at 0?
bool kept(std::vector<std::pair<dynamics::Motion const*, double>> const& terms) {
  std::set<double> times{0};
  double largest = 0;
  for (auto const& [motion, factor] : terms) {
    times.insert(motion->path.times.begin(), motion->path.times.end());
    if (motion->turn)
      times.insert(motion->turn->angle->times.begin(), motion->turn->angle->times.end());
    largest = std::max(largest, std::abs(factor) * motion->farthest());
  }
  std::set<double> all = times;
  for (auto at = times.begin(); std::next(at) != times.end(); ++at)
    all.insert(*at + on_the_way * (*std::next(at) - *at));
  return std::ranges::all_of(all, [&](double t) {
    double sum = 0;
    for (auto const& [motion, factor] : terms)
      sum += factor * motion->value(t);
    return std::abs(sum) <= rounded * largest;
  });
}

/// A master of the link that follows others now gives way to these.
void replace(dynamics::Link& link, dynamics::Link const& follower) {
  using Term = std::pair<Index, double>;
  auto const found = std::ranges::find(link.masters, follower.dof, &Term::first);
  if (found == link.masters.end())
    return;
  double const weight = found->second;
  link.masters.erase(found);
  for (auto const& [dof, factor] : follower.masters)
    if (auto const there = std::ranges::find(link.masters, dof, &Term::first); there != link.masters.end())
      there->second += weight * factor;
    else
      link.masters.emplace_back(dof, weight * factor);
}

} // namespace

Vec3 middle_of(dynamics::Model const& model, Indices const& nodes) {
  Vec3 sum = Vec3::Zero();
  for (Index const node : nodes)
    sum.head(model.dim()) += model.reference.row(node).transpose();
  return sum / static_cast<double>(nodes.size());
}

std::string words(Vec3 const& X, int dim) {
  return fmt::format("({:g}) m", fmt::join(X.data(), X.data() + dim, ", "));
}

void Builder::add_constraints() {
  auto const& constraints = scene_.part.constraints;
  auto const& model = *scene_.model;
  if (constraints.empty())
    return;
  driven_.assign(ix(model.dofs()), nullptr);
  link_of_.assign(driven_.size(), -1);
  leads_.assign(driven_.size(), false);
  scene_.moved.assign(constraints.size(), 0.0);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driven_[ix(model.dim() * node + motion.component)] = &motion;
  for (bool const ties : {false, true}) // which leave to others what these have
    for (std::size_t k = 0; k < constraints.size(); ++k) {
      if (std::holds_alternative<TiedPart>(constraints[k]) != ties)
        continue;
      Where const where{fmt::format("constraints[{}]", k + 1)};
      std::visit([&](auto const& part) { add_constraint(where, part); }, constraints[k]);
      linked_by_.resize(model.links.size(), k + 1);
    }
}

void Builder::add_constraint(Where const& where, RollerPart const& part) {
  auto const nodes = resolve({where[0], "set"}, part.set);
  auto const dim = static_cast<std::size_t>(scene_.part.dim());
  if (part.normal.size() != dim || vec(part.normal).isZero(0)) {
    complain({where[0], "normal"}, fmt::format("is no direction; give {} numbers that are not all 0", dim));
    return;
  }
  Vec3 const normal = vec(part.normal).normalized();
  for (Index const node : nodes.value_or(Indices{})) {
    Terms terms;
    for (int c = 0; c < scene_.part.dim(); ++c)
      terms.emplace_back(scene_.part.dim() * node + c, normal[c]);
    constrain(where, terms);
  }
}

void Builder::add_constraint(Where const& where, PeriodicPart const& part) {
  auto const own = resolve({where[0], "set"}, part.set), other = resolve({where[0], "to"}, part.to);
  if (!own || !other)
    return;
  auto const& model = *scene_.model;
  int const dim = model.dim();
  if (*own == *other)
    return complain({where[0], "to"}, fmt::format("is {} itself; name the opposite side", part.set));
  if (own->size() != other->size()) {
    complain({where[0], "to"}, fmt::format("has {} nodes, and {} has {}; give both sides the same division",
                                           other->size(), part.set, own->size()));
    return;
  }
  Vec3 const shift = middle_of(model, *other) - middle_of(model, *own);
  if (model.kinematics == solid::Kinematics::axisymmetric && std::abs(shift[0]) > alike * shift.norm()) {
    complain({where[0], "to"}, "is shifted along the radius; only sides along the axis can be alike");
    return;
  }
  for (Index const node : *own) {
    Vec3 const wanted = place_of(model, node) + shift;
    auto const off = [&](Index one) { return (place_of(model, one) - wanted).norm(); };
    Index const partner = *std::ranges::min_element(*other, {}, off);
    if (partner == node || off(partner) > alike * shift.norm()) {
      complain(
          {where[0], "to"},
          fmt::format("has no node at {}, where the one of {} at {} is after the shift by {}; the nearest "
                      "is {:.3g} m off; give both sides the same division",
                      words(wanted, dim), part.set, words(place_of(model, node), dim), words(shift, dim),
                      off(partner)));
      return;
    }
    for (int c = 0; c < dim; ++c)
      constrain(where, {{dim * node + c, 1.0}, {dim * partner + c, -1.0}});
  }
}

/// Terms with followers replaced by their masters.
std::map<Index, double> Builder::settled(Terms const& terms) const {
  std::map<Index, double> sum;
  for (auto const& [dof, factor] : terms)
    if (Index const link = link_of_[ix(dof)]; link < 0)
      sum[dof] += factor;
    else
      for (auto const& [master, weight] : scene_.model->links[ix(link)].masters)
        sum[master] += factor * weight;
  std::erase_if(sum, [](auto const& term) { return std::abs(term.second) < rounded; });
  return sum;
}

/// The component with the largest coefficient that no motion drives follows.
void Builder::constrain(Where const& where, Terms const& terms) {
  auto const sum = settled(terms);
  auto const free_size = [&](auto const& term) {
    return driven_[ix(term.first)] == nullptr ? std::abs(term.second) : 0.0;
  };
  auto const follower = std::ranges::max_element(sum, {}, free_size);
  if (follower == sum.end())
    return;
  if (free_size(*follower) == 0) {
    std::vector<std::pair<dynamics::Motion const*, double>> held;
    held.reserve(sum.size());
    for (auto const& [dof, factor] : sum)
      held.emplace_back(driven_[ix(dof)], factor);
    if (!kept(held))
      complain(where, fmt::format("holds the node at {} as motions do not let it be: {} moves it otherwise; "
                                  "take it out of one of the two",
                                  words(place_of(*scene_.model, sum.begin()->first / scene_.part.dim()),
                                        scene_.part.dim()),
                                  held.front().first->set));
    return;
  }
  follow(follower->first, sum);
}

/// What keeps the sum at 0 from now on, in the links that there are already too.
void Builder::follow(Index follower, std::map<Index, double> const& sum) {
  auto& links = scene_.model->links;
  double const own = sum.at(follower);
  dynamics::Link made{follower, {}};
  for (auto const& [dof, factor] : sum)
    if (double const weight = -factor / own; dof != follower)
      made.masters.emplace_back(dof, std::abs(weight - 1) < rounded ? 1 : weight);
  for (std::size_t k = 0; leads_[ix(made.dof)] && k < links.size(); ++k)
    replace(links[k], made);
  link_of_[ix(made.dof)] = static_cast<Index>(links.size());
  for (auto const& [dof, factor] : made.masters)
    leads_[ix(dof)] = true;
  links.push_back(std::move(made));
}

/// Accelerations at rest and the skin of cells know nothing of followers, nor does a contact point that moves
/// obliquely; and what follows a contact node has to be one too, as these may have a balance of their own.
void Builder::check_constraints() {
  auto const& model = *scene_.model;
  auto const weights = dynamics::weights(model.scheme);
  if (model.links.empty())
    return;
  if (weights.explicit_forces || weights.accelerations() || weights.skin)
    complain({"constraints[1]"},
             "holds nodes together, which schemes that keep accelerations, are explicit or "
             "have contact_inertia = \"cells\" cannot; use scheme.quasi_static, "
             "scheme.theta_xi or scheme.moreau_jean");
  if (weights.inertia)
    check_start_velocities();
  auto const touching = dynamics::contact_nodes(model);
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    auto const& [dof, masters] = model.links[k];
    auto const touches = [&](Index one) { return touching[ix(one / model.dim())]; };
    bool const as_one = masters.size() == 1 && masters[0].second == 1;
    bool const any =
        touches(dof) || std::ranges::any_of(masters, [&](auto const& m) { return touches(m.first); });
    if (!any || masters.empty() || (as_one && touches(dof) == touches(masters[0].first)))
      continue;
    complain({fmt::format("constraints[{}]", linked_by_[k])},
             fmt::format("guides the node at {} obliquely or by nodes off the surface, and contact is at it; "
                         "take it out of one of the two",
                         words(place_of(model, dof / model.dim()), model.dim())));
    return;
  }
}

/// What follows would be put right in the first step, and energy be made of nothing.
void Builder::check_start_velocities() {
  auto const& model = *scene_.model;
  int const dim = model.dim();
  auto const velocity = [&](Index dof) { return model.velocity(dof / dim, dof % dim); };
  for (std::size_t k = 0; k < model.links.size(); ++k) {
    auto const& [dof, masters] = model.links[k];
    double off = velocity(dof);
    for (auto const& [master, weight] : masters)
      off -= weight * velocity(master);
    bool const driven =
        std::ranges::any_of(masters, [&](auto const& m) { return driven_[ix(m.first)] != nullptr; });
    if (driven || std::abs(off) <= same_speed * model.velocity.cwiseAbs().maxCoeff())
      continue;
    complain(
        {fmt::format("constraints[{}]", linked_by_[k])},
        fmt::format("guides the node at {}, which at the start moves by {:.3g} m/s along {} against that; "
                    "give the bodies velocities that agree there",
                    words(place_of(model, dof / dim), dim), off, "xyz"[dof % dim]));
    return;
  }
}

} // namespace stiction::scene
