-- The order of the report: statics, adhesion, dynamics, then the cases of the paper.
return {
  "patch",
  "ironing",
  "nonmatching_slide",
  "locking",
  "greco_block",
  "hertz_2d",
  "jkr_sphere",
  "materials",
  "bar_impact",
  "../paper/plate_on_cylinder",
  "../paper/sphere_indentation",
}
