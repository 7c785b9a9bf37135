// A dense product, a sum over more memory than caches hold, and passes over some cells, each timed.
#include "scene/explain/machine.hpp"

#include <algorithm>
#include <ctime>
#include <limits>

extern "C" {
void dgemm_(char const* transa, char const* transb, int const* m, int const* n, int const* k,
            double const* alpha, double const* a, int const* lda, double const* b, int const* ldb,
            double const* beta, double* c, int const* ldc);
}

namespace stiction::scene {

namespace {

constexpr Index sample = 200; // cells

/// Of the processor, of one call: the first warms caches, the quickest of the others counts, as what else the
/// machine does only takes from it.
template<class Call> double seconds_of(Call&& call, int times = 6) {
  call();
  auto quickest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < times; ++k) {
    auto const begin = std::clock();
    call();
    quickest = std::min(quickest, static_cast<double>(std::clock() - begin));
  }
  return std::max(1.0, quickest) / CLOCKS_PER_SEC;
}

/// The block's first cells, on nodes of their own.
mesh::Mesh sample_of(mesh::Mesh const& mesh, mesh::Block const& block) {
  auto const width = static_cast<Index>(mesh::info(block.kind).nodes);
  auto const cells = std::min(sample, static_cast<Index>(block.nodes.size()) / width);
  mesh::Mesh part{mesh.dim, Matrix(width * cells, mesh.dim), {{block.kind, {}}}, {}};
  for (Index k = 0; k < width * cells; ++k) {
    part.nodes.row(k) = mesh.nodes.row(block.nodes[ix(k)]);
    part.blocks[0].nodes.push_back(k);
  }
  return part;
}

PassSeconds measure_block(dynamics::Model const& model, solid::Body const& body, std::size_t number) {
  auto const& block = body.mesh.blocks[number];
  solid::Body const part{body.name,
                         sample_of(body.mesh, block),
                         body.law_of(number),
                         body.density,
                         body.interpolation,
                         {},
                         {},
                         body.plane_stress};
  solid::Cells const cells(part, model.kinematics);
  auto const unknowns = ix(model.dim()) * ix(mesh::info(block.kind).nodes);
  std::size_t const entries = ix(cells.count()) * unknowns * (unknowns + 1) / 2;
  solid::ScatterMap apart(entries);
  for (std::size_t k = 0; k < entries; ++k)
    apart[k] = static_cast<Index>(k);
  std::vector<double> const u(ix(model.dim() * part.mesh.node_count()), 0.0);
  std::vector<double> force(u.size()), values(entries);
  PassSeconds seconds;
  seconds.force = seconds_of([&] { static_cast<void>(cells.add_force(u, force)); });
  seconds.stiffness = seconds_of([&] { cells.add_stiffness(u, 1, apart, values); });
  double const scale = static_cast<double>(block.nodes.size()) / static_cast<double>(part.mesh.node_count());
  return {scale * seconds.force, scale * seconds.stiffness};
}

} // namespace

Machine measure_machine() {
  int const n = 192;
  Dense const A = Dense::Ones(n, n);
  Dense C = A;
  double const one = 1;
  double const product =
      seconds_of([&] { dgemm_("N", "N", &n, &n, &n, &one, A.data(), &n, A.data(), &n, &one, C.data(), &n); });
  Vector const many = Vector::Ones(1 << 21);
  double sum = 0;
  double const read = seconds_of([&] { sum += many.sum(); });
  Machine machine{2.0 * n * n * n / product, 8.0 * static_cast<double>(many.size()) / read};
  return sum > 0 ? machine : Machine{}; // what is summed is used
}

double measure_product(halfspace::Surface const& surface) {
  Vector const one = Vector::Ones(surface.rows());
  Vector other = one;
  return seconds_of([&] { surface.add_product(one, other); });
}

PassSeconds measure_passes(dynamics::Model const& model) {
  PassSeconds all;
  for (auto const& body : model.bodies)
    for (std::size_t i = 0; i < body->mesh.blocks.size(); ++i) {
      if (body->mesh.blocks[i].nodes.empty())
        continue;
      auto const own = measure_block(model, *body, i);
      all.force += own.force;
      all.stiffness += own.stiffness;
    }
  return all;
}

} // namespace stiction::scene
