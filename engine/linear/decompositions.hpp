// Eigen's decompositions of dense matrices, made once: in every file that uses them they cost seconds to
// compile.
#pragma once
#include <Eigen/Dense>

#include "core/types.hpp"

namespace Eigen {

extern template class LLT<stiction::Dense>;
extern template class PartialPivLU<stiction::Dense>;
extern template class FullPivLU<stiction::Dense>;
extern template class HouseholderQR<stiction::Dense>;
extern template class SelfAdjointEigenSolver<stiction::Dense>;

} // namespace Eigen
