// Least squares over the last few corrections.
#include "dynamics/step/mixing.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace stiction::dynamics {

void Mixing::forget() {
  kept_ = next_ = 0;
  last_correction_.resize(0);
}

void Mixing::mix(Vector const& imbalance, Vector& correction, Vector& forces) {
  if (last_correction_.size() != correction.size() || last_forces_.size() != forces.size()) {
    forget();
    imbalances_.resize(correction.size(), memory);
    ends_.resize(correction.size(), memory);
    forces_.resize(forces.size(), memory);
  } else {
    auto const at = next_++ % memory;
    kept_ = std::min(kept_ + 1, memory);
    imbalances_.col(at) = imbalance - last_imbalance_;
    ends_.col(at) = correction - last_correction_ + last_step_;
    forces_.col(at) = forces - last_forces_;
  }
  last_imbalance_ = imbalance;
  last_correction_ = correction;
  last_forces_ = forces;
  if (kept_ > 0) {
    auto const changes = imbalances_.leftCols(kept_);
    Vector const scale = changes.colwise().norm().cwiseInverse();
    Dense const normal = scale.asDiagonal() * (changes.transpose() * changes) * scale.asDiagonal();
    Vector const right = scale.cwiseProduct(changes.transpose() * imbalance);
    Vector const part = scale.cwiseProduct(normal.colPivHouseholderQr().solve(right));
    if (part.allFinite()) {
      correction.noalias() -= ends_.leftCols(kept_) * part;
      forces.noalias() -= forces_.leftCols(kept_) * part;
    }
  }
  last_step_ = correction;
}

} // namespace stiction::dynamics
