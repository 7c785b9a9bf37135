// Samples of a step, their pairing and the means over them.
#include "contact/mortar/mortar.hpp"

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/threads.hpp"

namespace stiction::contact {

namespace {

/// Points of whose area a smaller part faces something are left out.
constexpr double negligible = 1e-9;
/// How far beyond the primary's border a sample may start, in parts of a facet: rounding.
constexpr double at_border = 0.01;
constexpr Index few = 32; // facets or samples that one thread does best

template<int D> Box<D> box_of(CellSurface const& surface, int facet, Positions x) {
  auto const nodes = surface.positions<D>(facet, x);
  auto const own = nodes.leftCols(surface.facet(facet).count());
  return {own.rowwise().minCoeff(), own.rowwise().maxCoeff()};
}

} // namespace

template<int D>
Mortar<D>::Mortar(CellSurface const& secondary, CellSurface const* primary, MortarSettings settings)
    : secondary_(&secondary), primary_(primary), around_(settings.around), bonded_(settings.bonded),
      hat_areas_(secondary.hat_areas(settings.points, settings.around)), points_(settings.points.size()) {
  std::map<Index, int> number;
  for (Index const node : settings.points)
    number.emplace(node, static_cast<int>(number.size()));
  for (auto const& facet : secondary.facets()) {
    auto& points = points_of_.emplace_back();
    for (int k = 0; k < facet.corners(); ++k)
      points[ix(k)] = number.at(facet.nodes[ix(k)]);
  }
  double const deep = 6 * settings.reach; // as deep as the contact stage looks
  double const size = primary != nullptr ? primary->facet_size() : secondary.facet_size(),
               largest = primary != nullptr ? primary->largest_size() : 0;
  range_ = {-deep, std::max(4 * size, deep + largest)};
}

template<int D>
void Mortar<D>::begin(Positions x, PosedObstacle<D> const* obstacle, std::vector<Vec3> const& tangents) {
  samples_.clear();
  pairings_.clear();
  find_normals(x);
  if (obstacle != nullptr) {
    obstacle_ = *obstacle;
    cover();
    if (!tangents.empty())
      find_tangents(tangents);
  } else {
    cut(x);
  }
  pairings_.resize(samples_.size());
  each_sample([&](std::size_t s) {
    pairings_[s] = pair(samples_[s], samples_[s].start.foot, x);
    auto& start = samples_[s].start = pairings_[s].foot;
    if (D == 3 && obstacle_ && start.foot.found())
      start.normal = normal_at(*obstacle_->shape, start.foot);
    else if (D == 3 && bonded_ && !obstacle_ && start.foot.found())
      samples_[s].bearing = bearing(faced(x), start.foot, pairings_[s].frame);
  });
  for (auto& point : points_)
    point.share = 0;
  samples_of_.assign(points_.size(), {});
  for (std::size_t s = 0; s < samples_.size(); ++s) {
    share(s);
    for (int k = 0; k < secondary_->facet(samples_[s].facet).corners(); ++k)
      samples_of_[ix(point_of(samples_[s].facet, k))].push_back(s);
  }
  for (auto& point : points_)
    point.area = point.share;
}

template<int D> void Mortar<D>::find_normals(Positions x) {
  normals_ = secondary_->fan_normals<D>(x);
  if (primary_ != nullptr)
    opposite_ = primary_->fan_normals<D>(x);
}

template<int D> void Mortar<D>::find_tangents(std::vector<Vec3> const& tangents) {
  for (auto& sample : samples_)
    for (int k = 0; k < secondary_->facet(sample.facet).corners(); ++k)
      sample.tangent += sample.hats[k] * tangents[ix(point_of(sample.facet, k))];
}

template<int D> PosedObstacle<D> Mortar<D>::obstacle_of(Sample const& sample) const {
  auto obstacle = *obstacle_;
  if (!sample.tangent.isZero(0))
    obstacle.direction = sample.tangent;
  return obstacle;
}

template<int D> std::vector<int> Mortar<D>::candidates(int facet, Positions x) const {
  auto const box = box_of<D>(*secondary_, facet, x);
  std::vector<int> near;
  grid_.near(0.5 * (box.low + box.high), 0.5 * (box.high - box.low).norm() + range_.high,
             [&](int f) { near.push_back(f); });
  std::sort(near.begin(), near.end());
  return near;
}

template<int D> void Mortar<D>::cut(Positions x) {
  std::vector<Box<D>> boxes;
  boxes.reserve(static_cast<std::size_t>(primary_->size()));
  for (int f = 0; f < primary_->size(); ++f)
    boxes.push_back(box_of<D>(*primary_, f, x));
  grid_.build(boxes);
  auto const sides = faced(x);
  std::vector<std::vector<Sample>> of_facet(static_cast<std::size_t>(secondary_->size()));
  core::each_piece(secondary_->size(), few, [&](Index first, Index last) {
    for (int f = first; f < last; ++f)
      for (auto const& point : cut_facet(sides, f, candidates(f, x), range_)) {
        auto sample = make_sample(*secondary_, f, point.at, point.weight, around_);
        Vec2 const middle = middle_coordinates(primary_->facet(point.primary).kind);
        sample.start =
            meet(*primary_, ray_of(sides, sample), {point.primary, middle.x(), middle.y()}, at_border, x);
        if (sample.start.foot.found())
          of_facet[ix(f)].push_back(sample);
      }
  });
  for (auto const& samples : of_facet)
    samples_.insert(samples_.end(), samples.begin(), samples.end());
}

template<int D> template<class Act> void Mortar<D>::each_sample(Act const& act) {
  core::each_piece(static_cast<Index>(samples_.size()), few, [&](Index first, Index last) {
    for (Index s = first; s < last; ++s)
      act(ix(s));
  });
}

/// An obstacle may lie anywhere.
template<int D> void Mortar<D>::cover() {
  for (int f = 0; f < secondary_->size(); ++f) {
    auto const& rule = facet_rule(secondary_->facet(f).corners(), true);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      samples_.push_back(make_sample(*secondary_, f, rule.points[q], rule.weights[q], around_));
  }
}

template<int D> SamplePairing<D> Mortar<D>::pair(Sample const& sample, Foot guess, Positions x) const {
  if (!obstacle_)
    return pairing(faced(x), sample, guess);
  auto const seen = against_obstacle(sample, guess, x);
  return {seen.found ? seen.foot : Foot{}, seen.gap, seen.slip, seen.frame};
}

/// As if the sample were a node.
template<int D>
PointKinematics<D> Mortar<D>::against_obstacle(Sample const& sample, Foot guess, Positions x) const {
  Vec<D> const position = secondary_->positions<D>(sample.facet, x) * sample.shape.N;
  return kinematics(obstacle_of(sample), 0, sample.start, guess, {position.data(), ix(D)});
}

/// The motion of the sample and the obstacle's by the motion of nodes: [D (1 or 3), D nodes].
template<int D>
Dense Mortar<D>::spread(Sample const& sample, PointKinematics<D> const& seen, Indices& nodes) const {
  auto const& facet = secondary_->facet(sample.facet);
  nodes.assign(facet.nodes.begin(), facet.nodes.begin() + facet.count());
  nodes.insert(nodes.end(), seen.nodes.begin() + 1, seen.nodes.end());
  Dense E = Dense::Zero(D * seen.count, D * static_cast<Index>(nodes.size()));
  for (int k = 0; k < facet.count(); ++k)
    E.block<D, D>(0, D * k) = sample.shape.N[k] * Mat<D>::Identity();
  E.bottomRightCorner(D * (seen.count - 1), D * (seen.count - 1)).setIdentity();
  return E;
}

template<int D> typename Mortar<D>::RowsOfSample Mortar<D>::rows(std::size_t s, Positions x) const {
  auto const& sample = samples_[s];
  auto const& facet = secondary_->facet(sample.facet);
  RowsOfSample result;
  if (obstacle_) {
    auto const seen = against_obstacle(sample, pairings_[s].foot, x);
    result.H = seen.H * spread(sample, seen, result.nodes);
    return result;
  }
  auto const& other = primary_->facet(pairings_[s].foot.segment);
  result.nodes.assign(facet.nodes.begin(), facet.nodes.begin() + facet.count());
  result.nodes.insert(result.nodes.end(), other.nodes.begin(), other.nodes.begin() + other.count());
  result.H = sample_rows(faced(x), sample, pairings_[s]);
  return result;
}

/// Adds what a sample stands for to its points.
template<int D> void Mortar<D>::share(std::size_t s) {
  if (!pairings_[s].found())
    return;
  int const facet = samples_[s].facet;
  for (int k = 0; k < secondary_->facet(facet).corners(); ++k)
    points_[ix(point_of(facet, k))].share += hat_area(s, k);
}

template<int D> void Mortar<D>::locate(Positions x, PosedObstacle<D> const* obstacle) {
  if (obstacle != nullptr)
    obstacle_ = *obstacle;
  find_normals(x);
  motions_.assign(samples_.size(), {});
  for (auto& point : points_) {
    point.share = point.heaviest = 0;
    point.kinematics = {};
    point.columns.clear();
  }
  rows_.resize(samples_.size());
  each_sample([&](std::size_t s) {
    Foot const guess = pairings_[s].found() ? pairings_[s].foot : samples_[s].start.foot;
    pairings_[s] = pair(samples_[s], guess, x);
    if (pairings_[s].found())
      rows_[s] = rows(s, x);
  });
  for (std::size_t s = 0; s < samples_.size(); ++s)
    share(s);
  for (std::size_t p = 0; p < points_.size(); ++p)
    points_[p].kinematics.found = std::min(points_[p].share, points_[p].area) > negligible * hat_areas_[p];
  for (std::size_t s = 0; s < samples_.size(); ++s)
    if (pairings_[s].found())
      add_mean(s);
  for (auto& [area, now, heaviest, kinematics, columns] : points_) {
    kinematics.count = static_cast<int>(kinematics.nodes.size());
    kinematics.H.resize(D, kinematics.unknowns());
    for (int k = 0; k < kinematics.count; ++k)
      kinematics.H.template middleCols<D>(D * k) = columns[ix(k)];
  }
}

template<int D> Mat<D>& Mortar<D>::PointMean::column_of(Index node) {
  auto& nodes = kinematics.nodes;
  auto const slot = static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
  if (slot == nodes.size()) {
    nodes.push_back(node);
    columns.emplace_back(Mat<D>::Zero());
  }
  return columns[slot];
}

template<int D> void Mortar<D>::add_mean(std::size_t s) {
  auto const& pairing = pairings_[s];
  auto const& [nodes, H] = rows_[s];
  int const facet = samples_[s].facet;
  for (int k = 0; k < secondary_->facet(facet).corners(); ++k) {
    auto& point = points_[ix(point_of(facet, k))];
    auto& mean = point.kinematics;
    if (!mean.found)
      continue;
    double const c = hat_area(s, k) / point.share;
    mean.gap += c * pairing.gap;
    mean.slip += c * pairing.slip;
    mean.spin += c * pairing.spin;
    if (c > point.heaviest) {
      point.heaviest = c;
      mean.foot = pairing.foot;
      mean.frame = pairing.frame;
    }
    for (std::size_t j = 0; j < nodes.size(); ++j)
      point.column_of(nodes[j]) += c * H.template middleCols<D>(D * static_cast<Index>(j));
  }
}

template class Mortar<2>;
template class Mortar<3>;

} // namespace stiction::contact
