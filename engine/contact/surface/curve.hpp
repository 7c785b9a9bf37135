// The primary side in the plane: a C1 spline (or polyline) through the nodes of a contact surface.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "contact/surface/grid.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::contact {

template<int D> class Search;

/// Nodes of a contact surface in walking order, the body to the left. Several chains if the set is in pieces.
struct Chain {
  Indices nodes;
  bool closed = false; ///< the last node is followed by the first
};

/// Orders the facets of a set into chains; mid-side nodes become chain nodes. Throws InputError if facets
/// branch or disagree in orientation.
[[nodiscard]] std::vector<Chain> chains_of(mesh::Set const& set, std::string const& name);

/// How the surface runs between its nodes.
enum class Smoothing { spline, polyline };

/// x(xi) = sum_k N_k(xi) x_k on 0 <= xi <= 1, N_k(xi) = sum_j coefficients(k, j) xi^j.
struct Segment {
  std::array<Index, 4> nodes{};
  int count = 0;
  Eigen::Matrix4d coefficients = Eigen::Matrix4d::Zero();
  int previous = -1, next = -1; ///< neighbouring segments, -1 at an end
  std::array<Index, 2> ends{};  ///< its first and last node
  int chain = 0;
  double arc = 0, length = 0; ///< where it starts along its chain and how long it is, in the reference, m
};

/// The curve and its derivatives by xi at one foot.
struct CurvePoint {
  std::array<Vec2, 4> by_xi; ///< x, x', x'', x'''
};

/// A deformable primary surface.
class Curve {
public:
  /// reference: coordinates of all nodes of the model, [nodes, 2]. Chains are broken into smooth pieces
  /// where they turn by more than 40 degrees.
  Curve(std::vector<Chain> const& chains, Matrix const& reference, Smoothing smoothing);

  [[nodiscard]] std::vector<Segment> const& segments() const { return segments_; }
  [[nodiscard]] CurvePoint evaluate(Foot foot, std::span<double const> x) const;
  [[nodiscard]] Vec2 position(Foot foot, std::span<double const> x) const {
    return evaluate(foot, x).by_xi[0];
  }
  /// Shape functions N, N', N'', N''' at xi; [4 nodes].
  [[nodiscard]] std::array<Eigen::Vector4d, 4> shape(Foot foot) const;

  /// Nearest foot to `point`, starting from `guess` and walking along the curve; from scratch if it has none,
  /// among all segments or those that `search` finds.
  /// Not found when the point lies beyond an end of the curve. x[2 * nodes]: current positions.
  [[nodiscard]] Foot project(Vec2 const& point, Foot guess, std::span<double const> x,
                             Search<2> const* search = nullptr) const;
  /// The same from `start` alone.
  [[nodiscard]] Foot follow(Vec2 const& point, Foot start, std::span<double const> x,
                            Overhang overhang = Overhang::found) const;
  /// A foot near the nearest one, by looking at all segments.
  [[nodiscard]] Foot nearest_start(Vec2 const& point, std::span<double const> x) const;
  /// The nearest foot on one segment, as if it were straight; `distance2`: squared distance, m^2.
  [[nodiscard]] Foot sample(int segment, Vec2 const& point, std::span<double const> x,
                            double& distance2) const;
  [[nodiscard]] Box<2> box(int segment, std::span<double const> x) const;

  /// Signed length along the current curve from one foot to another, positive in walking direction.
  [[nodiscard]] double path_length(Foot from, Foot to, std::span<double const> x) const;
  [[nodiscard]] int size() const { return static_cast<int>(segments_.size()); }
  /// Reference length along the curve between two feet, the shorter way if closed; infinite between chains,
  /// m.
  [[nodiscard]] double reference_distance(Foot from, Foot to) const;
  /// Mean reference length of the segments, m.
  [[nodiscard]] double segment_length() const { return segment_length_; }

private:
  void add_run(Chain const& run, Matrix const& reference, Smoothing smoothing);
  [[nodiscard]] double partial_length(int segment, double from, double to, std::span<double const> x) const;

  std::vector<Segment> segments_;
  std::vector<double> closed_length_; ///< of every chain, reference, m; 0 if open
  double segment_length_ = 0;
};

} // namespace stiction::contact
