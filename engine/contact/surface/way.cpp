// The arc over the chord, and how it changes with the chord and the normals at its ends.
#include "contact/surface/way.hpp"

#include <cmath>

namespace stiction::contact {

namespace {
/// Half the angle's cosine below which the way from a normal to its opposite is not told any more.
constexpr double opposite = 0.1;
constexpr double by_series = 1e-2; ///< half of the angle below which it is used
} // namespace

template<int D>
Way<D>::Way(Vec<D> const& chord, Vec<D> const& from, Vec<D> const& to, ChordEnds ends)
    : chord_(chord), from_(from), to_(to), leaning_(ends == ChordEnds::on_facets ? 1 : 0) {
  Vec<D> const sum = from + to;
  cosine_ = sum.norm() / 2;
  told_ = cosine_ >= opposite;
  middle_ = cosine_ > 0 ? Vec<D>(sum / (2 * cosine_)) : to;
  double const sine = (to - from).norm() / 2, half = std::atan2(sine, cosine_);
  if (half < by_series) {
    excess_ = 1.0 / 12 + 3 * half * half / 80;
    excess_by_ = -3.0 / 40;
  } else {
    double const arc = half / sine, sine2 = sine * sine;
    excess_ = (arc - 1) / (2 * sine2);
    excess_by_ = ((arc * cosine_ - 1) / 2 + (arc - 1) * cosine_) / (sine2 * sine2);
  }
  risen_ = chord.dot(middle_ + to) / (1 + cosine_) + excess_ * chord.dot(to - from) -
           leaning_ * chord.dot(middle_);
}

template<int D> double Way<D>::along(Vec<D> const& tangent) const {
  double const along = tangent.dot(chord_);
  return told_ ? along - risen_ * tangent.dot(middle_) : along;
}

template<int D> typename Way<D>::By Way<D>::by(Vec<D> const& tangent) const {
  Vec<D> const none = Vec<D>::Zero();
  if (!told_)
    return {tangent, none, none, chord_};
  // d middle = turned (d from + d to), d cosine = middle / 2 (d from + d to)
  auto const turned = [&](Vec<D> const& v) { return Vec<D>((v - middle_ * middle_.dot(v)) / (2 * cosine_)); };
  double const steep = tangent.dot(middle_), back = chord_.dot(middle_ + to_) / (1 + cosine_);
  Vec<D> const risen_by_chord =
      (middle_ + to_) / (1 + cosine_) + excess_ * (to_ - from_) - leaning_ * middle_;
  Vec<D> const risen_by_both = (1 / (1 + cosine_) - leaning_) * turned(chord_) +
                               (excess_by_ * chord_.dot(to_ - from_) - back / (1 + cosine_)) * middle_ / 2;
  Vec<D> const both = -risen_ * turned(tangent) - steep * risen_by_both;
  return {tangent - steep * risen_by_chord, both + steep * excess_ * chord_,
          both - steep * (1 / (1 + cosine_) + excess_) * chord_, chord_ - risen_ * middle_};
}

template class Way<2>;
template class Way<3>;

} // namespace stiction::contact
