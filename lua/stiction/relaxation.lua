-- Terms of body.relaxing from measured moduli: a Prony series by least squares whose moduli are not negative.
local fault = require "stiction.fault"
local numeric = require "stiction.numeric"
local units = require "stiction.units"

local relaxation = {}

local most_terms = 20

--- Storage and loss modulus of a series at an angular frequency, all in SI.
local function moduli_at(rest, terms, omega)
  local storage, loss = rest, 0
  for _, term in ipairs(terms) do
    local x = omega * term.time
    storage, loss = storage + term.modulus * x * x / (1 + x * x), loss + term.modulus * x / (1 + x * x)
  end
  return storage, loss
end

--- Bad input of an angular frequency in hertz, which may be of cycles or of radians.
local function check_angular(what, value)
  for _, word in ipairs(units.is_quantity(value) and value.words or {}) do
    if word.name:find("Hz$") then
      fault.script("relaxation.%s is %s; angular frequencies are wanted, in 1/s: write 2*math.pi*f/s for f cycles a second", what,
        tostring(value))
    end
  end
end

local function numbers_of(t, key, unit)
  local list = t[key]
  if type(list) ~= "table" or #list == 0 then
    fault.script("relaxation.fit needs %s, a list of quantities in %s, not %s", key, unit,
      type(list) == "table" and "an empty list" or tostring(list))
  end
  local numbers = {}
  for i, value in ipairs(list) do
    if not units.is_quantity(value) then
      fault.script("relaxation.fit: %s[%d] is %s; give a quantity in %s", key, i, tostring(value), unit)
    end
    if key == "frequency" then
      check_angular(("fit: %s[%d]"):format(key, i), value)
    end
    numbers[i] = value:to(unit)
    if not (numbers[i] > 0 or key == "loss" and numbers[i] == 0) then
      fault.script("relaxation.fit: %s[%d] is %g %s; it must be more than 0", key, i, numbers[i], unit)
    end
  end
  return numbers
end

--- The least squares of the columns that are free alone.
local function of_free(square, right, free)
  local A, b = {}, {}
  for i, p in ipairs(free) do
    A[i], b[i] = {}, right[p]
    for j, q in ipairs(free) do
      A[i][j] = square[p][q]
    end
  end
  return numeric.solve(A, b)
end

local function listed(is_free)
  local free = {}
  for p, yes in ipairs(is_free) do
    free[#free + 1] = yes and p or nil
  end
  return free
end

--- Goes towards the least squares of what is free as far as nothing turns negative; false if something is let go.
local function towards(x, best, is_free, free)
  local part = 1
  for i, p in ipairs(free) do
    if best[i] <= 0 then
      part = math.min(part, x[p] / (x[p] - best[i]))
    end
  end
  for i, p in ipairs(free) do
    x[p] = x[p] + part * (best[i] - x[p])
    if best[i] <= 0 and x[p] <= 1e-12 * math.abs(best[i]) then
      x[p], is_free[p] = 0, false
    end
  end
  return part == 1
end

--- The column that would lessen the squares most if it were freed; nil: none.
local function steepest(square, right, x, is_free)
  local best, at = 1e-10, nil
  for p, sum in ipairs(right) do
    for q, value in ipairs(x) do
      sum = sum - square[p][q] * value
    end
    if not is_free[p] and sum > best then
      best, at = sum, p
    end
  end
  return at
end

--- min |A x - b| with x >= 0 from A^T A and A^T b, columns of length 1 (Lawson and Hanson 1974).
local function non_negative(square, right)
  local x, is_free = {}, {}
  for p in ipairs(right) do
    x[p], is_free[p] = 0, false
  end
  for _ = 1, 10 * #right do
    local at = steepest(square, right, x, is_free)
    if not at then
      break
    end
    is_free[at] = true
    local free = listed(is_free)
    while #free > 0 and not towards(x, of_free(square, right, free), is_free, free) do
      free = listed(is_free)
    end
  end
  return x
end

--- Rows of storage and loss over the size of the modulus there; column 1 is the modulus at rest, the others one time each.
local function equations(data, times)
  local rows, right = {}, {}
  for i, omega in ipairs(data.frequency) do
    local size = math.sqrt(data.storage[i] ^ 2 + data.loss[i] ^ 2)
    local storage, loss = { 1 / size }, { 0 }
    for k, time in ipairs(times) do
      local x = omega * time
      storage[k + 1], loss[k + 1] = x * x / (1 + x * x) / size, x / (1 + x * x) / size
    end
    rows[#rows + 1], rows[#rows + 2] = storage, loss
    right[#right + 1], right[#right + 2] = data.storage[i] / size, data.loss[i] / size
  end
  return rows, right
end

--- Moduli at rest and of each time.
local function fitted(data, times)
  local rows, values = equations(data, times)
  local length, square, right = {}, {}, {}
  for p = 1, #times + 1 do
    local sum = 0
    for _, row in ipairs(rows) do
      sum = sum + row[p] ^ 2
    end
    length[p] = math.sqrt(sum)
  end
  for p = 1, #times + 1 do
    square[p], right[p] = {}, 0
    for q = 1, #times + 1 do
      local sum = 0
      for _, row in ipairs(rows) do
        sum = sum + row[p] * row[q]
      end
      square[p][q] = sum / length[p] / length[q]
    end
    for i, row in ipairs(rows) do
      right[p] = right[p] + row[p] * values[i] / length[p]
    end
  end
  local x = non_negative(square, right)
  for p, value in ipairs(x) do
    x[p] = value / length[p]
  end
  return x
end

--- Times evenly in their logarithm over what the frequencies reach.
local function times_of(frequency, per_decade)
  local low, high = math.huge, 0
  for _, omega in ipairs(frequency) do
    low, high = math.min(low, omega), math.max(high, omega)
  end
  local decades = math.log(high / low, 10)
  local count, times = math.min(most_terms, math.max(1, math.floor(decades * per_decade + 1.5))), {}
  for k = 0, count - 1 do
    times[k + 1] = 1 / high * (high / low) ^ (count == 1 and 0.5 or k / (count - 1))
  end
  return times
end

local function error_of(data, rest, terms)
  local sum, worst = 0, 0
  for i, omega in ipairs(data.frequency) do
    local storage, loss = moduli_at(rest, terms, omega)
    local square = ((storage - data.storage[i]) ^ 2 + (loss - data.loss[i]) ^ 2) / (data.storage[i] ^ 2 + data.loss[i] ^ 2)
    sum, worst = sum + square, math.max(worst, math.sqrt(square))
  end
  return math.sqrt(sum / #data.frequency), worst
end

--- fit { frequency =, storage =, loss = [, per_decade = 1] }: lists of angular frequencies (1/s) and of moduli in shear (Pa).
--- Returns { rest = G, terms = for body.relaxing, error =, worst = }: root mean square and largest distance of the fit from the
--- complex modulus, over its size.
function relaxation.fit(t)
  if type(t) ~= "table" then
    fault.script("relaxation.fit needs { frequency =, storage =, loss = }, not %s", tostring(t))
  end
  for key in pairs(t) do
    if key ~= "frequency" and key ~= "storage" and key ~= "loss" and key ~= "per_decade" then
      fault.script("relaxation.fit has no '%s'%s", tostring(key), fault.meant(key, { "frequency", "storage", "loss", "per_decade" }))
    end
  end
  local data = { frequency = numbers_of(t, "frequency", "1/s"), storage = numbers_of(t, "storage", "Pa"),
    loss = numbers_of(t, "loss", "Pa") }
  if #data.storage ~= #data.frequency or #data.loss ~= #data.frequency then
    fault.script("relaxation.fit needs lists of one length, not of %d frequencies, %d storage and %d loss moduli",
      #data.frequency, #data.storage, #data.loss)
  end
  local per_decade = t.per_decade or 1
  if type(per_decade) ~= "number" or not (per_decade > 0 and per_decade <= 5) then
    fault.script("relaxation.fit: per_decade is %s; it must be in (0, 5]", tostring(per_decade))
  end
  local times = times_of(data.frequency, per_decade)
  local x, terms, plain = fitted(data, times), {}, {}
  for k, time in ipairs(times) do
    if x[k + 1] > 0 then
      plain[#plain + 1] = { modulus = x[k + 1], time = time }
      terms[#terms + 1] = { modulus = x[k + 1] * units.units.Pa, time = time * units.units.s }
    end
  end
  if #terms == 0 or x[1] == 0 then
    fault.script("relaxation.fit: these moduli have no %s; measure at %s frequencies",
      x[1] == 0 and "modulus at rest" or "relaxation", x[1] == 0 and "lower" or "other")
  end
  local rms, worst = error_of(data, x[1], plain)
  return { rest = x[1] * units.units.Pa, terms = terms, error = rms, worst = worst }
end

--- Storage and loss modulus of a fit at an angular frequency, for a figure beside what was measured.
function relaxation.moduli(fit, frequency)
  check_angular("moduli: the frequency", frequency)
  local plain = {}
  for i, term in ipairs(fit.terms) do
    plain[i] = { modulus = term.modulus.si, time = term.time.si }
  end
  local storage, loss = moduli_at(fit.rest.si, plain, frequency:to("1/s"))
  return storage * units.units.Pa, loss * units.units.Pa
end

return relaxation
