// The parts of an explanation in their order.
#include "scene/explain/explain.hpp"

#include "scene/explain/explain_half_space.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

Explanation explain(Scene const& scene) {
  if (scene.half_space)
    return explain_half_space(scene);
  dynamics::Stepper stepper(*scene.model, dynamics::Purpose::beginning);
  auto const start = stepper.initial();
  auto const facts = facts_of(scene, start);
  Explanation explanation;
  describe_scene(facts, explanation);
  bool const cheap = describe_cost(facts, start, stepper.bulk(), explanation);
  describe_numbers(facts, explanation);
  add_warnings(facts, explanation);
  if (cheap) // it factors at rest
    add_advice(facts, explanation);
  return explanation;
}

Explanation explain(core::Input const& input) {
  return explain(build(input));
}

} // namespace stiction::scene
