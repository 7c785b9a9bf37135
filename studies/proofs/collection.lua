-- The order of the report: statics, adhesion, dynamics, then the cases of the paper.
return {
  "greco_block",
  "hertz_2d",
  "jkr_sphere",
  "jkr_cylinder",
  "maugis_dugdale",
  "dcb",
  "materials",
  "bar_impact",
  "../paper/plate_on_cylinder",
  "../paper/sphere_indentation",
}
