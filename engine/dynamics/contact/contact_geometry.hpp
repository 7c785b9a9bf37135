// Where nodes, rigid bodies and the counterparts of contact points are within a step.
#pragma once
#include <functional>
#include <optional>

#include "contact/mortar/mortar.hpp"
#include "contact/mortar/node_means.hpp"
#include "dynamics/contact/contact_system.hpp"

namespace stiction::dynamics {

/// Kinematics of single points and their geometric stiffness, whatever the kind of each pair.
template<int D> class ContactGeometry {
public:
  explicit ContactGeometry(Model const& model);
  /// Starts a step from `old` to time t1.
  void begin(State const& old, double t1);

  /// Takes the positions at u. Then `see` every point, `settle`, and ask for kinematics.
  void locate(Vector const& u);
  /// What the node of a point sees, where points are means over nodes; guess: its foot as last known.
  void see(PointId point, contact::Foot guess);
  void settle();
  [[nodiscard]] contact::PointKinematics<D> kinematics(PointId point, contact::Foot guess) const;
  /// Has the point come in past a border of the surface, well beneath it? Then it is in the counterpart's
  /// side, which is no part of the pair: nothing holds it until it is out.
  [[nodiscard]] bool beneath(PointId point, contact::PointKinematics<D> const& now) const;

  [[nodiscard]] std::span<double const> positions() const {
    return {positions_.data(), static_cast<std::size_t>(positions_.size())};
  }
  [[nodiscard]] Vector const& moved() const { return moved_; } ///< within the step, m, rad
  [[nodiscard]] std::vector<contact::Pose<D>> const& poses() const { return poses_; } ///< [rigids]
  /// Reference area of a point of a mortar pair at the step's start, m^2; none for other pairs.
  [[nodiscard]] std::optional<double> mortar_area(PointId point) const;
  /// Beyond this nothing is found, m.
  [[nodiscard]] double search_radius(int pair) const;

  /// Neighbours share their samples or nodes, so that the stiffness is that of all points of the pair.
  [[nodiscard]] bool shared(int pair) const { return mortars_[ix(pair)] || means_[ix(pair)]; }
  /// Takes nodes and the stiffness over them, [D nodes, D nodes], N/m.
  using Add = std::function<void(Indices const&, Eigen::Ref<Dense const> const&)>;
  /// Geometric stiffness of a force (n, t1 [, t2]), N, on one node, that of the point.
  void stiffness(PointId node, contact::PointKinematics<D> const& now, contact::Local<D> const& force,
                 Add const& add) const;
  /// How gap and slip change with the positions beyond what H says; nothing where that is all.
  void change(PointId point, contact::PointKinematics<D> const& now, Add const& add) const;
  /// Of the forces on all points of a pair that shares.
  void shared_stiffness(int pair, std::vector<contact::Local<D>> const& forces, Add const& add) const;

private:
  using Deformable = typename contact::Search<D>::Primary;
  void add_search(Pair const& pair);
  void add_means(Pair const& pair);
  void take_positions(Vector const& u, double t);
  template<class Act> void each_mortar(Act const& act);
  void change_of_node(PointId node, contact::PointKinematics<D> const& now, double weight,
                      Add const& add) const;
  [[nodiscard]] contact::Start start(PointId point) const;
  [[nodiscard]] contact::PosedObstacle<D> posed(RigidSide const& side) const;
  [[nodiscard]] contact::PosedObstacle<D> posed(RigidSide const& side, PointId point) const;
  [[nodiscard]] std::vector<contact::Vec3> tangents(std::size_t pair) const;
  [[nodiscard]] contact::PointKinematics<D> of_node(PointId point, contact::Foot guess) const;

  Model const* model_;
  State const* old_ = nullptr;
  double t1_ = 0;
  Vector positions_, moved_;            ///< moved_: within the step
  std::vector<contact::Pose<D>> poses_; ///< [rigids]
  mutable std::vector<std::vector<std::optional<contact::Vec3>>>
      normals_; ///< of obstacles at the step's start, once looked up, [pairs][points]; 3D
  std::vector<std::optional<contact::Search<D>>> searches_; ///< [pairs]; none against rigid bodies
  std::vector<std::optional<contact::Mortar<D>>> mortars_;  ///< [pairs]; none for node to segment
  std::vector<std::optional<contact::NodeMeans<D>>> means_; ///< [pairs]; none where each node is a point
};

} // namespace stiction::dynamics
