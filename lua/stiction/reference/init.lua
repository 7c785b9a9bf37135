-- Reference solutions, one module each: pure functions of plain SI numbers, loaded when first named.
local engine = require "stiction.engine"
local fault = require "stiction.fault"

local folder = engine.library_root() .. "/stiction/reference"

local function names()
  local list = {}
  for _, path in ipairs(engine.list(folder, false)) do
    local name = path:match("([%w_]+)%.lua$")
    if name and name ~= "init" then
      list[#list + 1] = name
    end
  end
  return list
end

return setmetatable({}, {
  __index = function(reference, name)
    if type(name) ~= "string" or engine.kind_of_path(folder .. "/" .. name .. ".lua") ~= "file" then
      fault.script("there is no reference.%s%s; there are %s", tostring(name), fault.meant(name, names()),
        table.concat(names(), ", "))
    end
    local module = require("stiction.reference." .. name)
    rawset(reference, name, module)
    return module
  end,
})
