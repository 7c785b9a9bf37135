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

/// |s|^2 of 11, 22, 33, 12 [, 23, 13].
double square(Eigen::RowVectorXd const& s) {
  return s.head<3>().squaredNorm() + 2 * s.tail(s.size() - 3).squaredNorm();
}

} // namespace

double StressError::relative() const {
  double const e = std::accumulate(error.begin(), error.end(), 0.0),
               s = std::accumulate(size.begin(), size.end(), 0.0);
  return e + s > 0 ? std::sqrt(e / (e + s)) : 0;
}

StressError stress_error(Body const& body, Kinematics kinematics, std::span<double const> u) {
  auto const apart = take_apart(body, u);
  Cells const whole(body, kinematics), cells(apart.body, kinematics);
  Matrix const recovered = whole.stress(u).cauchy, own = cells.stress(apart.u).cauchy;
  StressError result;
  cells.each_mass([&](std::span<Index const> nodes, Dense const& mass) {
    double const volume = mass.sum() / body.density, share = volume / static_cast<double>(nodes.size());
    double error = 0, size = 0;
    for (Index const node : nodes) {
      auto const smooth = recovered.row(apart.source[ix(node)]);
      error += share * square(smooth - own.row(node));
      size += share * square(smooth);
    }
    result.error.push_back(error);
    result.size.push_back(size);
    result.volume.push_back(volume);
  });
  return result;
}

} // namespace stiction::solid
