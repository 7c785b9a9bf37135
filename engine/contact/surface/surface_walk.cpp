// Finding the foot on a surface in space: Newton steps from facet to facet, and what happens at edges.
#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "contact/surface/search.hpp"
#include "contact/surface/surface.hpp"

namespace stiction::contact {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Exit {
  int side = -1;
  double part = 1; ///< of the step, up to the side
};

class FacetWalk {
public:
  FacetWalk(Surface const& surface, Vec3 const& point, std::span<double const> x, Overhang overhang)
      : surface_(&surface), point_(point), x_(x), overhang_(reaches(overhang)),
        rounding_(rounding_step(point.cwiseAbs().maxCoeff(), surface.facet_size())) {}

  Foot from(Foot const& start) {
    enter(start.segment, {start.xi, start.eta});
    double last = infinite;
    for (int iteration = 0; iteration < 80; ++iteration) {
      Vec2 const step = aim();
      double const size = step.norm();
      auto const exit = first_exit(step, -1);
      if (exit.side < 0) {
        at_ += step;
        if (size < 1e-13 || (size < rounding_ && size > 0.5 * last))
          return face();
      } else if (facet().neighbour[ix(exit.side)] < 0) {
        if (!follow_border(step, exit))
          return {};
      } else {
        at_ += exit.part * step;
        if (!cross(exit.side))
          return settle();
      }
      last = size;
    }
    return settle();
  }

private:
  [[nodiscard]] Facet const& facet() const { return surface_->facets()[ix(number_)]; }
  [[nodiscard]] Foot face() const { return {number_, at_.x(), at_.y()}; }

  void enter(int number, Vec2 const& at) {
    number_ = number;
    at_ = at;
    now_ = surface_->now(number, x_);
  }

  /// One Newton step for x2 + g n = point in (xi, eta); g is the normal part of the distance. Where the field
  /// of normals focuses, its turning is left out.
  [[nodiscard]] Vec2 aim() const {
    int const count = facet().count;
    auto const N = shape(count, at_.x(), at_.y());
    Vec3 const sum = combine<double>(N.N, now_.normals, count), n = sum.normalized();
    auto const turn = [&](std::array<double, 4> const& by) -> Vec3 {
      Vec3 const change = combine<double>(by, now_.normals, count);
      return (change - n * n.dot(change)) / sum.norm();
    };
    Vec3 const d = point_ - combine<double>(N.N, now_.x, count);
    double const gap = n.dot(d);
    Matrix3 flat, J;
    flat << combine<double>(N.by_xi, now_.x, count), combine<double>(N.by_eta, now_.x, count), n;
    J << flat.col(0) + gap * turn(N.by_xi), flat.col(1) + gap * turn(N.by_eta), n;
    double const size = flat.determinant();
    bool const focused = J.determinant() < 0.2 * size;
    Vec3 const solution = (focused ? flat : J).inverse() * (d - gap * n);
    double const length = solution.head<2>().norm(), most = count == 3 ? 1 : 2;
    if (!std::isfinite(length))
      return Vec2::Zero();
    return solution.head<2>() * (length > most ? most / length : 1.0);
  }

  [[nodiscard]] Exit first_exit(Vec2 const& step, int skip) const {
    Exit exit;
    for (int k = 0; k < facet().count; ++k) {
      bool const border = facet().neighbour[ix(k)] < 0;
      double const here = inside(facet().count, k, at_), there = inside(facet().count, k, at_ + step);
      if (k == skip || there >= here || there >= (border ? -overhang_ : -on_side))
        continue;
      double const part = std::clamp((here + (border ? overhang_ : 0)) / (here - there), 0.0, 1.0);
      if (exit.side < 0 || part < exit.part)
        exit = {k, part};
    }
    return exit;
  }

  /// Goes over to the neighbour. False if edges have been crossed to and fro.
  bool cross(int side) {
    auto const& from = facet();
    if (from.sharp[ix(side)] && ++edges_crossed_ > 3)
      return false;
    double const part = std::clamp(side_part(from.count, side, at_), -overhang_, 1 + overhang_);
    int const other = from.neighbour[ix(side)], across = from.across[ix(side)];
    enter(other, side_coordinates(surface_->facets()[ix(other)].count, across, 1 - part));
    return true;
  }

  /// To the border and on along it. False if nothing is left to go: the point is beyond.
  bool follow_border(Vec2 const& step, Exit const& exit) {
    at_ += exit.part * step;
    if (exit.part * step.norm() > 1e-12)
      return true;
    int const count = facet().count;
    Vec2 const along =
        (node_coordinates(count, (exit.side + 1) % count) - node_coordinates(count, exit.side)).normalized();
    Vec2 const slide = along * along.dot(step);
    auto const next = first_exit(slide, exit.side);
    at_ += next.part * slide;
    if (next.side >= 0 && facet().neighbour[ix(next.side)] >= 0)
      return cross(next.side);
    return next.part * slide.norm() > 1e-9;
  }

  struct Settled {
    Foot foot;
    double distance = infinite, facing = 0;
  };

  /// Newton's method in facet `number` alone.
  Settled settle_inside(int number) {
    int const count = surface_->facets()[ix(number)].count;
    enter(number, count == 3 ? Vec2(1.0 / 3, 1.0 / 3) : Vec2(0, 0));
    double size = 1;
    for (int iteration = 0; iteration < 30 && size > 1e-13 && at_.norm() < 4; ++iteration) {
      Vec2 const step = aim();
      size = step.norm();
      at_ += step;
    }
    for (int k = 0; k < count; ++k)
      if (!(size < rounding_) ||
          inside(count, k, at_) < (facet().neighbour[ix(k)] < 0 ? -overhang_ : -on_side))
        return {};
    return {face(), (point_ - surface_->position(face(), x_)).norm(), 1};
  }

  /// The nearest point of a sharp side of the present facet.
  Settled settle_on_edge(int side) const {
    int const count = facet().count, last = (side + 1) % count;
    Vec3 const from = now_.x[ix(side)], along = now_.x[ix(last)] - from;
    double const part = (point_ - from).dot(along) / along.squaredNorm();
    double const inner = std::clamp(part, 0.0, 1.0);
    int const node = part <= 0 ? side : last;
    bool const at_node = part <= 0 || part >= 1;
    if (at_node && (part < -overhang_ || part > 1 + overhang_) && at_border(facet().nodes[ix(node)]))
      return {};
    Vec2 const at = side_coordinates(count, side, inner);
    FootFeature const kind{at_node ? FootFeature::vertex : FootFeature::edge, at_node ? node : side};
    Vec3 const d = point_ - (from + inner * along);
    double const facing = std::abs(d.dot(area_vector(now_.x, count).normalized()));
    return {{number_, at.x(), at.y(), kind.code()}, d.norm(), facing};
  }

  [[nodiscard]] bool at_border(Index node) const {
    for (int const f : surface_->around(number_)) {
      auto const& other = surface_->facets()[ix(f)];
      for (int k = 0; k < other.count; ++k)
        if (other.neighbour[ix(k)] < 0 &&
            (other.nodes[ix(k)] == node || other.nodes[ix((k + 1) % other.count)] == node))
          return true;
    }
    return false;
  }

  /// The nearest point on facet `number` by itself or on its sharp sides. One point on several facets belongs
  /// to the one that faces the point most.
  void settle_at(int number, Settled& best) {
    auto const better = [&](Settled const& s) {
      double const slack = 1e-9 * surface_->facet_size();
      return s.distance < best.distance - slack ||
             (s.distance < best.distance + slack && s.facing > best.facing);
    };
    if (Settled const s = settle_inside(number); s.foot.found() && better(s))
      best = s;
    enter(number, {0, 0});
    for (int k = 0; k < facet().count; ++k) {
      if (!facet().sharp[ix(k)])
        continue;
      if (Settled const s = settle_on_edge(k); s.foot.found() && better(s))
        best = s;
    }
  }

  /// Among the facets around the present one; again around the one found while that leads on.
  Foot settle() {
    double last = infinite;
    for (int round = 0; round < 20; ++round) {
      Settled best;
      for (int const f : surface_->around(number_))
        settle_at(f, best);
      bool const further = best.distance < last * (1 - 1e-9);
      if (!best.foot.found() || FootFeature::of(best.foot).kind != FootFeature::vertex || !further)
        return best.foot;
      last = best.distance;
      number_ = best.foot.segment;
    }
    return {};
  }

  Surface const* surface_;
  Vec3 point_;
  std::span<double const> x_;
  double overhang_, rounding_;
  int number_ = 0;
  Vec2 at_;
  FacetNow now_;
  int edges_crossed_ = 0;
};

struct Nearest {
  Vec3 weights; ///< of the three corners
  double distance2 = infinite;
};

/// The nearest point of a triangle (Ericson, Real-Time Collision Detection, 5.1.5).
Nearest nearest_in_triangle(Vec3 const& a, Vec3 const& b, Vec3 const& c, Vec3 const& p) {
  auto const result = [&](double u, double v) -> Nearest {
    Vec3 const weights(1 - u - v, u, v);
    return {weights, (a * weights[0] + b * u + c * v - p).squaredNorm()};
  };
  Vec3 const ab = b - a, ac = c - a;
  double const d1 = ab.dot(p - a), d2 = ac.dot(p - a), d3 = ab.dot(p - b), d4 = ac.dot(p - b),
               d5 = ab.dot(p - c), d6 = ac.dot(p - c);
  if (d1 <= 0 && d2 <= 0)
    return result(0, 0);
  if (d3 >= 0 && d4 <= d3)
    return result(1, 0);
  if (d6 >= 0 && d5 <= d6)
    return result(0, 1);
  double const va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
    return result(d1 / (d1 - d3), 0);
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
    return result(0, d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    double const w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return result(1 - w, w);
  }
  return result(vb / (va + vb + vc), vc / (va + vb + vc));
}

} // namespace

Foot Surface::sample(int facet, Vec3 const& point, std::span<double const> x, double& distance2) const {
  int const count = facets_[ix(facet)].count;
  auto const at = positions(facet, x);
  Foot foot;
  distance2 = infinite;
  for (int k = 1; k + 1 < count; ++k) { // a quadrilateral as two triangles
    auto const nearest = nearest_in_triangle(at[0], at[ix(k)], at[ix(k + 1)], point);
    if (!(nearest.distance2 < distance2))
      continue;
    distance2 = nearest.distance2;
    Vec2 const local = nearest.weights[0] * node_coordinates(count, 0) +
                       nearest.weights[1] * node_coordinates(count, k) +
                       nearest.weights[2] * node_coordinates(count, k + 1);
    foot = {facet, local.x(), local.y()};
  }
  return foot;
}

Foot Surface::nearest_start(Vec3 const& point, std::span<double const> x) const {
  Foot best;
  double least = infinite;
  for (int f = 0; f < size(); ++f) {
    double distance2 = 0;
    Foot const foot = sample(f, point, x, distance2);
    if (distance2 < least) {
      least = distance2;
      best = foot;
    }
  }
  return best;
}

Foot Surface::follow(Vec3 const& point, Foot start, std::span<double const> x, Overhang overhang) const {
  return FacetWalk(*this, point, x, overhang).from(start);
}

Foot Surface::project(Vec3 const& point, Foot guess, std::span<double const> x,
                      Search<3> const* search) const {
  if (search != nullptr)
    return search->project(-1, point, guess, x);
  if (Foot const foot = guess.found() ? follow(point, guess, x) : Foot{}; foot.found())
    return foot;
  Foot const start = nearest_start(point, x);
  return start.found() ? follow(point, start, x) : Foot{};
}

} // namespace stiction::contact
