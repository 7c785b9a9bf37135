-- What a residual counts: its square, or less of one that is far out (robust losses).
local fault = require "stiction.fault"
local ordered = require "stiction.ordered"

local loss = {}

local bend = { huber = 1.345, soft = 1, cauchy = 2.385 } -- standard errors; huber, cauchy: 95 % efficient (Holland 1977)

-- By name: the loss of a residual r in standard errors, and half of its derivative.
local losses = {
  squares = function(r) return r * r, r end,
  huber = function(r, c)
    local size = math.abs(r)
    if size <= c then
      return r * r, r
    end
    return 2 * c * size - c * c, r > 0 and c or -c
  end,
  soft = function(r, c)
    local q = (r / c) ^ 2
    local root = math.sqrt(1 + q)
    return 2 * c * c * q / (root + 1), r / root
  end,
  cauchy = function(r, c)
    local q = (r / c) ^ 2
    return c * c * (q < 1e-5 and q - q * q / 2 or math.log(1 + q)), r / (1 + q)
  end,
}

--- Bad input if there is no such loss.
function loss.check(name)
  if not losses[name] then
    fault.script("study.fit: loss = '%s'%s; it is one of %s", tostring(name), fault.meant(tostring(name), ordered.keys(losses)),
      table.concat(ordered.keys(losses), ", "))
  end
end

--- Residuals whose squares are the losses, what each grows by with its own residual, and the sum of the losses.
function loss.of(name, residuals)
  local f, c, own, slopes, sum = losses[name], bend[name], {}, {}, 0
  for i, r in ipairs(residuals) do
    local value, half = f(r, c)
    own[i] = r < 0 and -math.sqrt(value) or math.sqrt(value)
    slopes[i] = own[i] ~= 0 and half / own[i] or 1
    sum = sum + value
  end
  return own, slopes, sum
end

return loss
