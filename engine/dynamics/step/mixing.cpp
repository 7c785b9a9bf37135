// Anderson's mixing by least squares.
#include "dynamics/step/mixing.hpp"

#include "linear/decompositions.hpp"

namespace stiction::dynamics {

void Mixing::clear() {
  made_.clear();
  answers_.clear();
  last_.resize(0);
}

void Mixing::mix(Vector& correction) {
  constexpr double independent = 1e-8; // of the others' lengths
  if (last_.size() == correction.size()) {
    if (made_.size() == most) {
      made_.erase(made_.begin());
      answers_.erase(answers_.begin());
    }
    made_.push_back(last_made_);
    answers_.emplace_back(correction - last_);
  }
  last_ = correction;
  if (!answers_.empty()) {
    Dense A(correction.size(), static_cast<Index>(answers_.size()));
    for (std::size_t k = 0; k < answers_.size(); ++k)
      A.col(static_cast<Index>(k)) = answers_[k];
    Eigen::ColPivHouseholderQR<Dense> decomposition(A.rows(), A.cols());
    decomposition.setThreshold(independent);
    decomposition.compute(A);
    Vector const parts = decomposition.solve(correction);
    for (std::size_t k = 0; k < answers_.size(); ++k)
      correction -= parts[static_cast<Index>(k)] * (made_[k] + answers_[k]);
  }
  last_made_ = correction;
}

} // namespace stiction::dynamics
