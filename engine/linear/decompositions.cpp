// The one place where these templates are made.
#include "linear/decompositions.hpp"

namespace Eigen {

template class LLT<stiction::Dense>;
template class PartialPivLU<stiction::Dense>;
template class FullPivLU<stiction::Dense>;
template class HouseholderQR<stiction::Dense>;
template class SelfAdjointEigenSolver<stiction::Dense>;

} // namespace Eigen
