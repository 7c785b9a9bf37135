-- Quantities: numbers with a dimension that arithmetic checks, and the table of units.
local calls = require "stiction.calls"
local engine = require "stiction.engine"
local fault = require "stiction.fault"

-- A quantity is {si =, metre =, kilogram =, second =, words =}: the value in SI, the exponents of its
-- dimension, and the unit it was written in as a list of {name =, factor =, power =}, for display only.
local meta = engine.quantity_metatable
local methods = {}

local function is_quantity(x)
  return type(x) == "table" and getmetatable(x) == "quantity"
end

local function make(si, metre, kilogram, second, words)
  local q = { si = si, metre = metre, kilogram = kilogram, second = second, words = words }
  return setmetatable(q, meta)
end

local function is_pure(metre, kilogram, second)
  return metre == 0 and kilogram == 0 and second == 0
end

local function dimension_of(q)
  if type(q) == "number" then
    return "a pure number"
  end
  return ("a quantity in %s"):format(engine.dimension_text(q.metre, q.kilogram, q.second))
end

local function describe(x)
  if type(x) == "number" then
    return ("the pure number %g"):format(x)
  end
  return is_quantity(x) and tostring(x) or ("a %s"):format(type(x))
end

--- Words of a product: equal names add their powers.
local function merge(a, b, sign)
  local words, place = {}, {}
  for _, list in ipairs { { a, 1 }, { b, sign } } do
    for _, word in ipairs(list[1]) do
      local at = place[word.name]
      if not at then
        at = #words + 1
        place[word.name] = at
        words[at] = { name = word.name, factor = word.factor, power = 0 }
      end
      words[at].power = words[at].power + list[2] * word.power
    end
  end
  local kept = {}
  for _, word in ipairs(words) do
    if word.power ~= 0 then
      kept[#kept + 1] = word
    end
  end
  return kept
end

local function product(a, b, sign)
  local metre, kilogram, second = a.metre + sign * b.metre, a.kilogram + sign * b.kilogram, a.second + sign * b.second
  local si = sign > 0 and a.si * b.si or a.si / b.si
  if is_pure(metre, kilogram, second) then
    return si
  end
  return make(si, metre, kilogram, second, merge(a.words, b.words, sign))
end

local function as_factor(x, what, other)
  if type(x) == "number" then
    return { si = x, metre = 0, kilogram = 0, second = 0, words = {} }
  elseif is_quantity(x) then
    return x
  end
  fault.script("cannot %s %s and %s", what, describe(other), describe(x))
end

meta.__mul = function(a, b)
  return product(as_factor(a, "multiply", b), as_factor(b, "multiply", a), 1)
end

meta.__div = function(a, b)
  return product(as_factor(a, "divide", b), as_factor(b, "divide", a), -1)
end

meta.__unm = function(a)
  return make(-a.si, a.metre, a.kilogram, a.second, a.words)
end

local function same_dimension(a, b)
  return is_quantity(a) and is_quantity(b) and a.metre == b.metre and a.kilogram == b.kilogram and a.second == b.second
end

local function need_same(a, b, what)
  if not same_dimension(a, b) then
    fault.script("cannot %s %s and %s: the dimensions differ", what, describe(a), describe(b))
  end
end

meta.__add = function(a, b)
  need_same(a, b, "add")
  return make(a.si + b.si, a.metre, a.kilogram, a.second, a.words)
end

meta.__sub = function(a, b)
  need_same(a, b, "subtract")
  return make(a.si - b.si, a.metre, a.kilogram, a.second, a.words)
end

meta.__eq = function(a, b)
  return same_dimension(a, b) and a.si == b.si
end

meta.__lt = function(a, b)
  need_same(a, b, "compare")
  return a.si < b.si
end

meta.__le = function(a, b)
  need_same(a, b, "compare")
  return a.si <= b.si
end

local function whole(x)
  return math.tointeger(x) or fault.script("this power would give a fractional dimension")
end

meta.__pow = function(a, n)
  if not is_quantity(a) or type(n) ~= "number" then
    fault.script("cannot raise %s to the power of %s: the exponent must be a pure number", describe(a), describe(n))
  end
  local words = {}
  for i, word in ipairs(a.words) do
    words[i] = { name = word.name, factor = word.factor, power = word.power * n }
  end
  return make(a.si ^ n, whole(a.metre * n), whole(a.kilogram * n), whole(a.second * n), words)
end

--- "kg/m^3" and its factor to SI; nil if the words cannot be written as one unit text.
local function unit_of(words)
  local above, below, factor = {}, {}, 1
  for _, word in ipairs(words) do
    local power = math.tointeger(word.power)
    local compound = word.name:find("[ /*^]") ~= nil
    if not power or (compound and (#words > 1 or power ~= 1)) then
      return nil
    end
    factor = factor * word.factor ^ power
    local list, size = power > 0 and above or below, math.abs(power)
    list[#list + 1] = size == 1 and word.name or ("%s^%d"):format(word.name, size)
  end
  local text = #above > 0 and table.concat(above, " ") or "1"
  return #below > 0 and text .. "/" .. table.concat(below, "/") or text, factor
end

local function display(q)
  local unit, factor = unit_of(q.words)
  if not unit then
    return q.si, engine.dimension_text(q.metre, q.kilogram, q.second)
  end
  return q.si / factor, unit
end

meta.__tostring = function(q)
  local value, unit = display(q)
  return ("%.10g %s"):format(value, unit)
end

meta.__concat = function(a, b)
  return tostring(a) .. tostring(b)
end

local function parse(text)
  if type(text) ~= "string" then
    fault.script("a unit is a text like \"mm/s\", not %s", type(text) == "table" and "a table" or tostring(text))
  end
  local factor, metre, kilogram, second = engine.parse_unit(text)
  if not factor then
    local word = text:match("^[^ /*^]+$") or ""
    fault.script("unknown unit '%s'%s; 'stiction help units' lists them", text, fault.meant(word, engine.unit_words()))
  end
  return factor, metre, kilogram, second
end

--- The plain number of this quantity in the unit `text`.
function methods.to(q, text)
  local factor, metre, kilogram, second = parse(text)
  if not same_dimension(q, make(0, metre, kilogram, second)) then
    fault.script("%s cannot be written in '%s': the dimensions differ", tostring(q), text)
  end
  return q.si / factor
end

--- The quantity without its sign.
function methods.abs(q)
  return q.si < 0 and -q or q
end

--- The number and the unit this quantity was written in.
function methods.display(q)
  return display(q)
end

calls.methods(methods, "q", is_quantity)

meta.__index = function(_, name)
  return methods[name] or fault.script("a quantity has no '%s'; it has to(unit), abs() and display()", tostring(name))
end
meta.__newindex = function()
  fault.script("a quantity cannot be changed; make a new one")
end
meta.__metatable = "quantity"

local function unit(text)
  local factor, metre, kilogram, second = parse(text)
  if is_pure(metre, kilogram, second) then
    return factor
  end
  return make(factor, metre, kilogram, second, { { name = text, factor = factor, power = 1 } })
end

local units = setmetatable({}, {
  __index = function(_, word)
    return unit(word)
  end,
  __call = function(_, text)
    return unit(text)
  end,
  __newindex = function()
    fault.script("the table of units cannot be changed")
  end,
  __metatable = "units",
})

--- For the library: the functions above, apart from the table that scripts index with unit words.
return {
  units = units,
  is_quantity = is_quantity,
  same_dimension = same_dimension,
  dimension_of = dimension_of,
  --- Plain SI number of a number or quantity; anything else comes back as it is.
  si = function(x)
    return is_quantity(x) and x.si or x
  end,
}
