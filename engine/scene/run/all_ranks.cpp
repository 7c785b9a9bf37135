// Sums over ranks of what each has taken.
#include "scene/run/all_ranks.hpp"

#include "scene/run/resources.hpp"

namespace stiction::scene {

void AllRanks::note_use() {
  if (!several())
    return;
  cpu_ = ranks_->sum(scene::cpu_seconds());
  memory_ = ranks_->sum(scene::peak_memory());
}

double AllRanks::cpu_seconds() const {
  return cpu_ > 0 ? cpu_ : scene::cpu_seconds();
}

double AllRanks::peak_memory() const {
  return memory_ > 0 ? memory_ : scene::peak_memory();
}

} // namespace stiction::scene
