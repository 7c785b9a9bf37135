// The list of everything scripts can make: a new kind in a list below, or in a variant it names, is all it
// takes.
#include "scene/description/catalog.hpp"

#include "scene/description/parts.hpp"

namespace stiction::scene {

namespace {

template<class... T> std::vector<core::Schema> schemas_of(std::type_identity<std::variant<T...>>) {
  return {T::schema()...};
}
template<class Choice> std::vector<core::Schema> schemas() {
  return schemas_of(std::type_identity<Choice>{});
}

} // namespace

std::vector<Category> const& catalog() {
  static std::vector<Category> const made = {
      {"scene", "everything a run needs", {ScenePart::schema()}},
      {"body", "a deformable body", {BodyPart::schema(), HalfSpacePart::schema()}},
      {"mesh", "where a body's mesh comes from", mesh::generator_schemas()},
      {"edge", "an edge of an outline for gmsh", {mesh::Edge::schema()}},
      {"outline", "a hole in a region for gmsh", {mesh::Outline::schema()}},
      {"refinement", "smaller cells for gmsh", {mesh::Refinement::schema()}},
      {"material", "bulk laws", schemas<material::Material>()},
      {"remesh", "a mesh made anew until it is fine enough", {RemeshPart::schema()}},
      {"relief", "heights of a body's boundary", {ReliefPart::schema()}},
      {"damping", "viscosity beside the bulk law", {material::KelvinVoigt::schema()}},
      {"prony", "a term of relaxation beside the bulk law", {material::PronyTerm::schema()}},
      {"obstacle", "a rigid obstacle on its path", {ObstaclePart::schema(), HeightMapPart::schema()}},
      {"rigid", "shapes of rigid obstacles", schemas<contact::Obstacle>()},
      {"surface", "heights of what is pressed onto a half space, of rigid height maps and of reliefs",
       schemas<halfspace::Shape>()},
      {"pair", "two surfaces that may touch", {PairPart::schema()}},
      {"friction", "friction laws", schemas<interface::FrictionLaw>()},
      {"adhesion", "adhesion laws", schemas<interface::AdhesionLaw>()},
      {"motion", "prescribed displacements", schemas<MotionPart>()},
      {"constraint", "displacements that follow others", schemas<ConstraintPart>()},
      {"load", "prescribed forces", schemas<LoadPart>()},
      {"spring", "springs and dashpots", {SpringPart::schema()}},
      {"schedule", "stages of the run", {SchedulePart::schema()}},
      {"stage", "a stretch with equal steps", {StagePart::schema()}},
      {"accuracy", "steps chosen from their error", {dynamics::Accuracy::schema()}},
      {"scheme", "time schemes", schemas<dynamics::Scheme>()},
      {"solver", "contact solvers", schemas<contact::SolverChoice>()},
      {"control", "convergence of a step", {dynamics::StepControl::schema()}},
      {"probe", "histories to record", schemas<ProbePart>()},
      {"output", "fields and problems to write", {OutputPart::schema()}},
  };
  return made;
}

} // namespace stiction::scene
