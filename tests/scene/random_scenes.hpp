// Scenes drawn at random from all that a script can ask for, small and valid.
#pragma once
#include <random>

#include "dynamics/all_schemes.hpp"
#include "interface/laws.hpp"

namespace stiction::test {

/// Draws that depend on the seed alone, on every machine.
class Dice {
public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  bool one_in(int count) { return below(count) == 0; }
  double between(double low, double high) { return low + (high - low) * below(1'000'001) / 1e6; }
  template<class T> T const& pick(std::vector<T> const& all) {
    return all[ix(below(static_cast<int>(all.size())))];
  }

private:
  static std::size_t ix(int i) { return static_cast<std::size_t>(i); }
  std::mt19937 engine_;
};

/// A scene's table, and the size and number of the steps it should be marched with.
struct RandomScene {
  Input table;
  std::string words; ///< what it is, for messages
  double dt = 0;     ///< s
  int steps = 6;
};

/// A law as a table, its dimensional numbers times factors from 0.7 to 1.4.
template<class... Laws>
Input table_of(Dice& dice, std::string const& category, std::variant<Laws...> const& choice) {
  return std::visit(
      [&](auto const& law) {
        core::Table table;
        for (auto const& p : law.schema().parameters) {
          auto const given = p.get(&law);
          if (auto const* number = std::get_if<double>(&given))
            table[p.name] = value(
                p.unit.empty() || p.unit == "1" ? *number : *number * std::exp2(dice.between(-0.5, 0.5)),
                p.unit.empty() ? "1" : p.unit);
          else if (auto const* word = std::get_if<std::string>(&given))
            table[p.name] = text(*word);
        }
        return make(category + "." + law.schema().name, std::move(table));
      },
      choice);
}

/// About 1000 Pa stiff.
inline Input random_material(Dice& dice) {
  auto const stiffness = [&] { return value(dice.between(500, 2000), "Pa"); };
  auto const bulk = [&] { return value(dice.between(1000, 5000), "Pa"); };
  switch (dice.below(6)) {
  case 0:
    return make("material.blatz_ko", {{"shear_modulus", stiffness()}});
  case 1:
    return make("material.mooney_rivlin",
                {{"C10", stiffness()}, {"C01", value(100, "Pa")}, {"bulk_modulus", bulk()}});
  case 2:
    return make(
        "material.yeoh",
        {{"C10", stiffness()}, {"C20", value(-10, "Pa")}, {"C30", value(5, "Pa")}, {"bulk_modulus", bulk()}});
  default:
    return make(dice.pick<std::string>(
                    {"material.linear_elastic", "material.neo_hookean", "material.st_venant_kirchhoff"}),
                {{"young", stiffness()}, {"poisson", value(dice.between(0, 0.45))}});
  }
}

/// Draws the parts of one scene.
class RandomScenes {
public:
  explicit RandomScenes(unsigned seed)
      : dice_(seed), sheets_(seed + 1000), relaxing_(seed + 2000), pressed_(seed + 3000),
        constraints_(seed + 4000), ties_(seed + 5000), volumes_(seed + 6000), folds_(seed + 7000),
        reliefs_(seed + 8000), maps_(seed + 9000) {}

  RandomScene draw() {
    kinematics_ =
        dice_.pick<std::string>({"plane_strain", "plane_strain", "axisymmetric", "three_dimensional"});
    dim_ = kinematics_ == "three_dimensional" ? 3 : 2;
    sample_ = dice_.pick(scheme_samples());
    RandomScene scene{make("scene"), kinematics_ + ", " + sample_.label};
    at(scene.table, "kinematics") = text(kinematics_);
    at(scene.table, "scheme") = sample_.table;
    add_bodies(scene);
    add_pair(scene);
    scene.dt = sample_.name == "central_difference" ? 5e-4 : sample_.order == 0 ? 0.25 : 0.02;
    add_motions(scene);
    at(scene.table, "schedule") = schedule({{scene.dt * scene.steps, scene.steps}});
    if (dice_.one_in(4))
      at(scene.table, "solver") =
          make("solver.gauss_seidel", {{"iterations", value(300)}}); // of a second or less
    if (kinematics_ != "axisymmetric" && dice_.one_in(4))
      turn_top(scene);
    if (dice_.one_in(3))
      add_spring(scene);
    if (pressed_.one_in(4))
      press_side(scene);
    bool const jean = sample_.name == "theta_xi" || sample_.name == "moreau_jean";
    bool const tipped = scene.words.find("tipped") != std::string::npos;
    if (kinematics_ != "axisymmetric" && !tipped && !sample_.cells && (sample_.order == 0 || jean) &&
        constraints_.one_in(3))
      add_constraint(scene);
    if (!sample_.cells && (sample_.order == 0 || jean) && ties_.one_in(3))
      tie_cap(scene);
    bool const led = scene.words.find(", tied") != std::string::npos ||
                     scene.words.find(", alike") != std::string::npos; // no contact at the nodes of either
    if (!led && folds_.one_in(2))
      touch_itself(scene);
    if (kinematics_ != "axisymmetric" && reliefs_.one_in(3))
      roughen(scene);
    if (kinematics_ != "axisymmetric" && !two_bodies_ && maps_.one_in(2))
      stand_on_map(scene);
    return scene;
  }

private:
  Input body(double low) {
    std::vector<double> origin(static_cast<std::size_t>(dim_), 0), size(origin.size(), 1), cells;
    origin.back() = low;
    size[0] = dice_.between(0.5, 1.5);
    for (int i = 0; i < dim_; ++i)
      cells.push_back(1 + dice_.below(dim_ == 2 ? 4 : 2));
    auto const kind = dim_ == 2 ? dice_.pick<std::string>({"quad4", "quad4", "quad8", "tri3", "tri6"})
                                : dice_.pick<std::string>({"hex8", "tet4"});
    core::Table mesh{{"origin", values(origin, "m")},
                     {"size", values(size, "m")},
                     {"cells", values(cells)},
                     {"kind", text(kind)}};
    core::Table parts{{"mesh", make(dim_ == 2 ? "mesh.block" : "mesh.box", std::move(mesh))},
                      {"material", random_material(dice_)},
                      {"density", value(dice_.between(0.5, 2), "kg/m^3")}};
    if ((kind == "quad4" || kind == "hex8") && dice_.one_in(3))
      parts["interpolation"] = text("mean_dilatation");
    else if (kinematics_ == "plane_strain" && sheets_.one_in(4))
      parts["plane_stress"] = flag(true);
    if (!parts.contains("plane_stress") && sample_.order > 0 && sample_.name != "central_difference" &&
        dice_.one_in(3))
      parts["damping"] =
          make("damping.kelvin_voigt", {{"shear_viscosity", value(dice_.between(0, 5), "Pa s")}});
    if (!parts.contains("plane_stress") && !sample_.cells)
      relax(parts);
    return make("body", std::move(parts));
  }
  /// In shear, in volume, in both by one term or by two.
  void relax(core::Table& parts) {
    core::List terms;
    if (relaxing_.one_in(4))
      terms.push_back(make("prony", {{"share", value(relaxing_.between(0.1, 0.5))},
                                     {"time", value(std::exp2(relaxing_.between(-12, 3)), "s")}}));
    double const bulk = volumes_.between(0.1, 0.5), time = std::exp2(volumes_.between(-12, 3));
    if (!terms.empty() && volumes_.one_in(3))
      at(terms.front(), "bulk_share") = value(bulk);
    else if (volumes_.one_in(8))
      terms.push_back(make("prony", {{"bulk_share", value(bulk)}, {"time", value(time, "s")}}));
    if (!terms.empty())
      parts["relaxing"] = list(std::move(terms));
  }
  void add_bodies(RandomScene& scene) {
    two_bodies_ = dice_.one_in(2);
    double const gap = dice_.one_in(3) ? 0.004 : 0;
    at(scene.table, "bodies.upper") = body(gap);
    if (at(scene.table, "bodies.upper").table()->contains("relaxing"))
      scene.words += ", relaxing";
    if (two_bodies_)
      at(scene.table, "bodies.lower") = body(-1);
    else if (dice_.one_in(3) && dim_ == 2 && kinematics_ != "axisymmetric")
      at(scene.table, "obstacles.lower.shape") =
          make("rigid.circle", {{"centre", values({0.4, -2}, "m")}, {"radius", value(2, "m")}});
    else
      at(scene.table, "obstacles.lower.shape") = make("rigid.plane");
  }
  void add_pair(RandomScene& scene) {
    auto joint = pair("upper.bottom", two_bodies_ ? "lower.top" : "lower");
    if (two_bodies_ && dice_.one_in(2))
      at(joint, "discretisation") = text("mortar");
    else if (two_bodies_ && dim_ == 2)
      at(joint, "smoothing") = text(dice_.pick<std::string>({"spline", "polyline"}));
    at(joint, "reach") = value(1.5, "m");
    if (!dice_.one_in(4)) {
      auto const friction = dice_.pick(frictions());
      scene.words += ", " + friction.name;
      at(joint, "friction") = table_of(dice_, "friction", friction.law);
    }
    if (dice_.one_in(2)) {
      auto const adhesion = dice_.pick(adhesions());
      scene.words += ", " + adhesion.name;
      at(joint, "adhesion") = table_of(dice_, "adhesion", adhesion.law);
    }
    at(scene.table, "pairs.joint") = std::move(joint);
  }
  /// The top sinks by up to a hundredth and goes sideways; a lower body stands on the ground.
  void add_motions(RandomScene& scene) {
    double const end = scene.dt * scene.steps;
    double const down = dice_.between(0, 0.015),
                 side = kinematics_ == "axisymmetric" ? 0 : dice_.between(-0.03, 0.03);
    core::Table path{{"set", text("upper.top")},
                     {"times", values({0, end / 2, end}, "s")},
                     {"x", values({0, 0, side}, "m")}};
    path[dim_ == 2 ? "y" : "z"] = values({0, -down, -0.7 * down}, "m");
    if (dim_ == 3)
      path["y"] = values({0, 0, 0.5 * side}, "m");
    core::List all{make("motion.drive", std::move(path))};
    if (two_bodies_)
      all.push_back(make("motion.fix", {{"set", text("lower.bottom")}}));
    at(scene.table, "motions") = list(std::move(all));
  }
  /// Soft beside the bodies: to the lower body, or to a place that goes sideways.
  void add_spring(RandomScene& scene) {
    core::Table parts{{"from", text("upper.bottom")}, {"stiffness", value(dice_.between(1, 50), "N/m")}};
    bool const revolved = kinematics_ == "axisymmetric";
    if (sample_.order > 0 && sample_.name != "central_difference" && dice_.one_in(2))
      parts["damping"] = value(dice_.between(0, 2), "N s/m");
    if (two_bodies_ && dice_.one_in(2)) {
      parts["to"] = text("lower.bottom");
    } else {
      parts["times"] = values({0, scene.dt * scene.steps}, "s");
      parts["y"] = values({0, dice_.between(-0.1, 0.1)}, "m");
      std::vector<double> place(static_cast<std::size_t>(dim_), -2);
      parts["anchor"] = values(place, "m");
    }
    bool const along = !revolved && dice_.one_in(2);
    if (along)
      parts["along"] = text("line");
    else if (parts.find("to") == parts.end() && dice_.one_in(2))
      parts["spread"] = flag(true);
    at(scene.table, "springs.tie") = make("spring", std::move(parts));
    scene.words += along ? ", on a line" : ", on a spring";
  }
  /// The upper body is one cell of many.
  void add_constraint(RandomScene& scene) {
    at(scene.table, "constraints") =
        list({make("constraint.periodic", {{"set", text("upper.left")}, {"to", text("upper.right")}})});
    scene.words += ", alike";
  }
  /// Another block on the upper body, tied to it, is driven in its place.
  void tie_cap(RandomScene& scene) {
    auto cap = at(scene.table, "bodies.upper");
    auto& origin = std::get<core::List>(at(cap, "mesh.origin").value);
    origin.back() = value(std::get<core::Quantity>(origin.back().value).value + 1, "m");
    auto& cells = std::get<core::List>(at(cap, "mesh.cells").value);
    for (auto& count : cells)
      count = value(2 + ties_.below(dim_ == 2 ? 4 : 2));
    at(scene.table, "bodies.cap") = std::move(cap);
    at(scene.table, "motions[1].set") = text("cap.top");
    auto& constraints = at(scene.table, "constraints");
    if (constraints.list() == nullptr)
      constraints = list({});
    std::get<core::List>(constraints.value).push_back(tied("cap.bottom", "upper.top"));
    scene.words += ", tied";
  }
  /// A side of the upper body may touch itself, rubbing and bonded, and has no cause to.
  void touch_itself(RandomScene& scene) {
    auto itself = pair("upper.right", "upper.right");
    at(itself, "friction") = table_of(folds_, "friction", folds_.pick(frictions()).law);
    if (folds_.one_in(2))
      at(itself, "adhesion") = table_of(folds_, "adhesion", folds_.pick(adhesions()).law);
    at(scene.table, "pairs.with_itself") = std::move(itself); // behind the joint
    scene.words += ", may touch itself";
  }
  /// Heights up to a hundredth, six a side.
  static Input heights(Dice& dice, std::size_t count) {
    if (!dice.one_in(2))
      return make("surface.wave", {{"amplitude", value(dice.between(1e-4, 5e-3), "m")},
                                   {"wavelengths", values(std::vector<double>(count, 0.75), "m")}});
    std::vector<double> all;
    for (int k = 0; k < (count == 2 ? 36 : 6); ++k)
      all.push_back(dice.between(0, 0.01));
    return make("surface.map", {{"heights", values(all)}, {"scale", value(1, "m")}});
  }
  /// The plane below is rough, about the middle of the body.
  void stand_on_map(RandomScene& scene) {
    auto& shape = at(scene.table, "obstacles.lower.shape");
    if (shape.tag != "rigid.plane")
      return;
    auto const count = static_cast<std::size_t>(dim_ - 1);
    shape = make("rigid.height_map", {{"surface", heights(maps_, count)},
                                      {"size", values(std::vector<double>(count, 1.5), "m")},
                                      {"points", values(std::vector<double>(count, 6))}});
    scene.words += ", on a map";
  }
  /// What the upper body stands on is not plane any more, by up to a hundredth.
  void roughen(RandomScene& scene) {
    auto const count = static_cast<std::size_t>(dim_ - 1);
    core::List size;
    for (std::size_t k = 0; k < count; ++k)
      size.push_back(at(scene.table, "bodies.upper.mesh.size").list()->at(k));
    core::Table parts{{"set", text("bottom")},
                      {"surface", heights(reliefs_, count)},
                      {"size", list(std::move(size))},
                      {"points", values(std::vector<double>(count, 6))}};
    bool const alike = scene.words.find(", alike") != std::string::npos; // which asks for like heights
    if (!alike && reliefs_.one_in(2))
      parts["boundary"] = text("free");
    if (reliefs_.one_in(2))
      parts["depth"] = value(reliefs_.between(0.2, 1), "m");
    at(scene.table, "bodies.upper.relief") = make("relief", std::move(parts));
    scene.words += ", in relief";
  }
  /// The top tips besides, by up to a fiftieth.
  void turn_top(RandomScene& scene) {
    auto& motion = at(scene.table, "motions[1]");
    motion.tag = "motion.turn";
    double const angle = dice_.between(-0.02, 0.02);
    at(motion, "angle") = values({0, 0, angle}, "rad");
    at(motion, "centre") = values(std::vector<double>(static_cast<std::size_t>(dim_), 0.5), "m");
    if (dim_ == 3)
      at(motion, "axis") = values({dice_.between(-1, 1), 1, dice_.between(-1, 1)});
    scene.words += ", tipped";
  }

  /// By a pressure that follows, or by surface stress, of up to a twentieth of the stiffness.
  void press_side(RandomScene& scene) {
    bool const stress = pressed_.one_in(2);
    core::Table parts{{"set", text("upper.right")}};
    if (stress) {
      parts["gamma"] = value(pressed_.between(1, 25), "N/m");
    } else {
      parts["times"] = values({0, scene.dt * scene.steps}, "s");
      parts["pressure"] = values({0, pressed_.between(-25, 25)}, "Pa");
    }
    at(scene.table, "loads") =
        list({make(stress ? "load.surface_stress" : "load.pressure", std::move(parts))});
    scene.words += stress ? ", surface stress" : ", pressure";
  }

  Dice dice_, sheets_, relaxing_, pressed_, constraints_, ties_, volumes_, folds_, reliefs_,
      maps_; ///< what these draw beside dice_ leaves all else as it was
  std::string kinematics_;
  int dim_ = 2;
  SchemeSample sample_;
  bool two_bodies_ = false;
};

} // namespace stiction::test
