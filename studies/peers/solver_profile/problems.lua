-- Saved problems by study and case, and the steps that they are of: those that collect.sh leaves.

--- first, first + every, ..., last; six digits each.
local function steps(first, every, last)
  local names = {}
  for step = first, last, every do
    names[#names + 1] = ("%06d"):format(step)
  end
  return names
end

return {
  { folder = "block3d/cells8/problems", steps = steps(1, 1, 11) },
  { folder = "capstan/phi180_mu0.6/problems", steps = steps(2, 2, 50) },
  { folder = "cattaneo_mindlin/quad4_16/problems", steps = steps(1, 1, 72) },
  { folder = "dcb/C1e+10_1000/problems", steps = steps(10, 10, 220) },
  { folder = "friction/problems", steps = { "p01_flat_nc49", "p02_wavy_nc100", "p03_twist_nc196", "p04_rough_nc324",
    "p09_rigidbox_nc144", "p10_rigidwall" } },
  { folder = "greco_block/quad4_64/problems", steps = steps(1, 1, 1) },
  { folder = "hertz_3d/pair_16_block_200_slope_0.005/problems", steps = steps(1, 1, 10) },
  { folder = "ironing/die_quad8_mu0.3_200_spline/problems", steps = steps(10, 10, 40) },
  { folder = "ironing/slab_quad4_mu0.3_200_mortar/problems", steps = steps(10, 10, 40) },
  { folder = "jkr_cylinder/stiffness0.3_cells4/problems", steps = steps(10, 10, 230) },
  { folder = "nonmatching_slide/mu0.3_200_mortar/problems", steps = steps(5, 5, 25) },
  { folder = "peeled_film/cell200_in0.1s/problems", steps = steps(10, 10, 200) },
  { folder = "plate_on_cylinder/v1000_mu0.4/problems", steps = steps(10, 10, 150) },
  { folder = "plate_on_cylinder/v1000_mu0.8/problems", steps = steps(10, 10, 530) },
  { folder = "slide2d/cells8_materialblatz_ko_mu0.5/problems", steps = steps(4, 4, 48) },
  { folder = "sphere_indentation/A_deformable/problems", steps = steps(20, 20, 400) },
  { folder = "sphere_indentation/A_space/problems", steps = steps(20, 20, 400) },
}
