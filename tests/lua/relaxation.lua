-- Prony series fitted to moduli: those of a series come back, what no series has is told.
local test, equal, fails = ...
local stiction = require "stiction"
local fit, moduli = stiction.relaxation.fit, stiction.relaxation.moduli
local s, Pa, kPa = stiction.units.s, stiction.units.Pa, stiction.units.kPa

--- Moduli of a series at frequencies over so many decades, ten a decade.
local function measured(rest, terms, low, decades)
  local data = { frequency = {}, storage = {}, loss = {} }
  for i = 0, 10 * decades do
    local omega = low * 10 ^ (i / 10)
    local storage, loss = rest, 0
    for _, term in ipairs(terms) do
      local x = omega * term[2]
      storage, loss = storage + term[1] * x ^ 2 / (1 + x ^ 2), loss + term[1] * x / (1 + x ^ 2)
    end
    data.frequency[i + 1], data.storage[i + 1], data.loss[i + 1] = omega / s, storage * Pa, loss * Pa
  end
  return data
end

test("a series whose times are those of the fit comes back", function()
  local found = fit(measured(1000, { { 300, 1e-2 }, { 2000, 1 }, { 50, 100 } }, 1e-2, 4))
  equal(math.abs(found.rest.si - 1000) < 1e-6, true)
  equal(#found.terms, 3)
  for i, wanted in ipairs { { 300, 1e-2 }, { 2000, 1 }, { 50, 100 } } do
    equal(math.abs(found.terms[i].modulus.si / wanted[1] - 1) < 1e-6, true)
    equal(math.abs(found.terms[i].time.si / wanted[2] - 1) < 1e-9, true)
  end
  equal(found.error < 1e-9, true)
end)

test("times between those of the fit cost what its error says", function()
  local data = measured(1000, { { 3000, 0.3 } }, 1e-2, 4)
  local one, two = fit(data), fit { frequency = data.frequency, storage = data.storage, loss = data.loss, per_decade = 2 }
  equal(math.abs(one.error - 0.1287) < 1e-4 and math.abs(two.error - 0.0063) < 1e-4, true)
  equal(one.worst > one.error and two.worst > two.error, true)
  local storage, loss = moduli(two, 1 / (0.3 * s))
  equal(math.abs(storage.si / 2500 - 1) < 0.05 and math.abs(loss.si / 1500 - 1) < 0.05, true)
  for _, term in ipairs(two.terms) do
    equal(term.modulus.si > 0, true)
  end
end)

--- Root mean square distance of a fit from the complex moduli, over their size.
local function error_of(data, found)
  local sum = 0
  for i, omega in ipairs(data.frequency) do
    local storage, loss = moduli(found, omega)
    local G, other = data.storage[i].si, data.loss[i].si
    sum = sum + ((storage.si - G) ^ 2 + (loss.si - other) ^ 2) / (G ^ 2 + other ^ 2)
  end
  return math.sqrt(sum / #data.frequency)
end

test("no other moduli of its times come nearer", function()
  local data = measured(1000, { { 3000, 0.3 }, { 700, 7 } }, 1e-3, 5)
  local found = fit(data)
  local least = error_of(data, found)
  equal(math.abs(found.error / least - 1) < 1e-9, true)
  for _, factor in ipairs { 0.99, 1.01 } do
    local changed = { rest = factor * found.rest, terms = found.terms }
    equal(error_of(data, changed) > least, true)
    for k, term in ipairs(found.terms) do
      changed = { rest = found.rest, terms = { table.unpack(found.terms) } }
      changed.terms[k] = { modulus = factor * term.modulus, time = term.time }
      equal(error_of(data, changed) > least, true)
    end
  end
end)

test("a fit is a body's relaxation", function()
  local found = fit(measured(1000, { { 300, 1e-2 } }, 1e-1, 3))
  local body = stiction.body { mesh = stiction.mesh.block { origin = { 0*s, 0*s }, size = { 1*s, 1*s }, cells = { 1, 1 } },
    material = stiction.material.blatz_ko { shear_modulus = found.rest }, density = 1*Pa, relaxing = found.terms }
  equal(body ~= nil, true)
end)

test("what no fit can be made of is told", function()
  local data = measured(1000, { { 300, 1 } }, 1e-1, 2)
  fails("needs loss, a list of quantities in Pa, not nil", fit, { frequency = data.frequency, storage = data.storage })
  fails("lists of one length, not of 21 frequencies, 21 storage and 1 loss moduli", fit,
    { frequency = data.frequency, storage = data.storage, loss = { 1*Pa } })
  fails("storage[1] is 0 Pa; it must be more than 0", fit, { frequency = data.frequency, storage = { 0*Pa }, loss = data.loss })
  local Hz = require("stiction").units.Hz
  fails("relaxation.fit: frequency[1] is 3 Hz; angular frequencies are wanted, in 1/s: write 2*math.pi*f/s", fit,
    { frequency = { 3 * Hz }, storage = { 1*Pa }, loss = { 1*Pa } })
  fails("relaxation.fit needs frequency, a list of quantities in 1/s, not an empty list", fit, { frequency = {}, storage = {}, loss = {} })
  fails("frequency[1] is 3; give a quantity in 1/s", fit, { frequency = { 3 }, storage = { 1*Pa }, loss = { 1*Pa } })
  fails("per_decade is 7; it must be in (0, 5]", fit,
    { frequency = data.frequency, storage = data.storage, loss = data.loss, per_decade = 7 })
  fails("has no 'storge'; did you mean 'storage'?", fit, { storge = {} })
  fails("no relaxation", fit, { frequency = { 1 / s, 2 / s }, storage = { 1*kPa, 1*kPa }, loss = { 0*Pa, 0*Pa } })
end)
