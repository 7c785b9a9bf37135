// The parts of an explanation in their order.
#include "scene/explain/explain.hpp"

#include "scene/explain/facts.hpp"

namespace stiction::scene {

Explanation explain(Scene const& scene) {
  dynamics::Stepper stepper(*scene.model);
  auto const facts = facts_of(scene, stepper.initial());
  Explanation explanation;
  describe_scene(facts, explanation);
  describe_cost(facts, stepper.bulk(), explanation);
  describe_numbers(facts, explanation);
  add_warnings(facts, explanation);
  add_advice(facts, explanation);
  return explanation;
}

Explanation explain(core::Input const& input) {
  return explain(build(input));
}

} // namespace stiction::scene
