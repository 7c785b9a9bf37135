// Passes over the cells: force, stiffness, stress recovery, mass.
#include "solid/cells.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "solid/kernel.hpp"

namespace stiction::solid {

namespace {

/// Node coordinates of one cell, [nodes, 2].
Matrix corners(mesh::Mesh const& mesh, std::span<Index const> cell) {
  Matrix X(static_cast<Eigen::Index>(cell.size()), 2);
  for (std::size_t a = 0; a < cell.size(); ++a)
    X.row(static_cast<Eigen::Index>(a)) = mesh.nodes.row(cell[a]);
  return X;
}

/// Factor that turns an area into the integration measure: 1, or the
/// circumference at radius R.
double circumference(Kinematics kinematics, double R) {
  return kinematics == Kinematics::axisymmetric ? 2 * std::numbers::pi * R : 1.0;
}

/// Mass per component of a cell with corners X and this density.
Dense consistent_mass(mesh::Interpolation const& rule, Matrix const& X, double density,
                      Kinematics kinematics) {
  Dense mass = Dense::Zero(X.rows(), X.rows());
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    auto const N = rule.shape.row(q);
    double const area = (X.transpose() * rule.gradients[ix(static_cast<Index>(q))]).determinant();
    mass +=
        density * rule.weights[q] * area * circumference(kinematics, N.dot(X.col(0))) * (N.transpose() * N);
  }
  return mass;
}

/// sigma = F S F^T / J: 11, 22, 33, 12.
template<class PointState> Eigen::RowVector4d cauchy_stress(PointState const& point) {
  auto const& S = point.response.stress;
  Eigen::Matrix2d in_plane;
  in_plane << S[0], S[3], S[3], S[1];
  Eigen::Matrix2d const sigma = point.F * in_plane * point.F.transpose() / point.jacobian;
  return {sigma(0, 0), sigma(1, 1), point.F33 * point.F33 * S[2] / point.jacobian, sigma(0, 1)};
}

double von_mises(Eigen::RowVector4d const& s) {
  return std::sqrt(0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
                   3 * s[3] * s[3]);
}

} // namespace

/// One cell with its displacements, for a kernel K.
template<class K> class Cells::Cell {
public:
  Cell(Prepared const& block, Index number, std::span<double const> u)
      : block_(&block), first_point_(number * block.points),
        nodes_(&block.connectivity[ix(number * K::nodes)]) {
    for (int a = 0; a < K::nodes; ++a) {
      u_(a, 0) = u[ix(2 * nodes_[a])];
      u_(a, 1) = u[ix(2 * nodes_[a] + 1)];
    }
  }
  [[nodiscard]] Index node(int a) const { return nodes_[a]; }
  [[nodiscard]] int points() const { return block_->points; }
  [[nodiscard]] double weight(int q) const { return block_->weights[ix(first_point_ + q)]; }
  [[nodiscard]] typename K::Gradients gradients(int q) const {
    return typename K::Gradients(&block_->gradients[ix((first_point_ + q) * 2 * K::nodes)]);
  }
  [[nodiscard]] double const* hoop(int q) const {
    return K::axisymmetric ? &block_->hoop[ix((first_point_ + q) * K::nodes)] : nullptr;
  }
  template<material::Wanted wanted, class Law> [[nodiscard]] auto evaluate(Law const& law, int q) const {
    return K::template evaluate<wanted>(law, gradients(q), hoop(q), u_);
  }

  /// Adds force and energy; false if a point is turned inside out.
  template<class Law> bool add_force(Law const& law, typename K::Force& force, double& energy) const {
    for (int q = 0; q < points(); ++q) {
      auto const state = evaluate<material::Wanted::stress>(law, q);
      if (!(state.jacobian > 0))
        return false;
      energy += weight(q) * state.response.energy;
      force.noalias() +=
          K::strain_operator(state, gradients(q), hoop(q)).transpose() * (weight(q) * state.response.stress);
    }
    return true;
  }

private:
  Prepared const* block_;
  Index first_point_;
  Index const* nodes_;
  typename K::Displacements u_;
};

Cells::Cells(Body const& body, Kinematics kinematics) : body_(&body), kinematics_(kinematics) {
  for (auto const& block : body.mesh.blocks)
    blocks_.push_back(prepare(block));
}

Cells::Prepared Cells::prepare(mesh::Block const& block) const {
  auto const& rule = mesh::stiffness_rule(block.kind);
  Prepared prepared{
      block.kind, mesh::info(block.kind).nodes, static_cast<int>(rule.weights.size()), block.nodes, {}, {},
      {}};
  for (Index c = 0; c < prepared.cells(); ++c) {
    std::span<Index const> const cell(&block.nodes[ix(c * prepared.nodes)], ix(prepared.nodes));
    Matrix const X = corners(body_->mesh, cell);
    for (int q = 0; q < prepared.points; ++q) {
      Eigen::Matrix2d const jacobian = X.transpose() * rule.gradients[ix(q)];
      Matrix const G = rule.gradients[ix(q)] * jacobian.inverse();
      prepared.gradients.insert(prepared.gradients.end(), G.data(), G.data() + G.size());
      double const R = rule.shape.row(q).dot(X.col(0));
      prepared.weights.push_back(rule.weights[q] * jacobian.determinant() * circumference(kinematics_, R));
      if (kinematics_ == Kinematics::axisymmetric)
        for (int a = 0; a < prepared.nodes; ++a)
          prepared.hoop.push_back(rule.shape(q, a) / R);
    }
  }
  return prepared;
}

Index Cells::count() const {
  Index total = 0;
  for (auto const& block : blocks_)
    total += block.cells();
  return total;
}

/// Calls kernel.template operator()<Law, Nodes, Axisymmetric>(law) for the
/// block's law, kind and kinematics.
template<class KernelCall> void Cells::dispatch(Prepared const& block, KernelCall&& call) const {
  auto by_nodes = [&]<bool Axisymmetric>(auto const& law) {
    using Law = std::decay_t<decltype(law)>;
    switch (block.nodes) {
    case 3:
      return call.template operator()<Law, 3, Axisymmetric>(law);
    case 4:
      return call.template operator()<Law, 4, Axisymmetric>(law);
    case 6:
      return call.template operator()<Law, 6, Axisymmetric>(law);
    case 8:
      return call.template operator()<Law, 8, Axisymmetric>(law);
    default:
      core::expect(false, "a kernel for every cell kind");
    }
  };
  std::visit(
      [&](auto const& law) {
        if (kinematics_ == Kinematics::axisymmetric)
          by_nodes.template operator()<true>(law);
        else
          by_nodes.template operator()<false>(law);
      },
      body_->material);
}

/// Calls visit(law, cell) for every cell in order, the cell for the kernel of
/// its law, kind and kinematics.
template<class Visit> void Cells::each_deformed(std::span<double const> u, Visit&& visit) const {
  for (auto const& block : blocks_)
    dispatch(block, [&]<class Law, int Nodes, bool Axisymmetric>(Law const& law) {
      for (Index c = 0; c < block.cells(); ++c)
        visit(law, Cell<Kernel<Law, Nodes, Axisymmetric>>(block, c, u));
    });
}

Pass Cells::add_force(std::span<double const> u, std::span<double> force) const {
  Pass pass;
  Index number = 0;
  each_deformed(u, [&]<class K>(auto const& law, Cell<K> const& cell) {
    if (!pass.sound())
      return;
    typename K::Force f = K::Force::Zero();
    if (!cell.add_force(law, f, pass.energy)) {
      pass.inverted_cell = number;
      return;
    }
    for (int a = 0; a < K::nodes; ++a) {
      force[ix(2 * cell.node(a))] += f[2 * a];
      force[ix(2 * cell.node(a) + 1)] += f[2 * a + 1];
    }
    ++number;
  });
  return pass;
}

void Cells::add_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                          std::span<double> values) const {
  Index const* target = map.data();
  each_deformed(u, [&]<class K>(auto const& law, Cell<K> const& cell) {
    typename K::Stiffness stiffness = K::Stiffness::Zero();
    for (int q = 0; q < cell.points(); ++q)
      K::add_stiffness(cell.template evaluate<material::Wanted::tangent>(law, q), cell.gradients(q),
                       cell.hoop(q), factor * cell.weight(q), stiffness);
    for (int i = 0; i < K::dofs; ++i)
      for (int j = 0; j <= i; ++j, ++target)
        if (*target >= 0)
          values[ix(*target)] += stiffness(i, j);
  });
}

double Cells::add_damping(std::span<double const>, std::span<double const>, std::span<double>) const {
  core::expect(!damped(), "damping to be written");
  return 0;
}

void Cells::add_damping_stiffness(std::span<double const>, double, ScatterMap const&,
                                  std::span<double>) const {
  core::expect(!damped(), "damping to be written");
}

NodalStress Cells::stress(std::span<double const> u) const {
  Index const nodes = body_->mesh.node_count();
  NodalStress result{Matrix::Zero(nodes, 4), Vector::Zero(nodes)};
  Vector volume = Vector::Zero(nodes);
  auto add = [&](Index node, double weight, Eigen::RowVector4d const& cauchy) {
    result.cauchy.row(node) += weight * cauchy;
    volume[node] += weight;
  };
  each_deformed(u, [&]<class K>(auto const& law, Cell<K> const& cell) {
    for (int q = 0; q < cell.points(); ++q) {
      auto const state = cell.template evaluate<material::Wanted::stress>(law, q);
      if (!(state.jacobian > 0))
        continue;
      for (int a = 0; a < K::nodes; ++a)
        add(cell.node(a), cell.weight(q), cauchy_stress(state));
    }
  });
  for (Index i = 0; i < nodes; ++i) {
    if (volume[i] > 0)
      result.cauchy.row(i) /= volume[i];
    result.von_mises[i] = von_mises(result.cauchy.row(i));
  }
  return result;
}

void Cells::each_mass(std::function<void(std::span<Index const>, Dense const&)> const& visit) const {
  for (auto const& block : blocks_)
    for (Index c = 0; c < block.cells(); ++c) {
      std::span<Index const> const cell(&block.connectivity[ix(c * block.nodes)], ix(block.nodes));
      Matrix const X = corners(body_->mesh, cell);
      visit(cell, consistent_mass(mesh::mass_rule(block.kind), X, body_->density, kinematics_));
    }
}

void Cells::each_cell(std::function<void(std::span<Index const>)> const& visit) const {
  for (auto const& block : blocks_)
    for (Index c = 0; c < block.cells(); ++c)
      visit({&block.connectivity[ix(c * block.nodes)], ix(block.nodes)});
}

} // namespace stiction::solid
