-- Homogeneous states: stresses against differences of the energy, closed forms, and the limit of small strains.
local test = ...
local h = require("stiction.reference").hyperelastic

local function near(got, wanted, tolerance, scale)
  if got ~= got or math.abs(got - wanted) > (tolerance or 1e-12) * math.abs(scale or wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

-- Each with G = 1 at rest, and its bulk modulus.
local laws = {
  neo_hookean = { h.neo_hookean(2.8, 0.4), 14 / 3 }, mooney_rivlin = { h.mooney_rivlin(0.35, 0.15, 9), 9 },
  yeoh = { h.yeoh(0.5, -0.05, 0.01, 9), 9 }, ogden = { h.ogden({ 1.2, -0.4 }, { 1.3, -1.1 }, 9), 9 },
  arruda_boyce = { h.arruda_boyce(1, 2.5, 9), 9 }, blatz_ko = { h.blatz_ko(1), 5 / 3 },
  st_venant_kirchhoff = { h.st_venant_kirchhoff(2.8, 0.4), 14 / 3 },
}

for name, entry in pairs(laws) do
  local law, K = entry[1], entry[2]
  test(name .. ": the stresses are derivatives of the energy, the error falls with the square of the step", function()
    local errors = {}
    for k, step in ipairs { 1e-2, 1e-3 } do
      local t1, t2, t3 = law.kirchhoff(1.3, 0.8, 1.1)
      local d1 = law.energy(1.3 + step, 0.8, 1.1) - law.energy(1.3 - step, 0.8, 1.1)
      local d2 = law.energy(1.3, 0.8 + step, 1.1) - law.energy(1.3, 0.8 - step, 1.1)
      local d3 = law.energy(1.3, 0.8, 1.1 + step) - law.energy(1.3, 0.8, 1.1 - step)
      errors[k] = math.abs(1.3 * d1 / (2 * step) - t1) + math.abs(0.8 * d2 / (2 * step) - t2)
        + math.abs(1.1 * d3 / (2 * step) - t3)
    end
    assert(errors[2] < 1e-4, errors[2])
    near(errors[1] / errors[2], 100, 0.05)
  end)
  test(name .. ": at rest there is no stress, and small strains see G and K", function()
    for _, t in ipairs { law.kirchhoff(1, 1, 1) } do assert(math.abs(t) < 1e-14) end
    local step = 1e-6
    local E = 9 * K / (3 * K + 1)
    local P, q = h.uniaxial(law, 1 + step)
    near(P, E * step, 1e-5)
    near(q - 1, -(E / 2 - 1) * step, 1e-5)
    near(h.simple_shear(law, step).s12, step, 1e-5)
  end)
  test(name .. ": shear by +g and -g, and Rivlin's relation s11 - s22 = g s12", function()
    local a, b = h.simple_shear(law, 0.7), h.simple_shear(law, -0.7)
    near(a.s12, -b.s12)
    near(a.s11, b.s11, 1e-12, a.s12)
    near(a.s11 - a.s22, 0.7 * a.s12, 1e-12)
  end)
  test(name .. ": the sides of a bar are free", function()
    for _, l in ipairs { 0.7, 1.5 } do
      local P, q = h.uniaxial(law, l)
      local t1, t2 = law.kirchhoff(l, q, q)
      near(t1 / l, P)
      near(t2, 0, 1e-12, t1)
    end
  end)
end

test("Blatz-Ko has closed forms", function()
  local law = h.blatz_ko(3)
  for _, l in ipairs { 0.6, 2 } do
    local P, q = h.uniaxial(law, l)
    near(P, 3 * (l ^ -0.5 - l ^ -3))
    near(q, l ^ -0.25)
  end
  local s = h.simple_shear(law, 0.5)
  near(s.s12, 1.5)
  near(s.s22, -0.75)
  near(s.s11, 0, 1e-12, 1)
end)

test("St Venant and Kirchhoff: P = E l (l^2 - 1)/2, and the sides by Poisson's ratio", function()
  local P, q = h.uniaxial(h.st_venant_kirchhoff(10, 0.3), 1.4)
  near(P, 10 * 1.4 * 0.48)
  near((q ^ 2 - 1) / 2, -0.3 * 0.48)
end)

test("nearly incompressible rubber tends to P = G (l - l^-2), by Mooney with C01 to 2 (C10 + C01/l)(l - l^-2)", function()
  local l = 1.8
  near(h.uniaxial(h.neo_hookean(3 - 1e-7, 0.5 - 1e-8), l), l - l ^ -2, 1e-6)
  near(h.uniaxial(h.mooney_rivlin(0.3, 0.2, 1e7), l), 2 * (0.3 + 0.2 / l) * (l - l ^ -2), 1e-6)
end)
