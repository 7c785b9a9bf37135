-- What the points of a measured curve have in common by their noise, in standard errors: lists made independent of each other ("whitened":
-- the inverse of the Cholesky factor of the correlations, times them), and back.
local engine = require "stiction.engine"
local linear = require "stiction.fit.linear"
local numeric = require "stiction.numeric"

local noise = {}

local least = 1e-12 -- of a value that is foretold

local Course = {}
Course.__index = Course

--- Noise that goes on along rising xs as exp(-|x - x'| / length) (Ornstein and Uhlenbeck's process), beside what each point has for itself:
--- shares[i] is the part of a point's standard error that goes on, 1 if there are none. Kalman's filter, which is exact for it.
function noise.along(xs, length, shares)
  local own = { rho = {}, share = {}, gain = {}, root = {} }
  local variance = 1 -- of what goes on, foretold by the points before
  for i, x in ipairs(xs) do
    local rho = i > 1 and math.exp(-(x - xs[i - 1]) / length) or 0
    local share = shares and shares[i] or 1
    variance = i > 1 and rho ^ 2 * variance + 1 - rho ^ 2 or 1
    local whole = share ^ 2 * variance + 1 - share ^ 2
    own.rho[i], own.share[i], own.root[i] = rho, share, math.sqrt(whole)
    own.gain[i] = variance * share / whole
    variance = variance * (1 - share ^ 2) / whole
  end
  return setmetatable(own, Course)
end

function Course:whitened(list)
  local own, foretold = {}, 0
  for i, value in ipairs(list) do
    foretold = self.rho[i] * foretold
    local new = value - self.share[i] * foretold
    own[i] = new / self.root[i]
    foretold = foretold + self.gain[i] * new
  end
  return own
end

function Course:coloured(list)
  local own, foretold = {}, 0
  for i, value in ipairs(list) do
    foretold = self.rho[i] * foretold
    local new = value * self.root[i]
    own[i] = self.share[i] * foretold + new
    foretold = foretold + self.gain[i] * new
  end
  return own
end

--- The logarithm of the determinant of the correlations.
function Course:log_determinant()
  local sum = 0
  for _, root in ipairs(self.root) do
    sum = sum + 2 * math.log(root)
  end
  return sum
end

--- The trace of the inverse of the correlations.
function Course:inverse_trace()
  local sum = 0
  for i in ipairs(self.root) do
    sum = sum + 1 / self.root[i] ^ 2
    local foretold, k = self.gain[i], i + 1 -- by a value of 1 at i alone
    while k <= #self.root and foretold > least do
      foretold = self.rho[k] * foretold
      local new = -self.share[k] * foretold
      sum, foretold = sum + (new / self.root[k]) ^ 2, foretold + self.gain[k] * new
      k = k + 1
    end
  end
  return sum
end

local Table = {}
Table.__index = Table

--- Noise of any correlations, a list of rows; nil and their least eigenvalue where they are none.
function noise.of_correlations(R)
  local L, trace = engine.cholesky(R)
  if not L then
    return nil, trace
  end
  return setmetatable({ L = L, trace = trace }, Table)
end

function Table:inverse_trace()
  return self.trace
end

function Table:whitened(list)
  local own = {}
  for i, row in ipairs(self.L) do
    local sum = list[i]
    for k = 1, i - 1 do
      sum = sum - row[k] * own[k]
    end
    own[i] = sum / row[i]
  end
  return own
end

function Table:coloured(list)
  return numeric.map(self.L, function(row)
    local sum = 0
    for k, factor in ipairs(row) do
      sum = sum + factor * list[k]
    end
    return sum
  end)
end

--- How many independent points tell a constant as well as so many of this noise.
function noise.effective(own, count)
  local ones = {}
  for i = 1, count do
    ones[i] = 1
  end
  ones = own:whitened(ones)
  return linear.dot(ones, ones)
end

--- By how much what each of so many points has for itself grows when lists are whitened, root mean square.
function noise.roughened(own, count)
  return math.sqrt(own:inverse_trace() / count)
end

return noise
