// Quadrature points of four cells in deformed state, side by side: strain, and the law's response. The same
// for any number of nodes.
#pragma once
#include <array>
#include <utility>

#include "solid/block.hpp"
#include "solid/dilatation.hpp"
#include "solid/geometry.hpp"
#include "solid/sheet.hpp"

namespace stiction::solid {

/// The points of one group of a block's cells after the other. What lanes say that no cell is left for is
/// that of the last one.
template<Kinematics kinematics> class CellPoints {
public:
  using G = Geometry<kinematics>;
  static constexpr int dim = G::dim, voigt = G::voigt, width = G::width;
  static constexpr bool plane = kinematics == Kinematics::plane_strain;
  using Voigt = material::Voigt<voigt, Pack>;

  explicit CellPoints(Deformed const& at)
      : block_(at.block), body_(at.body), networks_(at.networks), finite_(!small_strain(*at.block.law)),
        mean_(at.body.interpolation == Interpolation::mean_dilatation) {}

  /// How many lanes have a cell of their own.
  [[nodiscard]] int cells() const { return block_.cells_in(number_); }
  [[nodiscard]] int points() const { return block_.points; }
  [[nodiscard]] Pack const& volume(int q) const { return block_.volumes[ix(number_ * points() + q)]; }
  /// Had the cell in this lane det F > 0 at all points?
  [[nodiscard]] bool sound(int lane) const { return sound_[lane] > 0; }

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

protected:
  struct Point {
    material::Tensor<Pack> F; ///< identity for small strains
    Pack jacobian;
  };
  [[nodiscard]] static std::size_t at(int q) { return static_cast<std::size_t>(q); }

  void begin(Index number) {
    number_ = number;
    sound_ = 1;
  }
  /// Takes the displacement gradient of a point.
  void deform_point(int q, typename G::Gradient const& H) {
    Point& point = points_[at(q)];
    strains_[at(q)] = G::strain(H, finite_ ? 0.5 : 0.0);
    point.F.setIdentity();
    point.jacobian = 1;
    if (finite_) {
      point.F = G::deformation(H);
      point.jacobian = G::jacobian(point.F);
      sound_ = where_positive(point.jacobian, sound_);
    }
  }
  /// After all points: what they have in common; the lane of the first cell that is not sound, or -1.
  int end_deform() {
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

  /// The viscous response to the strain rates that stand in for the strains; the power it dissipates.
  Pack flow_at_points() {
    auto const D = body_.damping->viscosity<voigt>().template cast<Pack>().eval();
    Pack tau_rate = 0, power = 0;
    for (int q = 0; q < points() && mean_; ++q)
      tau_rate += volume(q) / mean_volume_ * dilatations_[at(q)].volume_gradient().dot(strains_[at(q)]);
    for (int q = 0; q < points(); ++q) {
      Voigt const rate = mean_ ? dilatations_[at(q)].mean_rate(strains_[at(q)], tau_rate) : strains_[at(q)];
      responses_[at(q)].stress.noalias() = D * rate;
      power += volume(q) * rate.dot(responses_[at(q)].stress);
    }
    return power;
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

  /// What a point adds to the terms of grad tau: a stress that goes with it, and by tau twice.
  struct MeanTerms {
    Voigt mixed;
    Pack by_tau;
  };
  /// Replaces the response of a point by the one that B^T D B + G S G^T wants.
  MeanTerms take_mean_terms(int q, Pack const& pressure) {
    auto const& dilatation = dilatations_[at(q)];
    auto& response = responses_[at(q)];
    auto const second = dilatation.second(response.stress, response.tangent);
    response.stress =
        (dilatation.by_strain(response.stress) + pressure * dilatation.volume_gradient()).eval();
    response.tangent = second.by_strain + pressure * dilatation.volume_hessian();
    return {second.mixed, second.by_tau};
  }

  /// factor D L_j of a point, where L_j^T is G::pull.
  template<int j>
  [[nodiscard]] Eigen::Matrix<Pack, voigt, G::active(j)> pulled_tangent(int q, Pack const& factor) const {
    auto const& D = responses_[at(q)].tangent;
    Eigen::Matrix<Pack, voigt, G::active(j)> T;
    for (int v = 0; v < voigt; ++v) {
      Voigt const column = D.col(v);
      auto const pulled = G::pull(points_[at(q)].F, j, column);
      for (int r = 0; r < G::active(j); ++r)
        T(v, r) = factor * pulled[r];
    }
    return T;
  }
  /// L_i^T T + delta_ij factor S.
  template<int i, int j>
  [[nodiscard]] Eigen::Matrix<Pack, G::active(i), G::active(j)>
  between(int q, Pack const& factor, Eigen::Matrix<Pack, voigt, G::active(j)> const& T) const {
    Eigen::Matrix<Pack, G::active(i), G::active(j)> A;
    for (int c = 0; c < G::active(j); ++c) {
      Voigt const column = T.col(c);
      auto const pulled = G::pull(points_[at(q)].F, i, column);
      for (int r = 0; r < G::active(i); ++r)
        A(r, c) = pulled[r];
    }
    if constexpr (i == j)
      if (finite_) {
        auto const S = G::initial_stress(responses_[at(q)].stress, i);
        for (int c = 0; c < G::active(j); ++c)
          for (int r = 0; r < G::active(i); ++r)
            A(r, c) += factor * S(r, c);
      }
    return A;
  }

  PreparedBlock const& block_;
  Body const& body_;
  BlockNetworks const* networks_;
  bool finite_, mean_;
  Index number_ = 0;
  Pack sound_ = 1;       ///< 0 where det F was not positive at a point
  Pack mean_ratio_ = 1;  ///< theta, or the mean of tr(E) with small strains
  Pack mean_volume_ = 1; ///< theta V, or V with small strains
  std::array<Point, most_points> points_;
  std::array<Voigt, most_points> strains_; ///< what the law sees
  std::array<material::Response<voigt, Pack>, most_points> responses_;
  std::array<Dilatation<voigt>, most_points> dilatations_; ///< only with mean dilatation

private:
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
};

} // namespace stiction::solid
