// A closed formula in place of a half space's points, and scenes whose bodies have to be of a kind.
#include <fmt/format.h>

#include "scene/build/builder.hpp"

namespace stiction::scene {

/// Are the bodies of the kind that `model` names?
void Builder::check_model() {
  auto const& part = scene_.part;
  bool const points = !part.half_spaces.empty();
  refuse({"model"}, part.model == ModelKind::formula && !points,
         "is \"formula\", which a half space under a height map may have; make the body "
         "stiction.body.half_space, or leave `model` out");
  refuse(
      {"model"}, part.model == ModelKind::half_space && !points,
      "is \"half_space\", and no body is one; make the body stiction.body.half_space, or leave `model` out");
  refuse(
      {"model"},
      part.model == ModelKind::section && (points || part.kinematics != solid::Kinematics::axisymmetric),
      "is \"section\", which bodies with cells under kinematics = \"axisymmetric\" are; leave `model` out, "
      "or give such");
  refuse({"model"},
         part.model == ModelKind::space &&
             (points || part.kinematics != solid::Kinematics::three_dimensional),
         "is \"space\", which bodies with cells under kinematics = \"three_dimensional\" are; leave `model` "
         "out, or give such");
}

void Builder::take_formula() {
  settle();
  auto const& part = scene_.part;
  auto choice = choose_formula(*scene_.half_space, part.height_maps.begin()->second.surface);
  if (auto const* unfit = std::get_if<std::string>(&choice))
    return complain({"model"},
                    fmt::format("is \"formula\", but {}; else give model = \"half_space\"", *unfit));
  scene_.formula = std::move(std::get<FormulaChoice>(choice));
  for (auto const& [name, probe] : part.probes)
    check_formula_probe(name, probe);
}

void Builder::check_formula_probe(std::string const& name, ProbePart const& part) {
  constexpr char const* remedy = "leave this out, or give model = \"half_space\"";
  auto const& formula = *scene_.formula;
  bool const energy = std::holds_alternative<EnergyProbe>(part);
  bool const forces = std::holds_alternative<ContactProbe>(part) || std::holds_alternative<RigidProbe>(part);
  refuse({"probes", name}, formula.moved && !forces,
         fmt::format("is not what Mindlin's formula gives of a motion along; {}", remedy));
  auto const reason = formula.normal->gives().no_energy;
  refuse({"probes", name}, energy && !reason.empty(),
         fmt::format("is not what {} gives: {}; {}", formula.normal->name(), reason, remedy));
}

} // namespace stiction::scene
