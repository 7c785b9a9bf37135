// Fields over all bodies; contact fields live on the secondary nodes, status is -1 elsewhere.
#include "scene/run/frame.hpp"

namespace stiction::scene {

using dynamics::ContactState;

namespace {

/// Of the bodies' nodes; what belongs to rigid bodies comes after them and is left out.
record::FieldArray vector_array(char const* name, char const* unit, Scene const& scene,
                                Vector const& values) {
  record::FieldArray array{name, unit, 3, {}, false};
  int const dim = scene.model->dim();
  for (Index i = 0; i < scene.model->first_node.back(); ++i)
    for (int c = 0; c < 3; ++c)
      array.values.push_back(c < dim ? values[dim * i + c] : 0.0);
  return array;
}

void add_stress(Scene const& scene, dynamics::State const& state, record::FieldFrame& frame) {
  record::FieldArray stress{"cauchy_stress", "Pa", 6, {}, false}, mises{"von_mises", "Pa", 1, {}, false};
  auto const& model = *scene.model;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    int const dim = model.dim();
    auto const first = ix(dim * model.first_node[b]), count = ix(dim * model.first_node[b + 1]) - first;
    auto const nodal = model.cells[b].stress({state.u.data() + first, count}, state.memory_of(b));
    for (Eigen::Index i = 0; i < nodal.von_mises.size(); ++i) {
      auto const s = nodal.cauchy.row(i);
      for (Eigen::Index k = 0; k < 6; ++k)
        stress.values.push_back(k < s.size() ? s[k] : 0.0);
      mises.values.push_back(nodal.von_mises[i]);
    }
  }
  frame.point_arrays.push_back(std::move(stress));
  frame.point_arrays.push_back(std::move(mises));
}

void add_contact(Scene const& scene, dynamics::State const& state, record::FieldFrame& frame) {
  auto const& model = *scene.model;
  if (model.pairs.empty())
    return;
  auto const n = ix(model.first_node.back());
  record::FieldArray beta{"beta", "1", 1, std::vector<double>(n, 0.0), false};
  record::FieldArray pressure{"contact_pressure", "Pa", 1, std::vector<double>(n, 0.0), false};
  record::FieldArray adhesion{"tangential_adhesion", "Pa", 1, std::vector<double>(n, 0.0), false};
  record::FieldArray pull{"normal_adhesion", "Pa", 1, std::vector<double>(n, 0.0), false};
  record::FieldArray status{"status", "1", 1, std::vector<double>(n, -1.0), false};
  for (std::size_t p = 0; p < model.pairs.size(); ++p)
    for (std::size_t i = 0; i < model.pairs[p].secondary.size(); ++i) {
      auto const node = ix(model.pairs[p].secondary[i]);
      auto const& point = state.contacts[p][i];
      beta.values[node] = point.bond.beta;
      pressure.values[node] = point.dry[0];
      adhesion.values[node] = model.dim() == 2 ? point.adhesion[1] : point.adhesion.tail<2>().norm();
      pull.values[node] = point.adhesion[0];
      status.values[node] = static_cast<double>(point.status);
    }
  for (auto* array : {&beta, &pressure, &adhesion, &pull, &status})
    frame.point_arrays.push_back(std::move(*array));
}

} // namespace

record::FieldFrame frame_of(Scene const& scene, dynamics::State const& state) {
  record::FieldFrame frame;
  frame.time = state.t;
  for (auto const& body : scene.model->bodies)
    record::add_body(frame, body->mesh);
  frame.point_arrays.push_back(vector_array("displacement", "m", scene, state.u));
  frame.point_arrays.push_back(vector_array("velocity", "m/s", scene, state.v));
  add_stress(scene, state, frame);
  add_contact(scene, state, frame);
  return frame;
}

record::GridFrame frame_of(halfspace::Model const& model, GridFields const& fields) {
  auto const& grid = model.grid;
  auto const n = ix(grid.size());
  struct Shown {
    char const *name, *unit;
    double (*value)(ContactState const&);
  };
  std::vector<Shown> shown{
      {"gap", "m", [](ContactState const& at) { return at.gap; }},
      {"contact_pressure", "Pa", [](ContactState const& at) { return at.dry[0]; }},
      {"status", "1", [](ContactState const& at) { return static_cast<double>(at.status); }}};
  if (model.components() > 1)
    shown.push_back({"friction", "Pa", [](ContactState const& at) { return at.dry.tail<2>().norm(); }});
  if (model.law.adhesion) {
    shown.push_back({"beta", "1", [](ContactState const& at) { return at.bond.beta; }});
    shown.push_back({"normal_adhesion", "Pa", [](ContactState const& at) { return at.adhesion[0]; }});
    shown.push_back(
        {"tangential_adhesion", "Pa", [](ContactState const& at) { return at.adhesion.tail<2>().norm(); }});
  }
  record::GridFrame frame{
      fields.time, grid.nx, grid.ny, grid.x(0), grid.y(0), grid.dx(), grid.line ? 1 : grid.dy(), {}};
  auto& arrays = frame.point_arrays;
  arrays.push_back({"displacement", "m", 3, std::vector<double>(3 * n), false});
  for (auto const& one : shown)
    arrays.push_back({one.name, one.unit, 1, std::vector<double>(n), false});
  for (std::size_t i = 0; i < n; ++i) {
    auto const point = static_cast<Index>(i);
    contact::Vec3 const u = fields.displacement(point);
    Eigen::Vector3d::Map(&arrays[0].values[3 * i]) << u[1], grid.line ? -u[0] : u[2], grid.line ? 0 : -u[0];
    auto const at = fields.at(point);
    for (std::size_t q = 0; q < shown.size(); ++q)
      arrays[q + 1].values[i] = shown[q].value(at);
  }
  return frame;
}

} // namespace stiction::scene
