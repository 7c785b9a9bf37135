// Four cells in deformed state, side by side: strain, stress, force and stiffness, all of fixed size.
#pragma once
#include <array>
#include <utility>

#include "solid/block.hpp"
#include "solid/dilatation.hpp"
#include "solid/geometry.hpp"
#include "solid/sheet.hpp"

namespace stiction::solid {

/// One group of a block's cells after the other. Call deform, then respond or flow, then what is wanted. What
/// lanes say that no cell is left for is that of the last one.
template<Kinematics kinematics, int Nodes> class CellGroup {
public:
  using G = Geometry<kinematics>;
  static constexpr int nodes = Nodes, dim = G::dim, voigt = G::voigt, width = G::width;
  static constexpr bool plane = kinematics == Kinematics::plane_strain;
  using Voigt = material::Voigt<voigt, Pack>;
  using Nodal = Eigen::Matrix<Pack, Nodes, dim>;
  using Gradients = Eigen::Map<Eigen::Matrix<Pack, Nodes, width> const>;
  using Square = Eigen::Matrix<Pack, Nodes, Nodes>;
  using Stiffness = std::array<Square, G::pairs>; ///< between components i >= j, lower ones by symmetry

  explicit CellGroup(Deformed const& at)
      : block_(at.block), body_(at.body), networks_(at.networks), finite_(!small_strain(*at.block.law)),
        mean_(at.body.interpolation == Interpolation::mean_dilatation) {}

  /// How many lanes have a cell of their own.
  [[nodiscard]] int cells() const { return block_.cells_in(number_); }
  /// Of the cell in a lane.
  [[nodiscard]] Index const* connectivity(int lane) const {
    return &block_.connectivity[ix(block_.cell(number_, lane) * nodes)];
  }
  [[nodiscard]] int points() const { return block_.points; }
  [[nodiscard]] Pack const& volume(int q) const { return block_.volumes[ix(number_ * points() + q)]; }
  /// Had the cell in this lane det F > 0 at all points?
  [[nodiscard]] bool sound(int lane) const { return sound_[lane] > 0; }

  /// Takes the displacements of group `number`; the lane of the first cell with det F <= 0 at a point, or
  /// where plane stress finds no stretch across, or -1.
  int deform(Index number, std::span<double const> u) {
    number_ = number;
    gather(u);
    sound_ = 1;
    for (int q = 0; q < points(); ++q) {
      Point& point = points_[at(q)];
      typename G::Gradient const H = gradient(q);
      strains_[at(q)] = G::strain(H, finite_ ? 0.5 : 0.0);
      point.F.setIdentity();
      point.jacobian = 1;
      if (finite_) {
        point.F = G::deformation(H);
        point.jacobian = G::jacobian(point.F);
        sound_ = where_positive(point.jacobian, sound_);
      }
    }
    if (mean_)
      average_dilatation();
    if constexpr (plane)
      if (body_.plane_stress)
        stretch_across();
    int lane = 0;
    while (lane < Pack::lanes && sound(lane))
      ++lane;
    return lane < Pack::lanes ? lane : -1;
  }

  /// The law's response at every point; its energy in each cell.
  template<material::Wanted wanted> Pack respond() {
    solid::respond<voigt>(*block_.law, wanted, {strains_.data(), at(points())},
                          {responses_.data(), at(points())});
    if (networks_ != nullptr)
      add_networks<wanted>();
    if constexpr (plane)
      if (body_.plane_stress)
        AcrossSheet::condense(wanted, {responses_.data(), at(points())});
    Pack energy = 0;
    for (int q = 0; q < points(); ++q)
      energy += volume(q) * responses_[at(q)].energy;
    return energy;
  }

  /// Takes networks through a step; the energies in each cell.
  material::NetworkEnergy<Pack> relax(Remembered const& memory) {
    material::NetworkEnergy<Pack> sum;
    for (int q = 0; q < points(); ++q) {
      material::NetworkEnergy<Pack> of_point;
      if (!memory.steps.shear.empty())
        relax_shear(memory, q, of_point);
      if (!memory.steps.volume.empty())
        relax_volume(memory, q, of_point);
      sum.stored += volume(q) * of_point.stored;
      sum.dissipated += volume(q) * of_point.dissipated;
    }
    return sum;
  }

  /// The viscous response to velocities v at every point; the power it dissipates.
  Pack flow(std::span<double const> v) {
    gather(v);
    auto const D = body_.damping->viscosity<voigt>().template cast<Pack>().eval();
    Pack tau_rate = 0, power = 0;
    for (int q = 0; q < points(); ++q) {
      strains_[at(q)] = G::strain_rate(points_[at(q)].F, gradient(q));
      if (mean_)
        tau_rate += volume(q) / mean_volume_ * dilatations_[at(q)].volume_gradient().dot(strains_[at(q)]);
    }
    for (int q = 0; q < points(); ++q) {
      Voigt const rate = mean_ ? dilatations_[at(q)].mean_rate(strains_[at(q)], tau_rate) : strains_[at(q)];
      responses_[at(q)].stress.noalias() = D * rate;
      power += volume(q) * rate.dot(responses_[at(q)].stress);
    }
    return power;
  }
  /// No stress and the viscosities as tangent.
  void be_viscous() {
    for (int q = 0; q < points(); ++q) {
      responses_[at(q)].stress.setZero();
      responses_[at(q)].tangent = body_.damping->viscosity<voigt>().template cast<Pack>();
    }
  }

  /// sigma = F S F^T / det F, of Fbar with mean dilatation.
  [[nodiscard]] material::Tensor<Pack> cauchy(int q) const {
    Point const& point = points_[at(q)];
    Pack const scale = mean_ && finite_ ? dilatations_[at(q)].a / mean_ratio_ : 1 / point.jacobian;
    return scale * point.F * stress_tensor<voigt>(responses_[at(q)].stress) * point.F.transpose();
  }

  /// int B^T S per node and component.
  [[nodiscard]] Nodal force() {
    if (mean_)
      conjugate_stress();
    Nodal f = Nodal::Zero();
    for (int q = 0; q < points(); ++q) {
      typename G::Gradient P;
      for (int i = 0; i < dim; ++i)
        P.col(i) = volume(q) * G::pull(points_[at(q)].F, i, responses_[at(q)].stress);
      f += gradients(q).lazyProduct(P);
    }
    return f;
  }

  /// factor * int B^T D B + G S G^T, (41), and with mean dilatation the terms of theta.
  void stiffness(double factor, Stiffness& K) {
    for (Square& part : K)
      part.setZero();
    if (mean_)
      add_mean_terms(factor, K);
    for (int q = 0; q < points(); ++q)
      add_point(q, factor * volume(q), K);
  }

private:
  struct Point {
    material::Tensor<Pack> F; ///< identity for small strains
    Pack jacobian;
  };
  [[nodiscard]] static std::size_t at(int q) { return static_cast<std::size_t>(q); }
  [[nodiscard]] Gradients gradients(int q) const {
    return Gradients(&block_.gradients[(ix(number_) * at(points()) + at(q)) * width * Nodes]);
  }
  /// Gradient of the gathered field.
  [[nodiscard]] typename G::Gradient gradient(int q) const {
    typename G::Gradient H = gradients(q).transpose().lazyProduct(field_);
    if constexpr (G::axisymmetric)
      H(2, 1) = 0;
    return H;
  }
  void gather(std::span<double const> field) {
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      Index const* node = connectivity(lane);
      for (int a = 0; a < Nodes; ++a)
        for (int i = 0; i < dim; ++i)
          field_(a, i).set(lane, field[ix(dim * node[a] + i)]);
    }
  }

  /// Plane stress: what a point is stretched by across the sheet.
  void stretch_across() {
    AcrossSheet const across(*block_.law, finite_);
    sound_ = where_positive(across.solve({strains_.data(), at(points())}, {responses_.data(), at(points())}),
                            sound_);
    for (int q = 0; finite_ && q < points(); ++q) {
      points_[at(q)].F(2, 2) = sqrt(1 + 2 * strains_[at(q)][2]);
      points_[at(q)].jacobian *= points_[at(q)].F(2, 2);
    }
  }

  template<material::Wanted wanted> void add_networks() {
    auto const first = ix(number_) * at(points());
    for (int q = 0; q < points() && !networks_->pulls.empty(); ++q) {
      Eigen::Map<Voigt const> const P(&networks_->pulls[(first + at(q)) * voigt]);
      material::add_networks<voigt, wanted>(!finite_, networks_->modulus, Voigt(P), strains_[at(q)],
                                            responses_[at(q)]);
    }
    for (int q = 0; q < points() && !networks_->pressing.empty(); ++q)
      material::add_volume_networks<voigt, wanted>(!finite_, networks_->bulk_modulus,
                                                   networks_->pressing[first + at(q)], strains_[at(q)],
                                                   responses_[at(q)]);
  }

  void relax_shear(Remembered const& memory, int q, material::NetworkEnergy<Pack>& energy) const {
    auto const& steps = memory.steps.shear;
    Voigt V, from;
    std::span<Pack> const numbers(V.data(), voigt);
    RememberedAt place{number_, q, memory.steps.each(voigt), steps.size() * voigt};
    recall(block_, memory.before, place, {from.data(), voigt});
    Voigt const to = material::metric_strain<voigt>(!finite_, strains_[at(q)]);
    keep(block_, memory.after, place, {to.data(), voigt});
    material::MetricMove<voigt, Pack> const move(!finite_, from, to);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      place.skip = k * voigt;
      recall(block_, memory.before, place, numbers);
      move.pass(steps[k], V, energy);
      keep(block_, memory.after, place, numbers);
    }
  }

  void relax_volume(Remembered const& memory, int q, material::NetworkEnergy<Pack>& energy) const {
    auto const& steps = memory.steps.volume;
    auto const first = memory.steps.of_shear(voigt);
    RememberedAt place{number_, q, memory.steps.each(voigt), first + steps.size()};
    Pack a, from;
    recall(block_, memory.before, place, {&from, 1});
    Pack const to = material::volume_strain<voigt>(!finite_, strains_[at(q)]);
    keep(block_, memory.after, place, {&to, 1});
    for (std::size_t k = 0; k < steps.size(); ++k) {
      place.skip = first + k;
      recall(block_, memory.before, place, {&a, 1});
      material::pass_volume(steps[k], from, to, a, energy);
      keep(block_, memory.after, place, {&a, 1});
    }
  }

  void average_dilatation() {
    Pack whole = 0, sum = 0;
    for (int q = 0; q < points(); ++q) {
      Voigt const& E = strains_[at(q)];
      whole += volume(q);
      sum += volume(q) * (finite_ ? points_[at(q)].jacobian : Pack(E.template head<3>().sum()));
    }
    mean_ratio_ = sum / whole;
    mean_volume_ = finite_ ? sum : whole;
    for (int q = 0; q < points(); ++q) {
      dilatations_[at(q)] = Dilatation<voigt>(strains_[at(q)], points_[at(q)].jacobian, finite_);
      strains_[at(q)] = dilatations_[at(q)].mean_strain(strains_[at(q)], mean_ratio_);
    }
  }

  /// Sum over the points of the stress conjugate to tau.
  [[nodiscard]] Pack tau_stress() const {
    Pack sum = 0;
    for (int q = 0; q < points(); ++q)
      sum += volume(q) * dilatations_[at(q)].by_tau(responses_[at(q)].stress);
    return sum;
  }
  /// Turns the stress conjugate to Ebar into the one that B^T S wants.
  void conjugate_stress() {
    Pack const pressure = tau_stress() / mean_volume_;
    for (int q = 0; q < points(); ++q) {
      Voigt& S = responses_[at(q)].stress;
      S = (dilatations_[at(q)].by_strain(S) + pressure * dilatations_[at(q)].volume_gradient()).eval();
    }
  }

  /// f += factor B^T S at a point.
  void add_pulled(int q, Pack const& factor, Voigt const& S, Nodal& f) const {
    for (int i = 0; i < dim; ++i)
      f.col(i) += gradients(q).lazyProduct((factor * G::pull(points_[at(q)].F, i, S)).eval());
  }

  /// Adds the terms of grad tau, and replaces the responses by those that B^T D B + G S G^T wants.
  void add_mean_terms(double factor, Stiffness& K) {
    Pack const conjugate = tau_stress(), pressure = conjugate / mean_volume_;
    Pack by_tau = finite_ ? -conjugate : Pack(0);
    Nodal slope = Nodal::Zero(), mixed = Nodal::Zero(); // grad tau, and what it is paired with
    for (int q = 0; q < points(); ++q) {
      auto const& dilatation = dilatations_[at(q)];
      auto& response = responses_[at(q)];
      auto const second = dilatation.second(response.stress, response.tangent);
      Voigt const volume_gradient = dilatation.volume_gradient();
      by_tau += volume(q) * second.by_tau;
      add_pulled(q, volume(q) / mean_volume_, volume_gradient, slope);
      add_pulled(q, volume(q), second.mixed, mixed);
      response.stress = (dilatation.by_strain(response.stress) + pressure * volume_gradient).eval();
      response.tangent = second.by_strain + pressure * dilatation.volume_hessian();
    }
    mixed += by_tau / 2 * slope;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j <= i; ++j)
        K[at(G::pair(i, j))] += factor * (mixed.col(i).lazyProduct(slope.col(j).transpose()) +
                                          slope.col(i).lazyProduct(mixed.col(j).transpose()));
  }

  /// Adds the share of a point to the blocks between all components.
  void add_point(int q, Pack const& factor, Stiffness& K) const {
    [&]<int... j>(std::integer_sequence<int, j...>) {
      (add_column<j>(q, factor, K, std::make_integer_sequence<int, dim - j>()), ...);
    }
    (std::make_integer_sequence<int, dim>());
  }
  /// K_ij += G (L_i^T D L_j + delta_ij S) G^T for i = j + k, where L_i^T is G::pull.
  template<int j, int... k>
  void add_column(int q, Pack const& factor, Stiffness& K, std::integer_sequence<int, k...>) const {
    auto const& D = responses_[at(q)].tangent;
    Eigen::Matrix<Pack, voigt, G::active(j)> T;
    for (int v = 0; v < voigt; ++v)
      T.row(v) = factor * G::pull(points_[at(q)].F, j, D.col(v)).template head<G::active(j)>();
    (add_block<j + k, j>(q, factor, T, K), ...);
  }
  template<int i, int j, class Pulled>
  void add_block(int q, Pack const& factor, Pulled const& T, Stiffness& K) const {
    constexpr int rows = G::active(i), columns = G::active(j);
    Eigen::Matrix<Pack, rows, columns> A;
    for (int c = 0; c < columns; ++c)
      A.col(c) = G::pull(points_[at(q)].F, i, T.col(c)).template head<rows>();
    if constexpr (i == j)
      if (finite_)
        A += factor * G::initial_stress(responses_[at(q)].stress, i).template topLeftCorner<rows, rows>();
    Gradients const g = gradients(q);
    Eigen::Matrix<Pack, Nodes, columns> const left = g.template leftCols<rows>().lazyProduct(A);
    K[at(G::pair(i, j))] += left.lazyProduct(g.template leftCols<columns>().transpose());
  }

  PreparedBlock const& block_;
  Body const& body_;
  BlockNetworks const* networks_;
  bool finite_, mean_;
  Index number_ = 0;
  Pack sound_ = 1; ///< 0 where det F was not positive at a point
  Nodal field_;
  Pack mean_ratio_ = 1;  ///< theta, or the mean of tr(E) with small strains
  Pack mean_volume_ = 1; ///< theta V, or V with small strains
  std::array<Point, most_points> points_;
  std::array<Voigt, most_points> strains_; ///< what the law sees
  std::array<material::Response<voigt, Pack>, most_points> responses_;
  std::array<Dilatation<voigt>, most_points> dilatations_; ///< only with mean dilatation
};

} // namespace stiction::solid
