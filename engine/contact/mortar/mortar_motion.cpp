// How gap and slip of mortar samples and points change with the positions.
#include <optional>

#include "contact/mortar/mortar.hpp"
#include "contact/mortar/mortar_inputs.hpp"

namespace stiction::contact {

namespace {

/// Of a unit vector along `sum` by it.
template<int D> Mat<D> turn_of_unit(Vec<D> const& sum) {
  Vec<D> const n = sum.normalized();
  return (Mat<D>::Identity() - n * n.transpose()) / sum.norm();
}

/// What gap and slip have of the start of the way and of the averaged normals at both of its ends.
template<int D> struct ByWay {
  Mat<D> start = Mat<D>::Zero(), sum_at_start = Mat<D>::Zero(), sum_at_foot = Mat<D>::Zero();
};

template<int D>
ByWay<D> add_way(std::array<WayEnd<D>, 2> const& ends, FanNormals<D> const& normals, Mat<D> const& frame,
                 Moving<D> const& moving, By<D>& by) {
  ByWay<D> result;
  auto const& [start, end] = ends;
  auto const way = start.way_to(end);
  ByLess<D> const foot = moving.foot();
  By<D> chord = unit_input<D>(other_position), sum = By<D>::Zero();
  for (int b = 0; b < D - 1; ++b) {
    chord += end.nodes * end.shape.by[ix(b)] * foot.row(b);
    sum += sum_of_normals<D>(end.facet, end.hats.by[ix(b)], normals) * foot.row(b);
  }
  Mat<D> const at_start = turn_of_unit<D>(start.sum), at_end = turn_of_unit<D>(end.sum);
  for (int a = 1; a < D; ++a) {
    auto const of = way.by(frame.col(a));
    result.start.row(a) = -of.chord;
    result.sum_at_start.row(a) = of.from.transpose() * at_start;
    result.sum_at_foot.row(a) = of.to.transpose() * at_end;
    by.row(a) = of.chord.transpose() * chord + result.sum_at_foot.row(a) * sum +
                of.tangent.transpose() * moving.of_frame[ix(a)];
  }
  return result;
}

/// Blocks over nodes, or over normals, in the order in which they are written.
template<int D> class Blocks {
public:
  explicit Blocks(Index count) : rows_(D, D * count) {}
  void put(Mat<D> const& block) { rows_.template middleCols<D>(D * next_++) = block; }
  [[nodiscard]] Rows<D> take() { return std::move(rows_); }

private:
  Rows<D> rows_;
  Index next_ = 0;
};

/// Adds what averaged normals do by the nodes of their facets.
template<int D>
void add_fans(CellSurface const& surface, FanNormals<D> const& normals, BlocksOf<D> const& by_fan,
              Positions x, BlocksOf<D>& by_node) {
  for (std::size_t i = 0; i < by_fan.numbers().size(); ++i)
    for (auto const& [node, by] : surface.turn_of_fan(normals, by_fan.numbers()[i], x))
      by_node(node) += by_fan.blocks()[i] * by;
}

} // namespace

template<int D>
SampleMotion<D> sample_motion(Faced<D> const& faced, Sample const& sample, SamplePairing<D> const& pairing) {
  Opposite<D> const other(faced, pairing);
  Moving<D> const moving(faced, sample, pairing, other);
  By<D> by = By<D>::Zero();
  by.row(0) = moving.foot_and_gap.row(D - 1);
  auto const& own = faced.secondary.facet(sample.facet);
  bool const onward = sample.start.foot.found();
  std::array const ends{WayEnd<D>(faced, onward ? sample.start.foot : pairing.foot),
                        WayEnd<D>(faced, pairing.foot)};
  auto const& [start, end] = ends;
  auto const on_way = onward ? add_way(ends, faced.opposite, pairing.frame, moving, by) : ByWay<D>{};
  auto const of_input = [&](int number) { return Mat<D>(by.template middleCols<D>(D * number)); };
  Blocks<D> by_nodes(own.count() + end.facet.count() + start.facet.count());
  for (int k = 0; k < own.count(); ++k) {
    Mat<D> block = sample.shape.N[k] * of_input(own_position);
    if constexpr (D == 3)
      block += sample.material[k] * of_input(carried);
    by_nodes.put(block);
  }
  for (int k = 0; k < end.facet.count(); ++k)
    by_nodes.put(end.shape.N[k] * of_input(other_position));
  for (int k = 0; k < start.facet.count(); ++k)
    by_nodes.put(start.shape.N[k] * on_way.start);
  Blocks<D> by_normals(own.corners() + end.facet.corners() + start.facet.corners());
  for (int k = 0; k < own.corners(); ++k)
    by_normals.put(sample.hats[k] * of_input(normal_sum));
  for (int k = 0; k < end.facet.corners(); ++k)
    by_normals.put(end.hats.N[k] * on_way.sum_at_foot);
  for (int k = 0; k < start.facet.corners(); ++k)
    by_normals.put(start.hats.N[k] * on_way.sum_at_start);
  return {by_nodes.take(), by_normals.take()};
}

template<int D> SampleMotion<D> const& Mortar<D>::motion_of(std::size_t s, Positions x) const {
  auto& motion = motions_[s];
  if (!motion)
    motion = sample_motion(faced(x), samples_[s], pairings_[s]);
  return *motion;
}

/// The part of a sample in the means of one of its points.
template<int D> double Mortar<D>::part(std::size_t s, Index point) const {
  int const facet = samples_[s].facet;
  for (int k = 0; k < secondary_->facet(facet).corners(); ++k)
    if (point_of(facet, k) == point)
      return hat_area(s, k) / points_[ix(point)].share;
  return 0;
}

/// Of the sample against an obstacle in space, beyond its rows.
template<int D> typename Mortar<D>::RowsOfSample Mortar<D>::beyond(std::size_t s, Positions x) const {
  RowsOfSample result;
  if constexpr (D == 3) {
    auto const& sample = samples_[s];
    Vec3 const at = secondary_->positions<3>(sample.facet, x) * sample.shape.N;
    auto const seen = against_obstacle(sample, pairings_[s].foot, x);
    result.H = motion_rows(obstacle_of(sample), seen, sample.start, {at.data(), 3}) - seen.H;
    result.H *= spread(sample, seen, result.nodes);
  }
  return result;
}

template<int D> NodalRows<D> Mortar<D>::change(Index point, Positions x) const {
  BlocksOf<D> by_node, by_own_fan, by_other_fan;
  for (std::size_t const s : samples_of_[ix(point)]) {
    if (!pairings_[s].found())
      continue;
    double const c = part(s, point);
    if (obstacle_) {
      auto const [nodes, rows] = beyond(s, x);
      for (std::size_t j = 0; j < nodes.size(); ++j)
        by_node(nodes[j]) += c * rows.template middleCols<D>(D * static_cast<Index>(j));
      continue;
    }
    auto const& motion = motion_of(s, x);
    Index node = 0, normal = 0;
    auto const add = [&](CellFacet const& facet, BlocksOf<D>& fans) {
      for (int k = 0; k < facet.count(); ++k)
        by_node(facet.nodes[ix(k)]) += c * motion.by_nodes.template middleCols<D>(D * node++);
      for (int k = 0; k < facet.corners(); ++k)
        fans(facet.fan[ix(k)]) += c * motion.by_normals.template middleCols<D>(D * normal++);
    };
    add(secondary_->facet(samples_[s].facet), by_own_fan);
    add(primary_->facet(pairings_[s].foot.segment), by_other_fan);
    auto const start = samples_[s].start.foot;
    add(primary_->facet(start.found() ? start.segment : pairings_[s].foot.segment), by_other_fan);
  }
  if (!obstacle_) {
    add_fans(*secondary_, normals_, by_own_fan, x, by_node);
    add_fans(*primary_, opposite_, by_other_fan, x, by_node);
    auto const& now = points_[ix(point)].kinematics;
    for (int k = 0; k < now.count; ++k)
      by_node(now.nodes[ix(k)]) -= now.H.template middleCols<D>(D * k);
  }
  NodalRows<D> result{by_node.numbers(), Rows<D>(D, D * static_cast<Index>(by_node.numbers().size()))};
  for (std::size_t i = 0; i < by_node.blocks().size(); ++i)
    result.rows.template middleCols<D>(D * static_cast<Index>(i)) = by_node.blocks()[i];
  return result;
}

template SampleMotion<2> sample_motion(Faced<2> const&, Sample const&, SamplePairing<2> const&);
template SampleMotion<3> sample_motion(Faced<3> const&, Sample const&, SamplePairing<3> const&);
template NodalRows<2> Mortar<2>::change(Index, Positions) const;
template NodalRows<3> Mortar<3>::change(Index, Positions) const;

} // namespace stiction::contact
