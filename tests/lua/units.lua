-- Quantities: arithmetic that checks dimensions, display in the unit written, messages with the script's line.
local test, equal, fails = ...
local stiction = require "stiction"
local units = stiction.units
local m, mm, s, ms, N, J, Pa, MPa, kg = units.m, units.mm, units.s, units.ms, units.N, units.J, units.Pa, units.MPa,
  units.kg

local function near(got, wanted)
  if math.abs(got - wanted) > 1e-14 * math.abs(wanted) then
    error(("got %.17g, wanted %.17g"):format(got, wanted), 2)
  end
end

test("numbers come back in any unit of the dimension", function()
  near((5*mm):to("m"), 5e-3)
  near((5*mm):to("um"), 5000)
  near((20*J/m^2):to("N/m"), 20)
  near((10*MPa):to("N/mm^2"), 10)
end)

test("products and quotients carry their dimension, and pure ones are plain numbers", function()
  equal(math.type((6*mm)/(2*mm)), "float")
  near((6*mm)/(2*m), 3e-3)
  near((3*N*(2*mm)):to("J"), 6e-3)
  near((1/(2*ms)):to("Hz"), 500)
  near(((2*m)^3):to("m^3"), 8)
  near(((4*m^2)^0.5):to("m"), 2)
  near((1000*kg/m^3*(1*m/s)^2):to("Pa"), 1000)
end)

test("sums, differences, comparisons and signs", function()
  near((1*m + 5*mm):to("mm"), 1005)
  near((1*m - 5*mm):to("mm"), 995)
  near((-(5*mm)):abs():to("mm"), 5)
  equal(5*mm < 1*m, true)
  equal(1*m <= 1000*mm, true)
  equal(1*m == 1000*mm, true)
  equal(1*m == 1*s, false)
end)

test("a quantity is shown in the unit it was written in", function()
  equal(tostring(5*mm), "5 mm")
  equal(tostring(333.3*mm/s), "333.3 mm/s")
  equal(tostring(1000*kg/m^3), "1000 kg/m^3")
  equal(tostring(20*units("J/m^2")), "20 J/m^2")
  equal(tostring(3*mm*mm), "3 mm^2")
  equal("v = " .. 2*mm/s, "v = 2 mm/s")
end)

test("any unit text is parsed", function()
  near((2e9*units("N/m^3")):to("Pa/m"), 2e9)
  near((0.1*units("N s/m")):to("kg/s"), 0.1)
  equal(units("1"), 1.0)
  near(30*units.deg, math.pi/6)
end)

test("dimensions that differ are refused, with the line", function()
  fails("units.lua:59: cannot add 3 m and 2 s: the dimensions differ", function()
    return 3*m + 2*s
  end)
  fails("cannot subtract 3 m and the pure number 2", function() return 3*m - 2 end)
  fails("cannot compare 3 m and 2 Pa", function() return 3*m < 2*Pa end)
  fails("cannot be written in 'mm'", function() return (3*s):to("mm") end)
  fails("fractional dimension", function() return (3*s)^0.5 end)
  fails("exponent must be a pure number", function() return (3*s)^(1*m) end)
end)

test("mistakes in units are told", function()
  fails("unknown unit 'mmm'; did you mean 'mm'?", function() return units.mmm end)
  fails("unknown unit 'parsec/s'", function() return units("parsec/s") end)
  fails('a unit is a text like "mm/s", not a table', function() return units { 1 } end)
  fails('a unit is a text like "mm/s", not 5', function() return (3*m):to(5) end)
  fails('a unit is a text like "mm/s", not nil', function() return (3*m):to() end)
  fails("a quantity has no 'value'", function() return (3*m).value end)
  fails("a quantity cannot be changed", function() (3*m).x = 2 end)
  fails("cannot multiply 1 m and a string", function() return 1*m*"x" end)
end)
