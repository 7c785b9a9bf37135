// By what sizes of caches Eigen divides its products.
#pragma once
#include <Eigen/Core>

namespace stiction::linear {

/// Eigen asks the processor for its caches, and the order of its sums follows: with sizes of our own the same
/// numbers come out whatever the caches are. Call before anything is computed.
inline void fix_blocking() {
  Eigen::setCpuCacheSizes(48L << 10, 2L << 20, 32L << 20);
}

} // namespace stiction::linear
