-- Walking tables in an order that does not depend on hashing, so that every run repeats.
local ordered = {}

local rank = { number = 1, string = 2 }

local function before(a, b)
  local kind_a, kind_b = rank[type(a)] or 3, rank[type(b)] or 3
  if kind_a ~= kind_b then
    return kind_a < kind_b
  end
  if kind_a == 3 then
    return tostring(a) < tostring(b)
  end
  return a < b
end

--- Keys of t: numbers, then names, each ascending.
function ordered.keys(t)
  local keys = {}
  for key in next, t do
    keys[#keys + 1] = key
  end
  table.sort(keys, before)
  return keys
end

--- Keys that one or the other has, in the same order.
function ordered.keys_of(one, other)
  local both = {}
  for _, t in ipairs { one, other } do
    for key in next, t do
      both[key] = true
    end
  end
  return ordered.keys(both)
end

--- As Lua's pairs, honouring __pairs, in the order of `keys`.
function ordered.pairs(t)
  local meta = getmetatable(t)
  if type(meta) == "table" and meta.__pairs then
    return meta.__pairs(t)
  end
  local keys, i = ordered.keys(t), 0
  return function()
    i = i + 1
    local key = keys[i]
    if key ~= nil then
      return key, t[key]
    end
  end
end

return ordered
