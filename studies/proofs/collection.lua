-- The order of the report: statics, adhesion, dynamics, then the cases of the paper.
return {
  "greco_block",
  "hertz_2d",
  "hertz_3d",
  "cattaneo_mindlin",
  "jkr_sphere",
  "materials",
  "point_laws",
  "cohesive_laws",
  "friction_laws",
  "bar_impact",
  "sliding_block",
  "sphere_impact",
  "../paper/plate_on_cylinder",
  "../paper/sphere_indentation",
}
