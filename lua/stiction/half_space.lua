-- Heights over the points of a half space, or of a rigid map, from a function.
local fault = require "stiction.fault"
local units = require "stiction.units"

local half_space = {}

local function si(value)
  if units.is_quantity(value) then
    return value.si
  end
  if type(value) ~= "number" then
    fault.script("size and points are needed as lists of numbers before heights can be a function of x and y")
  end
  return value
end

local function count_and_step(body, k)
  local count, length = si((body.points or {})[k]), si((body.size or {})[k])
  return math.floor(count), length / count, length
end

--- heights(x, y), of numbers in m, at the middles of the body's points: a list, along x first.
function half_space.sample(heights, body)
  local nx, dx, Lx = count_and_step(body, 1)
  local ny, dy, Ly = 1, 0, 0
  if type(body.points) == "table" and body.points[2] then
    ny, dy, Ly = count_and_step(body, 2)
  end
  local list = {}
  for j = 1, ny do
    for i = 1, nx do
      local x, y = (i - 0.5) * dx - Lx / 2, ny > 1 and (j - 0.5) * dy - Ly / 2 or 0
      local height = heights(x, y)
      if units.is_quantity(height) then
        height = height.si
      end
      if type(height) ~= "number" or height ~= height then
        fault.script("heights at (%g, %g) m are %s; the function has to give a number (m) everywhere", x, y,
          tostring(height))
      end
      list[#list + 1] = height
    end
  end
  return list
end

return half_space
