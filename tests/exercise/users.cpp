// What visits interface laws, compiled with the exercise's among them: the list of what scripts can make,
// error control, the audit, explain.
#include "dynamics/step_error.cpp"
#include "dynamics/stepper_audit.cpp"
#include "scene/catalog.cpp"
#include "scene/explain_numbers.cpp"
#include "scene/explain_warnings.cpp"
