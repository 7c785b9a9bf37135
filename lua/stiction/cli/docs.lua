-- What the library's own sources say of the functions that scripts see: the comment above each.
local engine = require "stiction.engine"

local docs = {}

local root = engine.library_root() .. "/stiction/"

--- By file the words that scripts write where the source writes others.
local sources = {
  { "numeric.lua", { ["numeric."] = "stiction.numeric." } },
  { "relaxation.lua", { ["relaxation."] = "stiction.relaxation." } },
  { "sample.lua", { ["sample."] = "stiction.sample." }, without = { drawn = true } },
  { "schemes.lua", { ["schemes."] = "stiction.schemes." } },
  { "figure.lua", { ["figure."] = "stiction.figure." }, without = { spec = true } },
  { "case.lua", { ["Case:"] = "run:", ["Cases:"] = "cases:" } },
  { "check.lua", { ["recorder."] = "check." } },
  { "units.lua", { ["methods."] = "q:" } },
}

local function add_references()
  for _, path in ipairs(engine.list(root .. "reference", false)) do
    local name = path:match("([%w_]+)%.lua$")
    if name and name ~= "init" then
      local words = setmetatable({}, { __index = function(_, word)
        local rest = word:sub(1, #name + 1) == name .. "." and word:sub(#name + 2) or word
        return "stiction.reference." .. name .. "." .. rest
      end })
      sources[#sources + 1] = { "reference/" .. name .. ".lua", words }
    end
  end
end

add_references()

--- {call = "check.holds(name, held)", meaning =} of one function, or nil where scripts do not see it.
local function entry(source, owner, name, arguments, comment)
  local prefix = source[2][owner]
  if not prefix or (source.without or {})[name] then
    return nil
  end
  if prefix == "q:" then
    arguments = arguments:gsub("^q,?%s*", "")
  end
  return { name = prefix .. name, call = ("%s%s(%s)"):format(prefix, name, arguments), meaning = table.concat(comment, " ") }
end

local function read(source, found)
  local comment = {}
  for line in engine.read_file(root .. source[1]):gmatch("[^\n]*") do
    local words = line:match("^%s*%-%-%-%s?(.*)$")
    local owner, name, arguments = line:match("^%s*function ([%w_.]*[.:])([%w_]+)%((.-)%)")
    if not owner then
      owner, name = line:match("^([%w_.]+%.)([%w_]+) = %a[%w_]*%.%a[%w_]*$") -- that of another module
      arguments = "..."
    end
    if owner then
      found[#found + 1] = entry(source, owner, name, arguments, comment)
    end
    comment = words and comment or {}
    comment[#comment + 1] = words
  end
end

--- List of {name =, call =, meaning =}, "" where a function has no comment.
function docs.functions()
  local found = {}
  for _, source in ipairs(sources) do
    read(source, found)
  end
  return found
end

return docs
