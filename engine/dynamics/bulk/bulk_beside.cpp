// A system beside another one, whose numbers and factor it has.
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::dynamics {

void BulkSystem::number_as(BulkSystem const& lead) {
  unknown_of_ = lead.unknown_of_;
  dof_of_ = lead.dof_of_;
  trailing_ = lead.trailing_;
  own_rates_ = own_rates_ && trailing_ > 0;
  kept_.emplace_back();
}

void BulkSystem::borrow_factor(BulkSystem& lead) {
  lent_ = &lead.factor();
  kept_.front().scale = lead.stiffness_scale();
  kept_.front().bodies = lead.bodies_stiffness();
}

} // namespace stiction::dynamics
