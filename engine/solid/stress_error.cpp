// Recovered stress against the stress of cells that share no node.
#include "solid/stress_error.hpp"

#include <cmath>
#include <numeric>

namespace stiction::solid {

namespace {

/// The body with nodes of each cell's own, and the displacements there: its nodal stress is the cells' own.
struct Apart {
  Body body;
  std::vector<double> u;
  Indices source; ///< [nodes] the node of the whole body
};

Apart take_apart(Body const& body, std::span<double const> u) {
  Apart apart{body, {}, {}};
  for (auto& block : apart.body.mesh.blocks)
    for (Index& node : block.nodes) {
      apart.source.push_back(node);
      node = static_cast<Index>(apart.source.size()) - 1;
    }
  auto const dim = body.mesh.nodes.cols();
  apart.body.mesh.sets.clear();
  apart.body.mesh.nodes.resize(static_cast<Eigen::Index>(apart.source.size()), dim);
  for (std::size_t i = 0; i < apart.source.size(); ++i) {
    apart.body.mesh.nodes.row(static_cast<Eigen::Index>(i)) = body.mesh.nodes.row(apart.source[i]);
    for (Eigen::Index c = 0; c < dim; ++c)
      apart.u.push_back(u[ix(static_cast<Index>(dim) * apart.source[i] + static_cast<Index>(c))]);
  }
  return apart;
}

std::span<double const> view(Vector const& v) {
  return {v.data(), static_cast<std::size_t>(v.size())};
}

/// int |s|^2 of s[nodes, 11, 22, 33, 12 [, 23, 13]] between the nodes of a cell;
/// mass over density: int N_a N_b.
double square(Dense const& s, Dense const& mass, double density) {
  auto const each = s.cwiseProduct(mass * s).colwise().sum().eval();
  return (each.head<3>().sum() + 2 * each.tail(each.size() - 3).sum()) / density;
}

} // namespace

double StressError::relative() const {
  double const e = std::accumulate(error.begin(), error.end(), 0.0),
               s = std::accumulate(size.begin(), size.end(), 0.0);
  return e + s > 0 ? std::sqrt(e / (e + s)) : 0;
}

StressError stress_error(Body const& body, Kinematics kinematics, std::span<double const> u,
                         std::span<double const> memory) {
  auto const apart = take_apart(body, u);
  Cells const whole(body, kinematics), cells(apart.body, kinematics);
  Vector const of_cells = memory.empty() ? Vector() : cells.from_cells(view(whole.by_cell(memory)));
  Matrix const recovered = whole.stress(u, memory).cauchy, own = cells.stress(apart.u, view(of_cells)).cauchy;
  StressError result;
  cells.each_mass([&](std::span<Index const> nodes, Dense const& mass) {
    Dense smooth(static_cast<Eigen::Index>(nodes.size()), recovered.cols()), jump = smooth;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      auto const row = static_cast<Eigen::Index>(a);
      smooth.row(row) = recovered.row(apart.source[ix(nodes[a])]);
      jump.row(row) = smooth.row(row) - own.row(nodes[a]);
    }
    result.error.push_back(square(jump, mass, body.density));
    result.size.push_back(square(smooth, mass, body.density));
    result.volume.push_back(mass.sum() / body.density);
  });
  return result;
}

} // namespace stiction::solid
