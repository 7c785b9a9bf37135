// Four cells in deformed state, side by side: force and stiffness, all of fixed size.
#pragma once
#include "solid/points.hpp"

namespace stiction::solid {

/// Numbers of four cells by node and column, node after node of each column. Loops over them compile in a
/// fraction of the time of matrices' expressions, which every number of nodes would have of its own.
template<int Rows, int Columns> struct Packs {
  std::array<Pack, static_cast<std::size_t>(Rows) * Columns> numbers;
  [[nodiscard]] Pack& operator()(int row, int column) { return numbers[ix(column * Rows + row)]; }
  [[nodiscard]] Pack const& operator()(int row, int column) const { return numbers[ix(column * Rows + row)]; }
};

/// One group of a block's cells after the other. Call deform, then respond or flow, then what is wanted.
template<Kinematics kinematics, int Nodes> class CellGroup : public CellPoints<kinematics> {
  using Points = CellPoints<kinematics>;
  using Points::at, Points::block_, Points::dilatations_, Points::finite_, Points::mean_,
      Points::mean_volume_, Points::number_, Points::points_, Points::responses_, Points::strains_;

public:
  using Points::dim, Points::points, Points::volume, Points::voigt, Points::width;
  using typename Points::G, typename Points::Voigt;
  static constexpr int nodes = Nodes;
  using Nodal = Packs<Nodes, dim>;
  using Gradients = Packs<Nodes, width>;
  using Square = Packs<Nodes, Nodes>;
  /// Between components i >= j, lower ones by symmetry; where i = j of nodes a >= b alone.
  using Stiffness = std::array<Square, G::pairs>;

  explicit CellGroup(Deformed const& deformed) : Points(deformed) {}

  /// Of the cell in a lane.
  [[nodiscard]] Index const* connectivity(int lane) const {
    return &block_.connectivity[ix(block_.cell(number_, lane) * nodes)];
  }

  /// Takes the displacements of group `number`; the lane of the first cell with det F <= 0 at a point, or
  /// where plane stress finds no stretch across, or -1.
  int deform(Index number, std::span<double const> u) {
    this->begin(number);
    gather(u);
    for (int q = 0; q < points(); ++q)
      this->deform_point(q, gradient(q));
    return this->end_deform();
  }

  /// The viscous response to velocities v at every point; the power it dissipates.
  Pack flow(std::span<double const> v) {
    gather(v);
    for (int q = 0; q < points(); ++q)
      strains_[at(q)] = G::strain_rate(points_[at(q)].F, gradient(q));
    return this->flow_at_points();
  }

  /// int B^T S per node and component.
  [[nodiscard]] Nodal force() {
    if (mean_)
      this->conjugate_stress();
    Nodal f;
    f.numbers.fill(0);
    for (int q = 0; q < points(); ++q)
      add_pulled(q, volume(q), responses_[at(q)].stress, f);
    return f;
  }

  /// factor * int B^T D B + G S G^T, (41), and with mean dilatation the terms of theta.
  void stiffness(double factor, Stiffness& K) {
    for (Square& part : K)
      part.numbers.fill(0);
    if (mean_)
      add_mean_terms(factor, K);
    for (int q = 0; q < points(); ++q)
      add_point(q, factor * volume(q), K);
  }

private:
  [[nodiscard]] Gradients const& gradients(int q) const {
    static_assert(sizeof(Gradients) == sizeof(Pack) * Nodes * width);
    return reinterpret_cast<Gradients const&>(
        block_.gradients[(ix(number_) * at(points()) + at(q)) * width * Nodes]);
  }
  /// Gradient of the gathered field.
  [[nodiscard]] typename G::Gradient gradient(int q) const {
    Gradients const& g = gradients(q);
    typename G::Gradient H;
    for (int i = 0; i < dim; ++i)
      for (int r = 0; r < width; ++r) {
        H(r, i) = g(0, r) * field_(0, i);
        for (int a = 1; a < Nodes; ++a)
          H(r, i) += g(a, r) * field_(a, i);
      }
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

  /// f += factor B^T S at a point.
  void add_pulled(int q, Pack const& factor, Voigt const& S, Nodal& f) const {
    Gradients const& g = gradients(q);
    for (int i = 0; i < dim; ++i) {
      auto const pulled = G::pull(points_[at(q)].F, i, S);
      for (int r = 0; r < G::active(i); ++r) {
        Pack const P = factor * pulled[r];
        for (int a = 0; a < Nodes; ++a)
          f(a, i) += g(a, r) * P;
      }
    }
  }

  /// Adds the terms of grad tau, and replaces the responses by those that B^T D B + G S G^T wants.
  void add_mean_terms(double factor, Stiffness& K) {
    Pack const conjugate = this->tau_stress(), pressure = conjugate / mean_volume_;
    Pack by_tau = finite_ ? -conjugate : Pack(0);
    Nodal slope, mixed; // grad tau, and what it is paired with
    slope.numbers.fill(0);
    mixed.numbers.fill(0);
    for (int q = 0; q < points(); ++q) {
      auto const terms = this->take_mean_terms(q, pressure);
      by_tau += volume(q) * terms.by_tau;
      add_pulled(q, volume(q) / mean_volume_, dilatations_[at(q)].volume_gradient(), slope);
      add_pulled(q, volume(q), terms.mixed, mixed);
    }
    for (std::size_t k = 0; k < mixed.numbers.size(); ++k)
      mixed.numbers[k] += by_tau / 2 * slope.numbers[k];
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j <= i; ++j)
        for (int b = 0; b < Nodes; ++b)
          for (int a = 0; a < Nodes; ++a)
            K[at(G::pair(i, j))](a, b) += factor * (mixed(a, i) * slope(b, j) + slope(a, i) * mixed(b, j));
  }

  /// Adds the share of a point to the blocks between all components.
  void add_point(int q, Pack const& factor, Stiffness& K) const {
    [&]<int... j>(std::integer_sequence<int, j...>) {
      (add_column<j>(q, factor, K, std::make_integer_sequence<int, dim - j>()), ...);
    }
    (std::make_integer_sequence<int, dim>());
  }
  /// K_ij += G (L_i^T D L_j + delta_ij S) G^T for i = j + k.
  template<int j, int... k>
  void add_column(int q, Pack const& factor, Stiffness& K, std::integer_sequence<int, k...>) const {
    auto const T = this->template pulled_tangent<j>(q, factor);
    (add_block<k == 0>(gradients(q), this->template between<j + k, j>(q, factor, T),
                       K[at(G::pair(j + k, j))]),
     ...);
  }
  /// symmetric: its lower triangle alone.
  template<bool symmetric, class Between>
  static void add_block(Gradients const& g, Between const& A, Square& K) {
    Packs<Nodes, Between::ColsAtCompileTime> left;
    for (int c = 0; c < A.cols(); ++c)
      for (int a = 0; a < Nodes; ++a) {
        left(a, c) = g(a, 0) * A(0, c);
        for (int r = 1; r < A.rows(); ++r)
          left(a, c) += g(a, r) * A(r, c);
      }
    for (int b = 0; b < Nodes; ++b)
      for (int a = symmetric ? b : 0; a < Nodes; ++a) {
        Pack sum = left(a, 0) * g(b, 0);
        for (int c = 1; c < A.cols(); ++c)
          sum += left(a, c) * g(b, c);
        K(a, b) += sum;
      }
  }

  Nodal field_;
};

} // namespace stiction::solid
