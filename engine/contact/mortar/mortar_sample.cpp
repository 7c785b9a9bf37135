// The pairing of a sample and how its forces turn and slide, by hand: inputs are few.
#include <cmath>
#include <numbers>

#include "contact/mortar/mortar_inputs.hpp"

namespace stiction::contact {

namespace {

/// How far a sample may slide beyond the primary's border during a step, in parts of a facet.
constexpr double slide = 0.5;

template<int D> Mat<D> frame_along(Vec<D> const& n, Vec<D> const& direction) {
  Mat<D> frame;
  if constexpr (D == 2) {
    static_cast<void>(direction);
    frame << n, Vec2(n.y(), -n.x());
  } else {
    Vec3 const t1 = (direction - n * n.dot(direction)).normalized();
    frame << n, t1, n.cross(t1);
  }
  return frame;
}

/// Derivatives by the inputs.
template<int D> struct Turning {
  By<D> force = By<D>::Zero(), normal = By<D>::Zero();
  ByLess<D> foot, levered; ///< of the foot's local coordinates and of c
};

template<int D>
Turning<D> turning(Faced<D> const& faced, Sample const& sample, SamplePairing<D> const& pairing,
                   Local<D> const& f) {
  Opposite<D> const other(faced, pairing);
  Mat<D> const& frame = pairing.frame;
  Moving<D> const moving(faced, sample, pairing, other);
  auto const& turned = moving.of_frame;
  Turning<D> by;
  by.normal = moving.normal;
  by.foot = moving.foot();
  for (int c = 0; c < D; ++c)
    by.force += f[c] * turned[ix(c)];
  Local<D - 1> const along = f.template tail<D - 1>(), levered = pairing.gap * other.lever * along;
  ByLess<D> right = along * moving.foot_and_gap.row(D - 1);
  for (int b = 0; b < D - 1; ++b) {
    By<D> tangent = unit_input<D>(other_tangents + b);
    for (int a = 0; a < D - 1; ++a)
      tangent += other.nodes * other.shape.second(a, b) * by.foot.row(a);
    for (int a = 0; a < D - 1; ++a)
      right.row(a) -= levered[b] * (other.tangents.col(b).transpose() * turned[ix(a + 1)] +
                                    frame.col(a + 1).transpose() * tangent);
  }
  by.levered = other.lever * right;
  return by;
}

} // namespace

Sample make_sample(CellSurface const& surface, int facet, Vec2 const& at, double domain_weight, bool around) {
  auto const& f = surface.facet(facet);
  Sample sample;
  sample.facet = facet;
  sample.area = domain_weight * surface.measure(facet, at, around);
  sample.shape = facet_shape(f.kind, at);
  sample.hats = facet_shape(linear_kind(f.kind), at).N;
  if (surface.dim() == 2)
    return sample;
  // contravariant components of the direction in the reference
  auto const tangents = tangents_of<3>(f.reference, sample.shape);
  Vec2 const parts = (tangents.transpose() * tangents).inverse() * (tangents.transpose() * f.direction);
  sample.material = parts[0] * sample.shape.by[0] + parts[1] * sample.shape.by[1];
  return sample;
}

template<int D> Ray<D> ray_of(Faced<D> const& faced, Sample const& sample) {
  return {faced.secondary.template positions<D>(sample.facet, faced.x) * sample.shape.N,
          -normal_sum_of(faced, sample).normalized()};
}

template<int D> double bearing(Faced<D> const& faced, Foot foot, Mat<D> const& frame) {
  if constexpr (D == 2)
    return 0;
  else {
    auto const shape = facet_shape(faced.primary.facet(foot.segment).kind, {foot.xi, foot.eta});
    Vec3 const along =
        tangents_of<3>(faced.primary.template positions<3>(foot.segment, faced.x), shape).col(0);
    return std::atan2(frame.col(2).dot(along), frame.col(1).dot(along));
  }
}

template<int D> SamplePairing<D> pairing(Faced<D> const& faced, Sample const& sample, Foot guess) {
  auto const ray = ray_of(faced, sample);
  SamplePairing<D> result;
  result.foot = meet(faced.primary, ray, guess, slide, faced.x);
  if (!result.found())
    return result;
  WayEnd<D> const end(faced, result.foot);
  result.gap = ray.along.dot(ray.from - end.position);
  result.frame = frame_along<D>(ray.along, carried_direction(faced, sample));
  if (!sample.start.foot.found())
    return result;
  auto const way = WayEnd<D>(faced, sample.start.foot).way_to(end);
  for (int a = 0; a < D - 1; ++a)
    result.slip[a] = way.along(result.frame.col(a + 1));
  if (sample.bearing)
    result.spin = std::remainder(bearing(faced, sample.start.foot, result.frame) - *sample.bearing,
                                 2 * std::numbers::pi);
  return result;
}

template<int D>
SampleRows<D> sample_rows(Faced<D> const& faced, Sample const& sample, SamplePairing<D> const& pairing) {
  Opposite<D> const other(faced, pairing);
  int const own = faced.secondary.facet(sample.facet).count(), all = own + other.facet.count();
  Mat<D> const turned = pairing.frame.transpose();
  SampleRows<D> H(D, D * all);
  for (int k = 0; k < own; ++k)
    H.template middleCols<D>(D * k) = sample.shape.N[k] * turned;
  for (int k = 0; k < all - own; ++k) {
    auto block = H.template middleCols<D>(D * (own + k));
    block = -other.shape.N[k] * turned;
    for (int a = 0; a < D - 1; ++a)
      for (int b = 0; b < D - 1; ++b)
        block.row(a + 1) += pairing.gap * other.lever(b, a) * other.shape.by[ix(b)][k] * turned.row(0);
  }
  return H;
}

/// What acts on the opposite facet: the force, the normal, and the lever of the tangential force.
template<int D> struct Loading {
  Vec<D> F, n;
  Local<D - 1> levered;
};

/// How the force on node j of the opposite facet turns with the inputs.
template<int D>
By<D> opposite_row(Opposite<D> const& other, Turning<D> const& by, Loading<D> const& load, int j) {
  By<D> row = -other.shape.N[j] * by.force;
  for (int b = 0; b < D - 1; ++b) {
    double const slope = other.shape.by[ix(b)][j];
    row += -slope * load.F * by.foot.row(b) + slope * load.n * by.levered.row(b) +
           load.levered[b] * slope * by.normal;
    for (int a = 0; a < D - 1; ++a)
      row += load.levered[b] * other.shape.second(a, b)[j] * load.n * by.foot.row(a);
  }
  return row;
}

template<int D>
SampleStiffness<D> sample_stiffness(Faced<D> const& faced, Sample const& sample,
                                    SamplePairing<D> const& pairing, Local<D> const& force) {
  auto const by = turning(faced, sample, pairing, force);
  Opposite<D> const other(faced, pairing);
  auto const& facet = faced.secondary.facet(sample.facet);
  int const own = facet.count(), all = own + other.facet.count();
  Loading<D> const load{pairing.frame * force, pairing.frame.col(0),
                        pairing.gap * other.lever * force.template tail<D - 1>()};
  SampleStiffness<D> K{Dense(D * all, D * all), Dense(D * all, D * facet.corners())};
  for (int k = 0; k < all; ++k) {
    By<D> const row =
        k < own ? By<D>(sample.shape.N[k] * by.force) : opposite_row<D>(other, by, load, k - own);
    for (int i = 0; i < own; ++i) {
      auto block = K.by_nodes.template block<D, D>(D * k, D * i);
      block = sample.shape.N[i] * row.template middleCols<D>(D * own_position);
      if constexpr (D == 3)
        block += sample.material[i] * row.template middleCols<D>(D * carried);
    }
    for (int j = 0; j < all - own; ++j) {
      auto block = K.by_nodes.template block<D, D>(D * k, D * (own + j));
      block = other.shape.N[j] * row.template middleCols<D>(D * other_position);
      for (int b = 0; b < D - 1; ++b)
        block += other.shape.by[ix(b)][j] * row.template middleCols<D>(D * (other_tangents + b));
    }
    for (int c = 0; c < facet.corners(); ++c)
      K.by_normals.template block<D, D>(D * k, D * c) =
          sample.hats[c] * row.template middleCols<D>(D * normal_sum);
  }
  return K;
}

template Ray<2> ray_of(Faced<2> const&, Sample const&);
template Ray<3> ray_of(Faced<3> const&, Sample const&);
template double bearing(Faced<2> const&, Foot, Mat<2> const&);
template double bearing(Faced<3> const&, Foot, Mat<3> const&);
template SamplePairing<2> pairing(Faced<2> const&, Sample const&, Foot);
template SamplePairing<3> pairing(Faced<3> const&, Sample const&, Foot);
template SampleRows<2> sample_rows(Faced<2> const&, Sample const&, SamplePairing<2> const&);
template SampleRows<3> sample_rows(Faced<3> const&, Sample const&, SamplePairing<3> const&);
template SampleStiffness<2> sample_stiffness(Faced<2> const&, Sample const&, SamplePairing<2> const&,
                                             Local<2> const&);
template SampleStiffness<3> sample_stiffness(Faced<3> const&, Sample const&, SamplePairing<3> const&,
                                             Local<3> const&);

} // namespace stiction::contact
