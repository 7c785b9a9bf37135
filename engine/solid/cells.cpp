// Preparation of a body's cells, and the passes over all of its blocks.
#include "solid/cells.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/threads.hpp"
#include "solid/passes.hpp"
#include "solid/slabs.hpp"

namespace stiction::solid {

namespace {

/// Node coordinates of one cell, [nodes, dim].
Matrix corners(mesh::Mesh const& mesh, std::span<Index const> cell) {
  Matrix X(static_cast<Eigen::Index>(cell.size()), mesh.nodes.cols());
  for (std::size_t a = 0; a < cell.size(); ++a)
    X.row(static_cast<Eigen::Index>(a)) = mesh.nodes.row(cell[a]);
  return X;
}

std::span<Index const> nodes_of(PreparedBlock const& block, Index cell) {
  return {&block.connectivity[ix(cell * block.nodes)], ix(block.nodes)};
}

/// Factor that turns an area into the integration measure: 1, or the circumference at radius R.
double circumference(Kinematics kinematics, double R) {
  return kinematics == Kinematics::axisymmetric ? 2 * std::numbers::pi * R : 1.0;
}

/// dX/d reference coordinate and what is made of it, for cells of 2 or 3 dimensions.
struct Jacobian {
  Matrix inverse;
  double determinant;
};
template<int dim> Jacobian fixed_jacobian(Matrix const& X, Matrix const& gradients) {
  Eigen::Matrix<double, dim, dim> const J = X.transpose() * gradients;
  Eigen::Matrix<double, dim, dim> const inverse = J.inverse();
  return {inverse, J.determinant()};
}
Jacobian jacobian(Matrix const& X, Matrix const& gradients) {
  return X.cols() == 3 ? fixed_jacobian<3>(X, gradients) : fixed_jacobian<2>(X, gradients);
}

/// Mass per component of a cell with corners X and this density.
Dense consistent_mass(mesh::Interpolation const& rule, Matrix const& X, double density,
                      Kinematics kinematics) {
  Dense mass = Dense::Zero(X.rows(), X.rows());
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    auto const N = rule.shape.row(q);
    double const volume = jacobian(X, rule.gradients[ix(static_cast<Index>(q))]).determinant;
    mass +=
        density * rule.weights[q] * volume * circumference(kinematics, N.dot(X.col(0))) * (N.transpose() * N);
  }
  return mass;
}

/// s: 11, 22, 33, 12 [, 23, 13].
double von_mises(Eigen::RowVectorXd const& s) {
  return std::sqrt(0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
                   3 * s.tail(s.size() - 3).squaredNorm());
}

} // namespace

BlockPasses const& passes(Kinematics kinematics, int nodes) {
  switch (kinematics) {
  case Kinematics::plane_strain:
    return plane_strain_passes(nodes);
  case Kinematics::axisymmetric:
    return axisymmetric_passes(nodes);
  case Kinematics::three_dimensional:
    return three_dimensional_passes(nodes);
  }
  core::expect(false, "a known kinematics");
  std::abort();
}

Cells::Cells(Body const& body, Kinematics kinematics, PartOf const& part)
    : body_(&body), kinematics_(kinematics), shared_(part) {
  core::expect(body.mesh.nodes.cols() == dimension(kinematics), "a mesh of the kinematics' dimension");
  take(CellPart::all, part);
  whole_ = static_cast<Index>(blocks_.size());
  if (shared_)
    take(CellPart::forces, part);
  if (relaxing())
    number_points();
  core::each(static_cast<Index>(blocks_.size()), [&](Index i) { prepare(blocks_[ix(i)]); });
  parts_.resize(blocks_.size());
  std::ptrdiff_t entry = 0;
  for (auto const& block : blocks_) {
    first_entry_.push_back(entry);
    auto const dofs = std::ptrdiff_t{dimension(kinematics_)} * block.nodes;
    entry += block.cells() * (dofs * (dofs + 1) / 2);
  }
}

/// Blocks of the cells of this part; without `part` all of each cell is wanted.
void Cells::take(CellPart wanted, PartOf const& part) {
  Index number = 0;
  for (std::size_t i = 0; i < body_->mesh.blocks.size(); ++i) {
    auto const& block = body_->mesh.blocks[i];
    auto const width = ix(mesh::info(block.kind).nodes);
    Alike cells;
    for (std::size_t at = 0; at < block.nodes.size(); at += width, ++number)
      if (std::span const cell(&block.nodes[at], width); !part || part(cell) == wanted) {
        cells.connectivity.insert(cells.connectivity.end(), cell.begin(), cell.end());
        cells.number.push_back(number);
      }
    divide(block.kind, body_->law_of(i), cells);
  }
}

/// Cells in slabs, first every other one; a few cells in one piece.
void Cells::divide(mesh::CellKind kind, material::Material const& law, Alike const& cells) {
  int const nodes = mesh::info(kind).nodes;
  auto const points = static_cast<int>(mesh::stiffness_rule(kind).weights.size());
  core::expect(points <= most_points, "quadrature points within the capacity of a cell");
  auto const slab = slabs(cells.connectivity, nodes);
  Index const count = slab.empty() ? 0 : *std::ranges::max_element(slab) + 1,
              before = static_cast<Index>(blocks_.size());
  auto const place = [&](Index k) { return before + (k % 2 == 0 ? k / 2 : (count + k) / 2); };
  for (Index k = 0; k < count; ++k)
    blocks_.push_back({kind, nodes, points, {}, {}, {}, {}, &passes(kinematics_, nodes), &law, 0, shared_});
  for (std::size_t c = 0; c < slab.size(); ++c) {
    auto& own = blocks_[ix(place(slab[c]))];
    auto const* const cell = &cells.connectivity[c * ix(nodes)];
    own.number.push_back(cells.number[c]);
    own.connectivity.insert(own.connectivity.end(), cell, cell + nodes);
  }
  waves_.push_back({before, before + (count + 1) / 2});
  waves_.push_back({before + (count + 1) / 2, before + count});
}

void Cells::prepare(PreparedBlock& prepared) const {
  for (Index g = 0; g < prepared.groups(); ++g) {
    std::array<Matrix, Pack::lanes> X;
    for (int lane = 0; lane < Pack::lanes; ++lane)
      X[ix(lane)] = corners(body_->mesh, solid::nodes_of(prepared, prepared.cell(g, lane)));
    for (int q = 0; q < prepared.points; ++q)
      prepare_point(X, q, prepared);
  }
}

/// Adds point q of a group of cells with these corners.
void Cells::prepare_point(std::array<Matrix, Pack::lanes> const& X, int q, PreparedBlock& prepared) const {
  auto const& rule = mesh::stiffness_rule(prepared.kind);
  bool const axisymmetric = kinematics_ == Kinematics::axisymmetric;
  auto const first = prepared.gradients.size();
  prepared.gradients.resize(first + ix(prepared.nodes * (dimension(kinematics_) + (axisymmetric ? 1 : 0))));
  Pack volume;
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    auto const [inverse, determinant] = jacobian(X[ix(lane)], rule.gradients[ix(q)]);
    Dense const gradients = rule.gradients[ix(q)] * inverse; // columns follow each other in memory
    double const R = rule.shape.row(q).dot(X[ix(lane)].col(0));
    auto const count = static_cast<Index>(gradients.size());
    for (Index k = 0; k < count; ++k)
      prepared.gradients[first + ix(k)].set(lane, gradients(k));
    for (int a = 0; axisymmetric && a < prepared.nodes; ++a)
      prepared.gradients[first + ix(count + a)].set(lane, rule.shape(q, a) / R);
    volume.set(lane, rule.weights[q] * determinant * circumference(kinematics_, R));
  }
  prepared.volumes.push_back(volume);
}

Index Cells::count() const {
  Index total = 0;
  for (auto const& block : body_->mesh.blocks)
    total += static_cast<Index>(block.nodes.size()) / mesh::info(block.kind).nodes;
  return total;
}

/// Calls pass(number of a block, block), wave by wave.
template<class BlockPass> void Cells::each_block(BlockPass const& pass) const {
  for (auto const& wave : waves_)
    core::each(wave.last - wave.first,
               [&](Index k) { pass(ix(wave.first + k), blocks_[ix(wave.first + k)]); });
}

namespace {
BlockNetworks const* networks_of(Networks const* networks, std::size_t block) {
  return networks != nullptr ? &(*networks)[block] : nullptr;
}
} // namespace

Pass Cells::add_force(std::span<double const> u, std::span<double> force, Networks const* networks) const {
  each_block([&](std::size_t i, PreparedBlock const& block) {
    parts_[i].energy = 0;
    Index const inverted =
        block.passes->add_force({block, *body_, u, networks_of(networks, i)}, force, parts_[i].energy);
    parts_[i].inverted_cell = inverted >= 0 ? block.number[ix(inverted)] : -1;
  });
  Pass pass;
  for (Index i = 0; i < whole_; ++i)
    pass.energy += parts_[ix(i)].energy;
  for (auto const& part : parts_)
    if (!part.sound() && (pass.sound() || part.inverted_cell < pass.inverted_cell))
      pass.inverted_cell = part.inverted_cell;
  return pass;
}

/// Calls pass(number of a block, target) for each block with the part of the map that is its own.
template<class BlockPass>
void Cells::each_target(ScatterMap const& map, StiffnessTarget target, BlockPass const& pass) const {
  each_block([&](std::size_t i, PreparedBlock const&) {
    pass(i, StiffnessTarget{target.factor, map.data() + first_entry_[i], target.values});
  });
}

void Cells::add_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                          std::span<double> values, Networks const* networks) const {
  each_target(map, {factor, nullptr, values}, [&](std::size_t i, StiffnessTarget const& target) {
    blocks_[i].passes->add_stiffness({blocks_[i], *body_, u, networks_of(networks, i)}, target);
  });
}

double Cells::add_damping(std::span<double const> u, std::span<double const> v,
                          std::span<double> force) const {
  if (!damped())
    return 0;
  each_block([&](std::size_t i, PreparedBlock const& block) {
    parts_[i].energy = block.passes->add_damping({block, *body_, u}, v, force);
  });
  double power = 0;
  for (Index i = 0; i < whole_; ++i)
    power += parts_[ix(i)].energy;
  return power;
}

void Cells::add_damping_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                                  std::span<double> values) const {
  if (!damped())
    return;
  each_target(map, {factor, nullptr, values}, [&](std::size_t i, StiffnessTarget const& target) {
    blocks_[i].passes->add_damping_stiffness({blocks_[i], *body_, u}, target);
  });
}

NodalStress Cells::stress(std::span<double const> u, std::span<double const> memory) const {
  if (shared_)
    return stress_of_whole(u, memory);
  auto const now = relaxing() ? networks(memory, 0) : Networks{};
  Index const nodes = body_->mesh.node_count();
  StressSums sums{Vector::Zero(nodes), Matrix::Zero(nodes, stress_components(kinematics_))};
  each_block([&](std::size_t i, PreparedBlock const& block) {
    block.passes->add_stress({block, *body_, u, networks_of(now.empty() ? nullptr : &now, i)}, sums);
  });
  NodalStress result{std::move(sums.cauchy), Vector::Zero(nodes)};
  for (Index i = 0; i < nodes; ++i) {
    if (sums.volume[i] > 0)
      result.cauchy.row(i) /= sums.volume[i];
    result.von_mises[i] = von_mises(result.cauchy.row(i));
  }
  return result;
}

/// Calls visit(kind, nodes of a cell) for all cells: in the order of the passes, or of the mesh where others
/// share them.
template<class Visit> void Cells::each_whole(Visit const& visit) const {
  for (auto const& block : blocks_)
    for (Index c = 0; c < (shared_ ? 0 : block.cells()); ++c)
      visit(block.kind, solid::nodes_of(block, c));
  for (auto const& block : body_->mesh.blocks) {
    auto const width = ix(mesh::info(block.kind).nodes);
    for (std::size_t at = 0; at < (shared_ ? block.nodes.size() : 0); at += width)
      visit(block.kind, std::span(&block.nodes[at], width));
  }
}

void Cells::each_mass(std::function<void(std::span<Index const>, Dense const&)> const& visit) const {
  each_whole([&](mesh::CellKind kind, std::span<Index const> cell) {
    Matrix const X = corners(body_->mesh, cell);
    visit(cell, consistent_mass(mesh::mass_rule(kind), X, body_->density, kinematics_));
  });
}

void Cells::each_cell(std::function<void(std::span<Index const>)> const& visit) const {
  each_whole([&](mesh::CellKind, std::span<Index const> cell) { visit(cell); });
}

void Cells::each_part(std::function<void(std::span<Index const>)> const& visit) const {
  for (auto const& block : blocks_)
    for (Index c = 0; c < block.cells(); ++c)
      visit(solid::nodes_of(block, c));
}

std::span<Index const> Cells::nodes_of(Index cell) const {
  for (auto const& block : body_->mesh.blocks) {
    int const nodes = mesh::info(block.kind).nodes;
    auto const cells = static_cast<Index>(block.nodes.size()) / nodes;
    if (cell < cells)
      return {&block.nodes[ix(cell * nodes)], ix(nodes)};
    cell -= cells;
  }
  core::expect(false, "a cell of the mesh");
  std::abort();
}

MassCentre mass_centre(Body const& body, Cells const& cells) {
  MassCentre sum;
  cells.each_mass([&](std::span<Index const> nodes, Dense const& m) {
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      double const share = m.row(static_cast<Eigen::Index>(a)).sum();
      sum.mass += share;
      sum.centre.head(body.mesh.dim) += share * body.mesh.nodes.row(nodes[a]).transpose();
    }
  });
  sum.centre /= sum.mass;
  return sum;
}

} // namespace stiction::solid
