// Mortar contact of one pair: points at the corner nodes of the secondary, whose gap, slip and rows are means
// over quadrature samples, weighted by the hats of the corners.
#pragma once
#include <optional>

#include "contact/mortar/mortar_cut.hpp"

namespace stiction::contact {

/// What a mortar pair is besides its surfaces.
struct MortarSettings {
  Indices points;      ///< corner nodes of the secondary, in the order of the contact points
  double reach = 0;    ///< as of the pair, m
  bool around = false; ///< areas of full turns about x = 0
  bool bonded = false; ///< is there adhesion, whose bonds turn with the primary?
};

/// Stiffness over some nodes, [D nodes, D nodes], N/m.
struct NodalStiffness {
  Indices nodes;
  Dense K;
};

/// Rows over some nodes, [D, D nodes].
template<int D> struct NodalRows {
  Indices nodes;
  Rows<D> rows;
};

/// A growing list of nodes with the slot of each in it.
class Slots {
public:
  explicit Slots(std::size_t nodes) : slot_(nodes, -1) {}
  Index operator()(Index node) {
    if (slot_[ix(node)] < 0) {
      slot_[ix(node)] = static_cast<Index>(nodes_.size());
      nodes_.push_back(node);
    }
    return slot_[ix(node)];
  }
  [[nodiscard]] Indices const& nodes() const { return nodes_; }

private:
  std::vector<Index> slot_;
  Indices nodes_;
};

/// x_A = sum_s c_As x_s with c_As = w_s Phi_A(s) / A_A; the force on sample s is sum_A c_As p_A. The samples
/// are chosen at the start of a step and then are fixed material points of the secondary surface.
template<int D> class Mortar {
public:
  /// Surfaces must outlive this. primary: none if it is an obstacle.
  Mortar(CellSurface const& secondary, CellSurface const* primary, MortarSettings settings);

  /// Cuts the secondary and pairs its samples at x, the positions at the step's start; obstacle: where it is
  /// then, if the primary is one; tangents: of the points in the obstacle's frame, whose means take the place
  /// of its direction, [points] (3D).
  void begin(Positions x, PosedObstacle<D> const* obstacle, std::vector<Vec3> const& tangents = {});
  /// Pairs the samples at x and takes the means.
  void locate(Positions x, PosedObstacle<D> const* obstacle);

  /// Reference area that faces the counterpart at the step's start, m^2 (m in plane strain).
  [[nodiscard]] double area(Index point) const { return points_[ix(point)].area; }
  /// Columns of H without order; foot: that of the sample that counts most; frame: its.
  [[nodiscard]] PointKinematics<D> const& point(Index point) const { return points_[ix(point)].kinematics; }
  /// Beyond this nothing is found, m.
  [[nodiscard]] double radius() const { return range_.high; }
  [[nodiscard]] std::size_t sample_count() const { return samples_.size(); }
  /// By how much the derivatives of the point's gap and slip differ from its H; not against obstacles in the
  /// plane, where they do not.
  [[nodiscard]] NodalRows<D> change(Index point, Positions x) const;
  /// Derivative of H^T forces at fixed forces [points], at the positions of the last `locate`.
  [[nodiscard]] NodalStiffness stiffness(std::vector<Local<D>> const& forces, Positions x) const;

private:
  struct PointMean {
    double area = 0, share = 0; ///< at the step's start; that the samples found now stand for, m^2
    double heaviest = 0;
    PointKinematics<D> kinematics;
    std::vector<Mat<D>> columns; ///< of H, node by node
    /// That of a node, a new one of zeros where it has none.
    [[nodiscard]] Mat<D>& column_of(Index node);
  };
  /// Rows of one sample over its nodes.
  struct RowsOfSample {
    Indices nodes;
    Rows<D> H;
  };
  void cut(Positions x);
  void cover();
  [[nodiscard]] std::vector<int> candidates(int facet, Positions x) const;
  [[nodiscard]] SamplePairing<D> pair(Sample const& sample, Foot guess, Positions x) const;
  [[nodiscard]] PointKinematics<D> against_obstacle(Sample const& sample, Foot guess, Positions x) const;
  void find_normals(Positions x);
  void find_tangents(std::vector<Vec3> const& tangents);
  [[nodiscard]] PosedObstacle<D> obstacle_of(Sample const& sample) const;
  [[nodiscard]] SampleMotion<D> const& motion_of(std::size_t s, Positions x) const;
  [[nodiscard]] double part(std::size_t s, Index point) const;
  [[nodiscard]] RowsOfSample beyond(std::size_t s, Positions x) const;
  [[nodiscard]] Dense spread(Sample const& sample, PointKinematics<D> const& seen, Indices& nodes) const;
  [[nodiscard]] RowsOfSample rows(std::size_t s, Positions x) const;
  [[nodiscard]] SampleStiffness<D> stiffness_of(std::size_t s, Local<D> const& force, Positions x) const;
  [[nodiscard]] Slots touched(std::vector<std::size_t> const& samples, Positions x) const;
  void add_by_fans(Dense const& by_fans, Slots& slot, Dense& K, Positions x) const;
  void share(std::size_t s);
  void add_mean(std::size_t s);
  template<class Act> void each_sample(Act const& act);
  [[nodiscard]] Local<D> force_on(std::size_t s, std::vector<Local<D>> const& forces) const;
  [[nodiscard]] double hat_area(std::size_t s, int corner) const {
    return samples_[s].area * samples_[s].hats[corner];
  }
  [[nodiscard]] int point_of(int facet, int corner) const { return points_of_[ix(facet)][ix(corner)]; }
  [[nodiscard]] Faced<D> faced(Positions x) const { return {*secondary_, *primary_, x, normals_, opposite_}; }

  CellSurface const* secondary_;
  CellSurface const* primary_;
  bool around_, bonded_;
  GapRange range_;
  std::vector<std::array<int, 4>> points_of_; ///< contact points at the corners of every facet
  std::vector<double> hat_areas_;
  Grid<D> grid_;                     ///< of the primary's facets
  FanNormals<D> normals_, opposite_; ///< of the secondary and of the primary
  std::optional<PosedObstacle<D>> obstacle_;
  std::vector<Sample> samples_;
  std::vector<SamplePairing<D>> pairings_; ///< [samples]
  std::vector<RowsOfSample> rows_;         ///< [samples], of those that found something
  std::vector<PointMean> points_;
  std::vector<std::vector<std::size_t>> samples_of_;            ///< [points], those with a hat there
  mutable std::vector<std::optional<SampleMotion<D>>> motions_; ///< [samples], once asked for
};

} // namespace stiction::contact
