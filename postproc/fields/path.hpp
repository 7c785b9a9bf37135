// Where a path has taken what moves along it.
#pragma once
#include "spec/spec.hpp"

namespace stiction::postproc {

struct Pose {
  Vector move{};    ///< m
  double angle = 0; ///< rad
};

/// At `time` (s); before the first and after the last time of the path as there. Throws core::RunError when
/// it moves and the time is not known.
[[nodiscard]] Pose pose_at(PathSpec const& path, std::optional<double> time);

} // namespace stiction::postproc
