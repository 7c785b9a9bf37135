-- The order of the report: schemes, then the cases of the paper.
return {
  "bar_impact",
  "../paper/plate_on_cylinder",
  "../paper/sphere_indentation",
}
