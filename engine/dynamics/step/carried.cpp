// The rigid motion that fits the driven nodes best (Kabsch 1976), where it fits them all.
#include "dynamics/step/carried.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace stiction::dynamics {

namespace {

constexpr double least_turn = 0.01; // rad, below which straight lines do as well
constexpr double exact = 1e-9;      // of the extent of the driven nodes

/// Columns are nodes.
using NodePlaces = Eigen::Matrix3Xd;

/// x1 = rotation x0 + shift.
struct RigidWay {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
};

Eigen::Matrix3d best_turn(NodePlaces const& from, NodePlaces const& to, int dim) {
  Eigen::Matrix3d const H = to * from.transpose();
  if (dim == 2)
    return Eigen::AngleAxisd(std::atan2(H(1, 0) - H(0, 1), H(0, 0) + H(1, 1)), Vec3::UnitZ())
        .toRotationMatrix();
  Eigen::JacobiSVD<Eigen::Matrix3d> const svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vec3 signs = Vec3::Ones();
  signs[2] = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// Do all points go this way, and does it turn by more than a little?
bool fits(RigidWay const& way, NodePlaces const& from, NodePlaces const& to) {
  NodePlaces const off = ((way.rotation * from).colwise() + way.shift) - to;
  double const extent = (from.colwise() - from.col(0)).colwise().norm().maxCoeff();
  return Eigen::AngleAxisd(way.rotation).angle() > least_turn &&
         off.colwise().norm().maxCoeff() <= exact * extent;
}

/// [bodies] is it tied to others, which would stay behind, or guided by constraints?
std::vector<bool> tied(Model const& model) {
  std::vector<bool> is(model.bodies.size());
  auto const body_of = [&](Index node) {
    return static_cast<std::size_t>(std::ranges::upper_bound(model.first_node, node) -
                                    model.first_node.begin()) -
           1;
  };
  auto const tie = [&](Index node) {
    if (node < model.first_node.back())
      is[body_of(node)] = true;
  };
  for (auto const& link : model.links) {
    tie(link.dof / model.dim());
    for (auto const& master : link.masters)
      tie(master.first / model.dim());
  }
  return is;
}

bool bonds_bodies(Pair const& pair) {
  return pair.law.adhesion && !std::holds_alternative<RigidSide>(pair.primary);
}

} // namespace

Carried::Carried(Model const& model) : model_(&model), driver_(ix(model.dofs()), nullptr) {
  if (weights(model.scheme).inertia || std::ranges::any_of(model.pairs, bonds_bodies))
    return;
  int const dim = model.dim();
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driver_[ix(dim * node + motion.component)] = &motion;
  auto const stays = tied(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (!stays[b])
      add_body(model.first_node[b], model.first_node[b + 1]);
}

/// If a motion turns it, and all of a node or nothing is driven.
void Carried::add_body(Index first, Index last) {
  int const dim = model_->dim();
  Body body{first, last, {}};
  bool turns = false;
  for (Index node = first; node < last; ++node) {
    int held = 0;
    for (int c = 0; c < dim; ++c)
      if (auto const* motion = driver_[ix(dim * node + c)]; motion != nullptr) {
        ++held;
        turns = turns || motion->turn;
      }
    if (held == dim)
      body.nodes.push_back(node);
    else if (held > 0)
      return;
  }
  if (turns)
    bodies_.push_back(std::move(body));
}

void Carried::guess(Vector const& u, double t1, Vector& d) const {
  int const dim = model_->dim();
  auto const place = [&](Index node) {
    Vec3 at = Vec3::Zero();
    at.head(dim) = model_->reference.row(node).transpose() + u.segment(dim * node, dim);
    return at;
  };
  for (auto const& body : bodies_) {
    auto const count = static_cast<Index>(body.nodes.size());
    NodePlaces from(3, count), to = NodePlaces::Zero(3, count);
    for (Index k = 0; k < count; ++k) {
      Index const node = body.nodes[ix(k)];
      from.col(k) = place(node);
      for (int c = 0; c < dim; ++c)
        to(c, k) = model_->reference(node, c) + driver_[ix(dim * node + c)]->value(t1);
    }
    Vec3 const before = from.rowwise().mean(), after = to.rowwise().mean();
    RigidWay way;
    way.rotation = best_turn(from.colwise() - before, to.colwise() - after, dim);
    way.shift = after - way.rotation * before;
    if (!fits(way, from, to))
      continue;
    for (Index node = body.first; node < body.last; ++node) {
      Vec3 const at = place(node);
      d.segment(dim * node, dim) = (way.rotation * at + way.shift - at).head(dim);
    }
  }
}

} // namespace stiction::dynamics
