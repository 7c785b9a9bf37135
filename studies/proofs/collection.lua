-- The order of the report: statics, adhesion, dynamics, then the cases of the paper.
return {
  "greco_block",
  "hertz_2d",
  "jkr_sphere",
  "materials",
  "time_schemes",
  "bar_impact",
  "bouncing_bar",
  "../paper/plate_on_cylinder",
  "../paper/sphere_indentation",
}
