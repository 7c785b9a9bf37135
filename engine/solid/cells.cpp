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

/// Factor that turns an area into the integration measure: 1, or the circumference at radius R.
double circumference(Kinematics kinematics, double R) {
  return kinematics == Kinematics::axisymmetric ? 2 * std::numbers::pi * R : 1.0;
}

template<int Nodes>
Eigen::Matrix<double, Nodes, 2, Eigen::RowMajor> gather(Index const* cell, std::span<double const> u) {
  Eigen::Matrix<double, Nodes, 2, Eigen::RowMajor> local;
  for (int a = 0; a < Nodes; ++a) {
    local(a, 0) = u[ix(2 * cell[a])];
    local(a, 1) = u[ix(2 * cell[a] + 1)];
  }
  return local;
}

} // namespace

Cells::Cells(Body const& body, Kinematics kinematics) : body_(&body), kinematics_(kinematics) {
  for (auto const& block : body.mesh.blocks) {
    auto const& rule = mesh::stiffness_rule(block.kind);
    Prepared prepared{
        block.kind, mesh::info(block.kind).nodes, static_cast<int>(rule.weights.size()), block.nodes, {}, {},
        {}};
    for (Index c = 0; c < prepared.cells(); ++c) {
      std::span<Index const> const cell(&block.nodes[ix(c * prepared.nodes)], ix(prepared.nodes));
      Matrix const X = corners(body.mesh, cell);
      for (int q = 0; q < prepared.points; ++q) {
        Eigen::Matrix2d const jacobian = X.transpose() * rule.gradients[ix(q)];
        Matrix const G = rule.gradients[ix(q)] * jacobian.inverse();
        prepared.gradients.insert(prepared.gradients.end(), G.data(), G.data() + G.size());
        double const R = rule.shape.row(q).dot(X.col(0));
        prepared.weights.push_back(rule.weights[q] * jacobian.determinant() * circumference(kinematics, R));
        if (kinematics == Kinematics::axisymmetric)
          for (int a = 0; a < prepared.nodes; ++a)
            prepared.hoop.push_back(rule.shape(q, a) / R);
      }
    }
    blocks_.push_back(std::move(prepared));
  }
}

Index Cells::count() const {
  Index total = 0;
  for (auto const& block : blocks_)
    total += block.cells();
  return total;
}

/// Calls kernel.template operator()<Law, Nodes, Axisymmetric>(law) for the block's law, kind and kinematics.
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

Pass Cells::add_force(std::span<double const> u, std::span<double> force) const {
  Pass pass;
  Index first = 0;
  for (auto const& block : blocks_) {
    dispatch(block, [&]<class Law, int Nodes, bool Axisymmetric>(Law const& law) {
      using K = Kernel<Law, Nodes, Axisymmetric>;
      for (Index c = 0; c < block.cells(); ++c) {
        Index const* cell = &block.connectivity[ix(c * Nodes)];
        auto const local = gather<Nodes>(cell, u);
        typename K::Force f = K::Force::Zero();
        for (int q = 0; q < block.points; ++q) {
          Index const point = c * block.points + q;
          typename K::Gradients const G(&block.gradients[ix(point * 2 * Nodes)]);
          double const* hoop = Axisymmetric ? &block.hoop[ix(point * Nodes)] : nullptr;
          auto const state = K::template evaluate<material::Wanted::stress>(law, G, hoop, local);
          if (!(state.jacobian > 0)) {
            if (pass.sound())
              pass.inverted_cell = first + c;
            return;
          }
          double const weight = block.weights[ix(point)];
          pass.energy += weight * state.response.energy;
          f.noalias() += K::strain_operator(state, G, hoop).transpose() * (weight * state.response.stress);
        }
        for (int a = 0; a < Nodes; ++a) {
          force[ix(2 * cell[a])] += f[2 * a];
          force[ix(2 * cell[a] + 1)] += f[2 * a + 1];
        }
      }
    });
    if (!pass.sound())
      return pass;
    first += block.cells();
  }
  return pass;
}

void Cells::add_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                          std::span<double> values) const {
  Index const* target = map.data();
  for (auto const& block : blocks_)
    dispatch(block, [&]<class Law, int Nodes, bool Axisymmetric>(Law const& law) {
      using K = Kernel<Law, Nodes, Axisymmetric>;
      for (Index c = 0; c < block.cells(); ++c) {
        auto const local = gather<Nodes>(&block.connectivity[ix(c * Nodes)], u);
        typename K::Stiffness stiffness = K::Stiffness::Zero();
        for (int q = 0; q < block.points; ++q) {
          Index const point = c * block.points + q;
          typename K::Gradients const G(&block.gradients[ix(point * 2 * Nodes)]);
          double const* hoop = Axisymmetric ? &block.hoop[ix(point * Nodes)] : nullptr;
          auto const state = K::template evaluate<material::Wanted::tangent>(law, G, hoop, local);
          K::add_stiffness(state, G, hoop, factor * block.weights[ix(point)], stiffness);
        }
        for (int i = 0; i < K::dofs; ++i)
          for (int j = 0; j <= i; ++j, ++target)
            if (*target >= 0)
              values[ix(*target)] += stiffness(i, j);
      }
    });
}

NodalStress Cells::stress(std::span<double const> u) const {
  Index const nodes = body_->mesh.node_count();
  NodalStress result{Matrix::Zero(nodes, 4), Vector::Zero(nodes)};
  Vector volume = Vector::Zero(nodes);
  for (auto const& block : blocks_)
    dispatch(block, [&]<class Law, int Nodes, bool Axisymmetric>(Law const& law) {
      using K = Kernel<Law, Nodes, Axisymmetric>;
      for (Index c = 0; c < block.cells(); ++c) {
        Index const* cell = &block.connectivity[ix(c * Nodes)];
        auto const local = gather<Nodes>(cell, u);
        for (int q = 0; q < block.points; ++q) {
          Index const point = c * block.points + q;
          typename K::Gradients const G(&block.gradients[ix(point * 2 * Nodes)]);
          auto const state = K::template evaluate<material::Wanted::stress>(
              law, G, Axisymmetric ? &block.hoop[ix(point * Nodes)] : nullptr, local);
          if (!(state.jacobian > 0))
            continue;
          auto const& S = state.response.stress; // sigma = F S F^T / J
          Eigen::Matrix2d in_plane;
          in_plane << S[0], S[3], S[3], S[1];
          Eigen::Matrix2d const sigma = state.F * in_plane * state.F.transpose() / state.jacobian;
          Eigen::RowVector4d const cauchy(sigma(0, 0), sigma(1, 1),
                                          state.F33 * state.F33 * S[2] / state.jacobian, sigma(0, 1));
          double const weight = block.weights[ix(point)];
          for (int a = 0; a < Nodes; ++a) {
            result.cauchy.row(cell[a]) += weight * cauchy;
            volume[cell[a]] += weight;
          }
        }
      }
    });
  for (Index i = 0; i < nodes; ++i) {
    if (volume[i] > 0)
      result.cauchy.row(i) /= volume[i];
    auto const s = result.cauchy.row(i);
    result.von_mises[i] =
        std::sqrt(0.5 * (std::pow(s[0] - s[1], 2) + std::pow(s[1] - s[2], 2) + std::pow(s[2] - s[0], 2)) +
                  3 * s[3] * s[3]);
  }
  return result;
}

void Cells::each_mass(std::function<void(std::span<Index const>, Dense const&)> const& visit) const {
  for (auto const& block : blocks_) {
    auto const& rule = mesh::mass_rule(block.kind);
    for (Index c = 0; c < block.cells(); ++c) {
      std::span<Index const> const cell(&block.connectivity[ix(c * block.nodes)], ix(block.nodes));
      Matrix const X = corners(body_->mesh, cell);
      Dense mass = Dense::Zero(block.nodes, block.nodes);
      for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
        auto const N = rule.shape.row(q);
        double const area = (X.transpose() * rule.gradients[ix(static_cast<Index>(q))]).determinant();
        mass += body_->density * rule.weights[q] * area * circumference(kinematics_, N.dot(X.col(0))) *
                (N.transpose() * N);
      }
      visit(cell, mass);
    }
  }
}

void Cells::each_cell(std::function<void(std::span<Index const>)> const& visit) const {
  for (auto const& block : blocks_)
    for (Index c = 0; c < block.cells(); ++c)
      visit({&block.connectivity[ix(c * block.nodes)], ix(block.nodes)});
}

} // namespace stiction::solid
