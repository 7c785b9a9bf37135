// The columns of a momentum probe: momenta of bodies, impulses of contacts, loads and motions.
#include "scene/probes/probes.hpp"

namespace stiction::scene {

using contact::Vec3;
using dynamics::Screw;
using dynamics::State;

namespace {

/// Which components of momentum and angular momentum a scene has.
struct Components {
  solid::Kinematics kinematics;
  std::vector<int> linear, angular;
};

Components components(solid::Kinematics kinematics) {
  switch (kinematics) {
  case solid::Kinematics::axisymmetric:
    return {kinematics, {1}, {}};
  case solid::Kinematics::plane_strain:
    return {kinematics, {0, 1}, {2}};
  case solid::Kinematics::three_dimensional:
    break;
  }
  return {kinematics, {0, 1, 2}, {0, 1, 2}};
}

/// Writes columns and values of one screw after the other, in the same order.
class Writer {
public:
  Writer(Scene const& scene, Columns const& series, std::string const& group)
      : which_(components(scene.part.kinematics)), series_(&series), group_(group) {}

  void columns(std::string const& linear, std::string const& angular, std::string const& meaning) const {
    bool const plane = which_.kinematics == solid::Kinematics::plane_strain;
    for (int const c : which_.linear)
      series_->add(group_, linear + '_' + "xyz"[c], plane ? "N s/m" : "N s", meaning, 1);
    for (int const c : which_.angular)
      series_->add(group_, plane ? angular : angular + '_' + "xyz"[c], plane ? "N s" : "N m s",
                   meaning + ": about the given point", 1);
  }

private:
  Components which_;
  Columns const* series_;
  std::string group_;
};

void put(Screw const& s, Vec3 const& about, Components const& which, std::vector<double>& row) {
  Vec3 const angular = s.about(about);
  for (int const c : which.linear)
    row.push_back(s.linear[c]);
  for (int const c : which.angular)
    row.push_back(angular[c]);
}

/// A body or a free obstacle by its name, and its index among the momenta.
using Named = std::pair<std::string, std::size_t>;

std::vector<Named> movers(Scene const& scene) {
  std::vector<Named> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    all.emplace_back(scene.bodies[b], b);
  for (std::size_t r = 0; r < scene.model->rigids.size(); ++r)
    if (scene.model->rigids[r].free())
      all.emplace_back(scene.model->rigids[r].name, scene.bodies.size() + r);
  return all;
}

/// Does the primary side of the pair move by its own momentum?
bool moves(dynamics::Model const& model, dynamics::Pair const& pair) {
  auto const* side = std::get_if<dynamics::RigidSide>(&pair.primary);
  return side == nullptr || model.rigids[side->body].free();
}

void add_columns(Scene const& scene, Writer const& writer) {
  for (auto const& [name, index] : movers(scene))
    writer.columns(name + "_p", name + "_l", "momentum of " + name);
  writer.columns("p", "l", "momentum of all");
  for (std::size_t p = 0; p < scene.pairs.size(); ++p) {
    auto const& name = scene.pairs[p];
    writer.columns(name + "_impulse", name + "_angular_impulse",
                   "impulse of " + name + " on its secondary side");
    if (moves(*scene.model, scene.model->pairs[p]))
      writer.columns(name + "_sum", name + "_angular_sum", "impulses of " + name + " on both sides together");
  }
  writer.columns("load_impulse", "load_angular_impulse", "impulse of loads and weight");
  writer.columns("motion_impulse", "motion_angular_impulse", "impulse of motions");
  if (!scene.model->springs.empty())
    writer.columns("spring_impulse", "spring_angular_impulse", "impulse of springs");
  writer.columns("unaccounted_p", "unaccounted_l", "change of all momentum less all impulses");
}

Screw all_of(dynamics::Momenta const& momenta) {
  Screw sum;
  for (auto const& body : momenta.bodies)
    sum += body;
  return sum;
}

Screw both_sides(dynamics::PairScrew const& pair) {
  Screw sum = pair.secondary;
  sum += pair.primary;
  return sum;
}

/// All impulses on what moves.
Screw impulses(dynamics::Momenta const& momenta) {
  Screw sum = momenta.loads;
  sum += momenta.motions;
  sum += momenta.springs;
  for (auto const& pair : momenta.pairs)
    sum += both_sides(pair);
  return sum;
}

} // namespace

Sampler add_momentum(MomentumProbe const& probe, Scene const& scene, Columns const& series,
                     std::string const& name) {
  add_columns(scene, Writer(scene, series, name));
  Vec3 about = Vec3::Zero();
  for (std::size_t c = 0; c < probe.about.size(); ++c)
    about[static_cast<Eigen::Index>(c)] = probe.about[c];
  return [which = components(scene.part.kinematics), movers = movers(scene), about,
          &model = *scene.model](State const& state, std::vector<double>& row) {
    auto const& momenta = state.momenta;
    for (auto const& [body, index] : movers)
      put(momenta.bodies[index], about, which, row);
    Screw const all = all_of(momenta);
    put(all, about, which, row);
    for (std::size_t p = 0; p < momenta.pairs.size(); ++p) {
      put(momenta.pairs[p].secondary, about, which, row);
      if (moves(model, model.pairs[p]))
        put(both_sides(momenta.pairs[p]), about, which, row);
    }
    put(momenta.loads, about, which, row);
    put(momenta.motions, about, which, row);
    if (!model.springs.empty())
      put(momenta.springs, about, which, row);
    Screw rest = all;
    rest += -1 * momenta.start;
    rest += -1 * impulses(momenta);
    put(rest, about, which, row);
  };
}

} // namespace stiction::scene
