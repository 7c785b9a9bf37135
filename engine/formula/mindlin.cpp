// A loop that closes is forgotten, and each way back is twice as large as the first (Masing's rule), as
// friction that turns round at a point changes by 2 mu p.
#include "formula/mindlin.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::formula {

/// Over mu P, from rest: 1 - (1 - u / range)^(3/2).
double Mindlin::first(double way) const {
  double const part = std::min(1.0, std::abs(way) / range_);
  return std::copysign(1 - std::pow(1 - part, 1.5), way);
}

double Mindlin::move(double to, double force, double radius) {
  if (!(force > 0))
    return 0;
  range_ = 3 * mu_ * force * yield_ / (16 * radius);
  double const last = turns_.empty() ? 0 : turns_.back();
  if ((to - at_) * (at_ - last) < 0)
    turns_.push_back(at_);
  at_ = to;
  while (turns_.size() > 1 &&
         (to - turns_[turns_.size() - 2]) * (turns_[turns_.size() - 2] - turns_.back()) >= 0)
    turns_.resize(turns_.size() - 2);
  if (turns_.size() == 1 && std::abs(to) >= std::abs(turns_[0]))
    turns_.clear();
  double share = turns_.empty() ? first(to) : first(turns_[0]);
  for (std::size_t k = 0; k < turns_.size(); ++k)
    share += 2 * first(0.5 * ((k + 1 < turns_.size() ? turns_[k + 1] : to) - turns_[k]));
  return mu_ * force * share;
}

} // namespace stiction::formula
