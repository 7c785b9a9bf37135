// Names to numbers: bodies and sets of a scene.
#include "scene/build/build.hpp"

#include <fmt/format.h>

#include "dynamics/bulk/bulk_choice.hpp"
#include "dynamics/step/stepper.hpp"
#include "mesh/topology/quality.hpp"
#include "scene/build/builder.hpp"
#include "scene/build/laws.hpp"

namespace stiction::scene {

core::Input const* part_of(core::Input const& input, std::string const& key) {
  auto const bracket = key.find('[');
  auto const* table = input.table();
  if (table == nullptr)
    return nullptr;
  auto const found = table->find(key.substr(0, bracket));
  if (found == table->end() || bracket == std::string::npos)
    return found == table->end() ? nullptr : &found->second;
  auto const* list = found->second.list();
  auto const number = std::stoul(key.substr(bracket + 1));
  return list != nullptr && number >= 1 && number <= list->size() ? &(*list)[number - 1] : nullptr;
}

dynamics::Path path(Numbers const& times, Numbers const& values) {
  if (values.empty())
    return {};
  return {times, values};
}

Scene Builder::run() {
  core::Reader reader(*input_, "", complaints_);
  scene_.part = reader.record<ScenePart>();
  check_model();
  settle();
  if (!scene_.part.half_spaces.empty())
    return with_half_space();
  for (auto const& [name, part] : scene_.part.height_maps)
    complain({"obstacles", name},
             "is pressed onto a half space only; make the body one, stiction.body.half_space, "
             "or give an obstacle a shape");
  scene_.model = std::make_unique<dynamics::Model>();
  auto& model = *scene_.model;
  model.kinematics = scene_.part.kinematics;
  model.gravity = vec(scene_.part.gravity);
  if (model.kinematics == solid::Kinematics::axisymmetric && model.gravity.x() != 0)
    complain({"gravity"}, "along the radius would leave the symmetry of an axisymmetric scene; give {0, y}");
  model.scheme = scene_.part.scheme;
  dynamics::set_duration(model.scheme, scene_.part.schedule.stages.back().until);
  model.solver = scene_.part.solver;
  model.control = scene_.part.control;
  for (auto const& [name, probe] : scene_.part.probes)
    if (auto const* energy = std::get_if<EnergyProbe>(&probe))
      model.audited = model.audited || energy->audit;
    else if (std::holds_alternative<MomentumProbe>(probe))
      model.tallied = true;
  add_bodies();
  settle();
  add_obstacles();
  add_motions();
  hold_axis();
  add_constraints();
  add_loads();
  add_springs();
  add_pairs();
  check_constraints();
  check_probes();
  check_bulk();
  settle();
  dynamics::Stepper stepper(model, dynamics::Purpose::beginning);
  auto const start = stepper.initial();
  check_overlap(start);
  check_supports(stepper.contact(), start);
  settle();
  return std::move(scene_);
}

std::string unfit_for_ranks(Scene const& scene) {
  if (scene.half_space)
    return "a half space is one process's";
  if (scene.part.output.problems_every > 0)
    return "contact problems are to be written (output.problems_every)";
  return dynamics::unfit_for_ranks(*scene.model);
}

/// A problem that is to be written needs its matrix.
void Builder::check_bulk() {
  auto& model = *scene_.model;
  bool const written = scene_.part.output.problems_every > 0;
  auto const why = written ? "contact problems are to be written (output.problems_every)"
                           : dynamics::unfit_for_multigrid(model);
  if (auto const alone = unfit_for_ranks(scene_); ranks_ != nullptr && !alone.empty())
    complain({}, fmt::format("it cannot be shared by several ranks: {}; run it without --ranks", alone));
  if (model.control.bulk == dynamics::BulkSolver::multigrid && !why.empty())
    complain({"control", "bulk"},
             fmt::format("is \"multigrid\", but {}; give \"direct\", or leave it out", why));
  if (written)
    model.control.bulk = dynamics::BulkSolver::direct;
}

void Builder::settle() const {
  if (!complaints_.empty())
    throw core::InputError(complaints_);
}

/// Finds the script line of the table that the path leads to.
void Builder::complain(Where const& where, std::string text) {
  core::Input const* at = input_;
  std::string place = at->place, full;
  for (auto const& key : where) {
    full += (full.empty() ? "" : ".") + key;
    at = at == nullptr ? nullptr : part_of(*at, key);
    if (at != nullptr && !at->place.empty())
      place = at->place;
  }
  complaints_.push_back({place, full, std::move(text)});
}

void Builder::check_size(Where const& where, Numbers const& numbers) {
  auto const dim = static_cast<std::size_t>(scene_.part.dim());
  if (!numbers.empty() && numbers.size() != dim)
    complain(where, fmt::format("has {} numbers; {} are wanted: {}", numbers.size(),
                                dim == 2 ? "two" : "three", dim == 2 ? "{x, y}" : "{x, y, z}"));
}

void Builder::check_no_z(Where const& where, Numbers const& values) {
  if (scene_.part.dim() == 2 && !values.empty())
    complain(where, "a plane scene has no z; leave it out or set kinematics = \"three_dimensional\"");
}

void Builder::check_path_end(Where const& where, Numbers const& times) {
  auto const& stages = scene_.part.schedule.stages;
  if (times.empty() || stages.empty() || times.back() >= stages.back().until * (1 - 1e-9))
    return;
  complain(
      where,
      fmt::format(
          "its path ends at {:g} s, before the run does at {:g} s; give the path a last point at the end",
          times.back(), stages.back().until));
}

void Builder::unknown_name(Where const& where, char const* what, std::string const& name,
                           std::vector<std::string> const& known) {
  auto const meant = core::nearest(name, known);
  complain(where, fmt::format("there is no {} \"{}\"; {}{}", what, name,
                              known.empty() ? "the scene has none"
                                            : fmt::format("known are {}", fmt::join(known, ", ")),
                              meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
}

void Builder::join_sets(std::string const& name, BodyPart const& part, mesh::Mesh& mesh) {
  std::vector<std::string> known;
  for (auto const& [set, members] : mesh.sets)
    known.push_back(set);
  std::map<std::string, mesh::Set> joined;
  for (auto const& [made, names] : part.joined) {
    Where const where{"bodies", name, "joined", made};
    if (mesh.sets.contains(made))
      complain(where, "is a set of the mesh; give what is joined a name of its own");
    if (names.empty())
      complain(where, "joins no sets; name at least one");
    std::vector<mesh::Set const*> sets;
    for (auto const& one : names)
      if (auto const found = mesh.sets.find(one); found != mesh.sets.end())
        sets.push_back(&found->second);
      else
        unknown_name(where, "set", one, known);
    joined.emplace(made, mesh::join(sets));
  }
  mesh.sets.merge(joined);
}

void Builder::make_body(std::string const& name, BodyPart const& part) {
  auto& model = *scene_.model;
  auto body = std::make_unique<solid::Body>(solid::Body{name, mesh::make(part.mesh), part.material,
                                                        part.density, part.interpolation, part.damping});
  if (body->mesh.dim != model.dim())
    throw core::InputError(fmt::format("is a mesh of {} dimensions in a scene of {}; choose another mesh, or "
                                       "kinematics = \"{}\"",
                                       body->mesh.dim, model.dim(),
                                       body->mesh.dim == 3 ? "three_dimensional" : "plane_strain"));
  mesh::check(body->mesh, name);
  if (part.relief)
    take_relief(name, *part.relief, body->mesh);
  join_sets(name, part, body->mesh);
  give_laws(*body, part.laws_by_set);
  body->plane_stress = part.plane_stress;
  body->relaxing = part.relaxing;
  check_radius(name, body->mesh);
  solid::check_interpolation(*body);
  model.first_node.push_back(model.first_node.back() + body->mesh.node_count());
  model.bodies.push_back(std::move(body));
  scene_.bodies.push_back(name);
}

void Builder::check_sheet(std::string const& name, BodyPart const& part) {
  if (!part.plane_stress)
    return;
  if (scene_.part.kinematics != solid::Kinematics::plane_strain)
    complain({"bodies", name, "plane_stress"},
             "is for sheets in their plane; leave it out, or set the scene's kinematics to \"plane_strain\"");
  if (part.interpolation != solid::Interpolation::plain)
    complain({"bodies", name, "interpolation"},
             "a sheet in plane stress does not lock: its thickness makes up for its area; leave it out");
  if (part.damping)
    complain({"bodies", name, "damping"},
             "is not for sheets in plane stress, whose thickness would have a rate of its own; leave one of "
             "the two out");
  if (!part.relaxing.empty())
    complain({"bodies", name, "relaxing"},
             "is not for sheets in plane stress, whose thickness would relax by itself; leave one of the two "
             "out");
}

void Builder::add_bodies() {
  auto& model = *scene_.model;
  model.first_node.push_back(0);
  for (auto const& [name, part] : scene_.part.bodies) {
    check_velocities(name, part);
    check_sheet(name, part);
    if (part.damping && !dynamics::weights(model.scheme).inertia)
      complain({"bodies", name, "damping"},
               "a quasi-static run has no rates; leave it out or use scheme.theta_xi");
    if (part.damping && dynamics::weights(model.scheme).explicit_forces)
      complain(
          {"bodies", name, "damping"},
          "would lower the stability limit of scheme.central_difference and lag by a step; leave it out or "
          "use an implicit scheme");
    if (!part.relaxing.empty() && dynamics::weights(model.scheme).skin)
      complain(
          {"bodies", name, "relaxing"},
          "cannot go with contact_inertia = \"cells\", which takes the stress of cells at contact twice; "
          "leave it out or use contact_inertia = \"implicit\"");
    try {
      make_body(name, part);
    } catch (core::InputError const& error) {
      for (auto const& complaint : error.complaints())
        complain({"bodies", name, complaint.path == "material" ? "material" : "mesh"},
                 complaint.path == "material" ? complaint.text : complaint.message());
    }
  }
  if (scene_.part.bodies.empty())
    complain({"bodies"}, "is empty; a scene needs at least one body");
  settle();
  int const dim = model.dim();
  model.reference.resize(model.first_node.back(), dim);
  model.velocity.resize(model.first_node.back(), dim);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto const count = model.bodies[b]->mesh.node_count();
    model.reference.middleRows(model.first_node[b], count) = model.bodies[b]->mesh.nodes;
  }
  if (ranks_ != nullptr)
    model.share = dynamics::share_out(model.reference, *ranks_);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    model.cells.push_back(dynamics::cells_of(model, b));
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    set_velocities(b);
}

void Builder::check_spin(Where const& where, Numbers const& spin) {
  bool const plane = scene_.part.dim() == 2;
  if (!spin.empty() && spin.size() != (plane ? 1U : 3U))
    complain(where, plane ? "wants one number in the plane" : "wants three numbers in space");
}

void Builder::check_velocities(std::string const& name, BodyPart const& part) {
  check_size({"bodies", name, "velocity"}, part.velocity);
  check_spin({"bodies", name, "spin"}, part.spin);
  auto const wanted = ix(scene_.part.dim() * scene_.part.dim());
  auto const given = part.velocity_gradient.size();
  if (given != 0 && given != wanted)
    complain({"bodies", name, "velocity_gradient"},
             fmt::format("has {} numbers; {} are wanted", given, wanted));
  if (scene_.part.kinematics == solid::Kinematics::axisymmetric)
    for (auto const& [key, numbers] :
         {std::pair{"spin", &part.spin}, {"velocity_gradient", &part.velocity_gradient}})
      if (!numbers->empty())
        complain({"bodies", name, key}, "would leave the symmetry of an axisymmetric scene; leave it out");
}

/// A rigid motion and a uniform rate of deformation about the centre of mass.
void Builder::set_velocities(std::size_t b) {
  auto& model = *scene_.model;
  auto const& part = scene_.part.bodies.at(scene_.bodies[b]);
  int const dim = model.dim();
  auto own = model.velocity.middleRows(model.first_node[b], model.bodies[b]->mesh.node_count());
  own.rowwise() = vec(part.velocity).head(dim).transpose();
  if (part.spin.empty() && part.velocity_gradient.empty())
    return;
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < part.velocity_gradient.size(); ++k)
    L(static_cast<int>(k) / dim, static_cast<int>(k) % dim) = part.velocity_gradient[k];
  Vec3 const spin = spin_of(part.spin);
  for (int c = 0; c < 3; ++c)
    L.col(c) += spin.cross(Vec3::Unit(c));
  auto const& body = *model.bodies[b];
  Vec3 const centre = solid::mass_centre(body, solid::Cells(body, model.kinematics)).centre;
  own += (body.mesh.nodes.rowwise() - centre.head(dim).transpose()) * L.topLeftCorner(dim, dim).transpose();
}

void Builder::check_radius(std::string const& name, mesh::Mesh const& mesh) {
  if (scene_.part.kinematics == solid::Kinematics::axisymmetric && mesh.nodes.col(0).minCoeff() < 0)
    complain({"bodies", name, "mesh"},
             fmt::format("reaches the radius {:g} m; axisymmetric bodies lie at x >= 0",
                         mesh.nodes.col(0).minCoeff()));
}

/// Nodes of "body.set", or a complaint naming what there is.
std::optional<Indices> Builder::resolve(Where const& where, std::string const& name) {
  if (auto nodes = scene_.nodes_of(name))
    return nodes;
  std::vector<std::string> known;
  for (auto const& body : scene_.model->bodies)
    for (auto const& [set, members] : body->mesh.sets)
      known.push_back(body->name + "." + set);
  if (scene_.part.obstacles.contains(name) || std::ranges::find(scene_.bodies, name) != scene_.bodies.end()) {
    complain(where, fmt::format("\"{}\" is {}, not a set; known are {}", name,
                                scene_.part.obstacles.contains(name) ? "an obstacle" : "a whole body",
                                fmt::join(known, ", ")));
    return {};
  }
  bool const primary = where.back() == "primary" || where.back() == "from" || where.back() == "to";
  for (auto const& [obstacle, part] : scene_.part.obstacles)
    if (primary)
      known.push_back(obstacle);
  unknown_name(where, primary ? "obstacle or set" : "set", name, known);
  return {};
}

std::optional<Indices> Scene::nodes_of(std::string const& name) const {
  auto const dot = name.find('.');
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (dot == std::string::npos || bodies[b] != name.substr(0, dot))
      continue;
    auto const& sets = model->bodies[b]->mesh.sets;
    auto const found = sets.find(name.substr(dot + 1));
    if (found == sets.end())
      return {};
    Indices nodes = found->second.nodes;
    for (auto& node : nodes)
      node += model->first_node[b];
    return nodes;
  }
  return {};
}

Index Scene::pair_index(std::string const& name) const {
  for (std::size_t p = 0; p < pairs.size(); ++p)
    if (pairs[p] == name)
      return static_cast<Index>(p);
  return -1;
}

Index Scene::nearest(Indices const& nodes, Numbers const& point) const {
  Index best = nodes.front();
  auto distance = [&](Index node) {
    return (model->reference.row(node).transpose() - vec(point).head(model->dim())).squaredNorm();
  };
  for (Index const node : nodes)
    if (distance(node) < distance(best))
      best = node;
  return best;
}

Scene build(core::Input const& input, linear::Ranks const* ranks) {
  return Builder(input, ranks).run();
}

} // namespace stiction::scene
