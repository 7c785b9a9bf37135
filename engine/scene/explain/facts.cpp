// Facts of bodies and of the run.
#include "scene/explain/facts.hpp"

#include <fmt/format.h>

#include "scene/description/human.hpp"

namespace stiction::scene {

namespace {

void count_unknowns(dynamics::Model const& model, std::size_t b, BodyFacts& facts) {
  Index const first = model.first_node[b], end = model.first_node[b + 1];
  int const dim = model.dim();
  std::vector<bool> driven(ix(dim * (end - first)), false);
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      if (node >= first && node < end) {
        driven[ix(dim * (node - first) + motion.component)] = true;
        facts.held[ix(motion.component)] = true;
      }
  facts.driven = static_cast<Index>(std::count(driven.begin(), driven.end(), true));
  facts.free = static_cast<Index>(driven.size()) - facts.driven;
}

/// Of the cells' corners, m.
double smallest_edge(mesh::Mesh const& mesh) {
  double least = std::numeric_limits<double>::infinity();
  for (auto const& block : mesh.blocks) {
    auto const& cell = mesh::info(block.kind);
    for (std::size_t first = 0; first < block.nodes.size(); first += ix(cell.nodes))
      for (auto const& [a, b] : cell.edges)
        least = std::min(
            least, (mesh.nodes.row(block.nodes[first + ix(a)]) - mesh.nodes.row(block.nodes[first + ix(b)]))
                       .squaredNorm());
  }
  return std::sqrt(least);
}

BodyFacts body_facts(Scene const& scene, std::size_t b) {
  auto const& model = *scene.model;
  auto const& body = *model.bodies[b];
  BodyFacts facts;
  facts.body = &body;
  facts.moduli = material::moduli(body.material);
  auto const [mass, centre] = solid::mass_centre(body, model.cells[b]);
  facts.mass = mass;
  facts.centre = centre;
  facts.sides.head(model.dim()) =
      (body.mesh.nodes.colwise().maxCoeff() - body.mesh.nodes.colwise().minCoeff()).transpose();
  facts.smallest_edge = smallest_edge(body.mesh);
  facts.start_speed =
      model.velocity.middleRows(model.first_node[b], body.mesh.node_count()).rowwise().norm().maxCoeff();
  count_unknowns(model, b, facts);
  for (auto const& motion : scene.part.motions)
    if (auto const& set = set_of(motion);
        !std::holds_alternative<FixPart>(motion) && set.substr(0, set.find('.')) == body.name)
      facts.driven_set = set;
  return facts;
}

void add_schedule(Facts& facts) {
  double start = 0;
  for (auto const& stage : facts.scene->part.schedule.stages) {
    double const dt = (stage.until - start) / stage.steps;
    facts.shortest_step = facts.steps == 0 ? dt : std::min(facts.shortest_step, dt);
    facts.longest_step = std::max(facts.longest_step, dt);
    auto const& accuracy = facts.scene->part.schedule.accuracy;
    double const grown = !accuracy || facts.dynamic() ? dt
                         : accuracy->largest > 0      ? accuracy->largest
                                                      : dynamics::most_growth * dt;
    facts.unseen_step = std::max(facts.unseen_step, std::min(grown, stage.until - start));
    facts.steps += stage.steps;
    start = stage.until;
  }
  facts.end = start;
}

/// Of single components: what moves along two axes at once is faster by up to sqrt(3).
double fastest(dynamics::Model const& model) {
  double speed = model.velocity.size() > 0 ? model.velocity.rowwise().norm().maxCoeff() : 0;
  for (auto const& motion : model.motions)
    speed = std::max(speed, motion.fastest());
  for (auto const& rigid : model.rigids)
    for (auto const& path : rigid.shift)
      speed = std::max(speed, path.fastest());
  for (auto const& spring : model.springs)
    for (auto const& path : spring.to.shift)
      speed = std::max(speed, path.fastest());
  return speed;
}

} // namespace

void add(Section& section, std::string name, std::string words) {
  section.lines.push_back(
      {std::move(name), std::move(words), std::numeric_limits<double>::quiet_NaN(), "", ""});
}

Facts facts_of(Scene const& scene, dynamics::State const& start) {
  Facts facts;
  facts.scene = &scene;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    facts.bodies.push_back(body_facts(scene, b));
  add_schedule(facts);
  facts.speed = fastest(*scene.model);
  facts.components = dynamics::contact_components(*scene.model);
  for (std::size_t p = 0; p < scene.pairs.size(); ++p)
    facts.pairs.push_back(pair_facts(facts, p, start));
  return facts;
}

BodyFacts const& body_of(Facts const& all, std::string const& set) {
  std::size_t b = 0;
  while (all.bodies[b].body->name != set.substr(0, set.find('.')))
    ++b;
  return all.bodies[b];
}

std::string law_of_large_strains(BodyFacts const& facts) {
  return fmt::format("material.neo_hookean{{young = {}, poisson = {:.3g}}}", human(facts.moduli.young, "Pa"),
                     facts.moduli.poisson);
}

} // namespace stiction::scene
