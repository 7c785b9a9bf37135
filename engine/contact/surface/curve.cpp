// Spline construction, closest-point projection and path length of a deformable primary surface.
#include "contact/surface/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/surface/search.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

constexpr double corner_angle = 40 * std::numbers::pi / 180;

Vec2 position(std::span<double const> x, Index node) {
  return {x[ix(2 * node)], x[ix(2 * node + 1)]};
}

/// Derivative by arc length at the middle, first or last of three nodes with spacings h1, h2 (a parabola).
Eigen::Vector3d parabola_slope(double h1, double h2, int where) {
  double const sum = h1 + h2;
  if (where == 0)
    return {-(2 * h1 + h2) / (h1 * sum), sum / (h1 * h2), -h1 / (h2 * sum)};
  if (where == 1)
    return {-h2 / (h1 * sum), (h2 - h1) / (h1 * h2), h1 / (h2 * sum)};
  return {h2 / (h1 * sum), -sum / (h1 * h2), (h1 + 2 * h2) / (h2 * sum)};
}

/// Hermite cubics in powers of xi: value at 0, slope at 0, value at 1, slope at 1.
Eigen::Matrix4d hermite() {
  Eigen::Matrix4d h;
  h << 1, 0, -3, 2, 0, 1, -2, 1, 0, 0, 3, -2, 0, 0, -1, 1;
  return h;
}

double turn(Vec2 const& a, Vec2 const& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

/// A smooth run of nodes with the spacing to the next one.
struct Piece {
  Indices nodes;
  bool closed;
  std::vector<double> spacing;
  [[nodiscard]] Index size() const { return static_cast<Index>(nodes.size()); }
  [[nodiscard]] Index wrap(Index i) const { return closed ? (i + size()) % size() : i; }
  [[nodiscard]] double h(Index i) const { return spacing[ix(wrap(i))]; }
};

/// Adds slope(node i) * scale to rows of `coefficients`, whose row k belongs to piece node first + k.
void add_slope(Piece const& piece, Index i, Index first, Eigen::RowVector4d const& scale,
               Eigen::Matrix4d& coefficients) {
  Index centre = i;
  int where = 1;
  if (!piece.closed && i == 0)
    centre = 1, where = 0;
  if (!piece.closed && i == piece.size() - 1)
    centre = i - 1, where = 2;
  Eigen::Vector3d const weights = parabola_slope(piece.h(centre - 1), piece.h(centre), where);
  for (Index k = 0; k < 3; ++k)
    coefficients.row(centre - 1 + k - first) += weights[k] * scale;
}

Segment spline_segment(Piece const& piece, Index i) {
  Segment segment;
  Index first = i - 1; // the four nodes i-1 .. i+2, shifted inside at the ends
  if (!piece.closed)
    first = std::clamp<Index>(first, 0, std::max<Index>(piece.size() - 4, 0));
  segment.count = static_cast<int>(std::min<Index>(4, piece.size()));
  for (int k = 0; k < segment.count; ++k)
    segment.nodes[ix(k)] = piece.nodes[ix(piece.wrap(first + k))];
  Eigen::Matrix4d const H = hermite();
  segment.coefficients.row(i - first) += H.row(0);
  segment.coefficients.row(i + 1 - first) += H.row(2);
  add_slope(piece, i, first, piece.h(i) * H.row(1), segment.coefficients);
  add_slope(piece, piece.closed ? i + 1 : std::min(i + 1, piece.size() - 1), first, piece.h(i) * H.row(3),
            segment.coefficients);
  return segment;
}

Segment straight_segment(Index from, Index to) {
  Segment segment;
  segment.count = 2;
  segment.nodes = {from, to, 0, 0};
  segment.coefficients(0, 0) = 1;
  segment.coefficients(0, 1) = -1;
  segment.coefficients(1, 1) = 1;
  return segment;
}

/// Nodes of the chain where it turns by more than the corner angle.
Indices corners_of(Chain const& chain, Matrix const& reference) {
  auto const n = static_cast<Index>(chain.nodes.size());
  auto direction = [&](Index i) -> Vec2 {
    return reference.row(chain.nodes[ix((i + 1) % n)]) - reference.row(chain.nodes[ix(i)]);
  };
  Indices corners;
  for (Index i = chain.closed ? 0 : 1; i < (chain.closed ? n : n - 1); ++i)
    if (turn(direction((i + n - 1) % n), direction(i)) > corner_angle)
      corners.push_back(i);
  return corners;
}

/// The chain itself if it has no corner, else the open runs between its corners, both ends included.
std::vector<Chain> smooth_runs(Chain const& chain, Matrix const& reference) {
  auto const n = static_cast<Index>(chain.nodes.size());
  auto corners = corners_of(chain, reference);
  if (corners.empty())
    return {chain};
  if (chain.closed) {
    corners.push_back(corners.front() + n);
  } else {
    corners.insert(corners.begin(), 0);
    corners.push_back(n - 1);
  }
  std::vector<Chain> runs(corners.size() - 1);
  for (std::size_t c = 0; c < runs.size(); ++c)
    for (Index i = corners[c]; i <= corners[c + 1]; ++i)
      runs[c].nodes.push_back(chain.nodes[ix(i % n)]);
  return runs;
}

/// How far a point is out of the tangent at a foot, m. At a corner the greater one of its two sides is the
/// gap: beyond the end of a side a point may be below its tangent and outside the body all the same.
double height(Curve const& curve, Vec2 const& point, Foot foot, std::span<double const> x) {
  auto const at = curve.evaluate(foot, x).by_xi;
  auto const& along = at[1];
  Vec2 const d = point - at[0];
  return (along.y() * d.x() - along.x() * d.y()) / along.norm(); // the body lies to the left
}

} // namespace

Curve::Curve(std::vector<Chain> const& chains, Matrix const& reference, Smoothing smoothing) {
  for (auto const& chain : chains) {
    auto const first = static_cast<int>(segments_.size());
    for (auto const& run : smooth_runs(chain, reference))
      add_run(run, reference, smoothing);
    auto const last = static_cast<int>(segments_.size()) - 1;
    double arc = 0;
    for (int s = first; s <= last; ++s) {
      segments_[ix(s)].chain = static_cast<int>(closed_length_.size());
      segments_[ix(s)].arc = arc;
      arc += segments_[ix(s)].length;
      segments_[ix(s)].previous = s > first ? s - 1 : (chain.closed ? last : -1);
      segments_[ix(s)].next = s < last ? s + 1 : (chain.closed ? first : -1);
    }
    closed_length_.push_back(chain.closed ? arc : 0);
  }
  if (!segments_.empty())
    segment_length_ /= static_cast<double>(segments_.size());
}

void Curve::add_run(Chain const& run, Matrix const& reference, Smoothing smoothing) {
  Piece piece{run.nodes, run.closed, {}};
  Index const segments = run.closed ? piece.size() : piece.size() - 1;
  for (Index i = 0; i < segments; ++i) {
    auto const next = piece.nodes[ix((i + 1) % piece.size())];
    piece.spacing.push_back((reference.row(next) - reference.row(piece.nodes[ix(i)])).norm());
    segment_length_ += piece.spacing.back();
  }
  for (Index i = 0; i < segments; ++i) {
    Index const from = piece.nodes[ix(i)], to = piece.nodes[ix((i + 1) % piece.size())];
    segments_.push_back(smoothing == Smoothing::spline && piece.size() >= (run.closed ? 4 : 3)
                            ? spline_segment(piece, i)
                            : straight_segment(from, to));
    segments_.back().ends = {from, to};
    segments_.back().length = piece.spacing[ix(i)];
  }
}

double Curve::reference_distance(Foot from, Foot to) const {
  auto const &a = segments_[ix(from.segment)], &b = segments_[ix(to.segment)];
  if (a.chain != b.chain)
    return std::numeric_limits<double>::infinity();
  double const ahead = std::abs(b.arc + to.xi * b.length - a.arc - from.xi * a.length);
  double const around = closed_length_[ix(a.chain)];
  return around > 0 ? std::min(ahead, std::abs(around - ahead)) : ahead;
}

std::array<Eigen::Vector4d, 4> Curve::shape(Foot foot) const {
  double const s = std::clamp(foot.xi, 0.0, 1.0), beyond = foot.xi - s;
  auto const& C = segments_[ix(foot.segment)].coefficients;
  if (beyond != 0) { // on the tangent at the end
    Eigen::Vector4d const along = C * Eigen::Vector4d(0, 1, 2 * s, 3 * s * s);
    return {C * Eigen::Vector4d(1, s, s * s, s * s * s) + beyond * along, along, Eigen::Vector4d::Zero(),
            Eigen::Vector4d::Zero()};
  }
  return {C * Eigen::Vector4d(1, s, s * s, s * s * s), C * Eigen::Vector4d(0, 1, 2 * s, 3 * s * s),
          C * Eigen::Vector4d(0, 0, 2, 6 * s), C * Eigen::Vector4d(0, 0, 0, 6)};
}

CurvePoint Curve::evaluate(Foot foot, std::span<double const> x) const {
  auto const& segment = segments_[ix(foot.segment)];
  auto const N = shape(foot);
  CurvePoint point;
  for (std::size_t d = 0; d < 4; ++d) {
    point.by_xi[d].setZero();
    for (int k = 0; k < segment.count; ++k)
      point.by_xi[d] += N[d][k] * contact::position(x, segment.nodes[ix(k)]);
  }
  return point;
}

Foot Curve::nearest_start(Vec2 const& point, std::span<double const> x) const {
  Foot best;
  double least = std::numeric_limits<double>::infinity();
  for (int s = 0; s < size(); ++s) {
    double distance2 = 0;
    Foot const foot = sample(s, point, x, distance2);
    if (distance2 < least) {
      least = distance2;
      best = foot;
    }
  }
  return best;
}

Foot Curve::sample(int segment, Vec2 const& point, std::span<double const> x, double& distance2) const {
  auto const& ends = segments_[ix(segment)].ends;
  Vec2 const from = contact::position(x, ends[0]), chord = contact::position(x, ends[1]) - from;
  double const length2 = chord.squaredNorm();
  Foot const foot{segment, length2 > 0 ? std::clamp(chord.dot(point - from) / length2, 0.0, 1.0) : 0.5};
  distance2 = (evaluate(foot, x).by_xi[0] - point).squaredNorm();
  return foot;
}

Box<2> Curve::box(int segment, std::span<double const> x) const {
  Vec2 const start = evaluate({segment, 0}, x).by_xi[0];
  Box<2> box{start, start};
  for (double const xi : {0.25, 0.5, 0.75, 1.0}) {
    Vec2 const at = evaluate({segment, xi}, x).by_xi[0];
    box.low = box.low.cwiseMin(at);
    box.high = box.high.cwiseMax(at);
  }
  return box;
}

Foot Curve::project(Vec2 const& point, Foot guess, std::span<double const> x, Search<2> const* search) const {
  if (search != nullptr)
    return search->project(-1, point, guess, x);
  Foot const start = guess.found() ? guess : nearest_start(point, x);
  return start.found() ? follow(point, start, x) : Foot{};
}

Foot Curve::follow(Vec2 const& point, Foot start, std::span<double const> x, Overhang overhang) const {
  double const over = reaches(overhang); // an open end, in parts of a segment
  Foot foot = start;
  int turns = 0, heading = 0; // how often the walk across segments has turned back; its last direction
  for (int iteration = 0; iteration < 200; ++iteration) {
    auto const [c, a, aa, aaa] = evaluate(foot, x).by_xi;
    Vec2 const d = point - c;
    double const slope = a.squaredNorm() - d.dot(aa);
    double const step = std::clamp(d.dot(a) / (slope > 0 ? slope : a.squaredNorm()), -1.0, 1.0);
    double const target = foot.xi + step;
    auto const& segment = segments_[ix(foot.segment)];
    double const low = segment.previous < 0 ? -over : 0, high = segment.next < 0 ? 1 + over : 1;
    bool const beyond = target > high || target < low;
    int const towards = target > high ? 1 : -1;
    int const neighbour = target > high ? segment.next : segment.previous;
    if (!beyond) {
      foot.xi = target;
      double const size = std::abs(step);
      bool const rounded = iteration > 20 && size < rounding_step(point.cwiseAbs().maxCoeff(), a.norm());
      if (size < 1e-13 || rounded) // far from the origin it falls no further
        return foot;
    } else if (neighbour < 0) {
      if (foot.xi == low || foot.xi == high)
        return {}; // beyond the end of the curve
      foot.xi = target > high ? high : low;
    } else if ((turns += towards == -heading ? 1 : 0) > 8 && (foot.xi == 0 || foot.xi == 1)) {
      Foot const other{neighbour, 1 - foot.xi}; // a corner: the vertex itself is nearest
      return height(*this, point, foot, x) < height(*this, point, other, x) ? other : foot;
    } else if (foot.xi == (target > 1 ? 1.0 : 0.0) || turns < 4) {
      foot = {neighbour, target > 1 ? 0.0 : 1.0};
      heading = towards;
    } else {
      foot.xi = target > 1 ? 1 : 0;
    }
  }
  return foot;
}

double Curve::partial_length(int segment, double from, double to, std::span<double const> x) const {
  static constexpr std::array<double, 3> points{0.1127016653792583, 0.5, 0.8872983346207417};
  static constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};
  double length = 0;
  for (std::size_t q = 0; q < 3; ++q)
    length += weights[q] * evaluate({segment, from + (to - from) * points[q]}, x).by_xi[1].norm();
  return length * (to - from);
}

double Curve::path_length(Foot from, Foot to, std::span<double const> x) const {
  if (from.segment == to.segment)
    return partial_length(from.segment, from.xi, to.xi, x);
  // walk both ways at once: the shorter way is taken on closed curves
  double ahead = partial_length(from.segment, from.xi, 1, x),
         behind = partial_length(from.segment, from.xi, 0, x);
  int forward = segments_[ix(from.segment)].next;
  int backward = segments_[ix(from.segment)].previous;
  for (std::size_t walked = 0; walked < segments_.size(); ++walked) {
    if (forward == to.segment)
      return ahead + partial_length(to.segment, 0, to.xi, x);
    if (backward == to.segment)
      return behind + partial_length(to.segment, 1, to.xi, x);
    if (forward >= 0) {
      ahead += partial_length(forward, 0, 1, x);
      forward = segments_[ix(forward)].next;
    }
    if (backward >= 0) {
      behind += partial_length(backward, 1, 0, x);
      backward = segments_[ix(backward)].previous;
    }
  }
  return 0; // different chains: no path, the point has jumped and starts anew
}

} // namespace stiction::contact
