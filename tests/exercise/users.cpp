// What visits interface laws, compiled with the exercise's among them: the list of what scripts can make,
// error control, the audit, explain.
#include "dynamics/adaptivity/step_error.cpp"
#include "dynamics/step/stepper_audit.cpp"
#include "scene/description/catalog.cpp"
#include "scene/explain/explain_numbers.cpp"
#include "scene/explain/explain_warnings.cpp"
