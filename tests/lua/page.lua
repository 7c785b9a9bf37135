-- The reference as one page holds everything that scripts can name, each with a meaning.
local test, equal = ...
local check = require "stiction.check"
local columns = require "stiction.cli.columns"
local describe = require "stiction.cli.describe"
local docs = require "stiction.cli.docs"
local engine = require "stiction.engine"
local figure_keys = require "stiction.figure_keys"
local ordered = require "stiction.ordered"
local stiction = require "stiction"

local page = require "stiction.cli.page"()

--- The section with this id, "" if there is none.
local function section(id)
  local from = page:find('<section id="' .. id .. '">', 1, true)
  return from and page:sub(from, page:find("</section>", from, true)) or ""
end

local function row(id, name)
  return section(id):match("<tr><td><code>" .. name:gsub("%p", "%%%0") .. "</code></td>(.-)</tr>") or "no row"
end

--- Fails where a row lacks one of its cells.
local function need_row(id, name)
  equal(id .. " " .. name .. " " .. tostring(row(id, name):find("<td></td>", 1, true) or row(id, name):find("no row")),
    id .. " " .. name .. " nil")
end

test("every part of a scene with each parameter, and the columns of probes", function()
  for _, category in ipairs(engine.catalog()) do
    local recorded = category.name == "probe" and columns.by_kind(category.kinds) or {}
    for _, kind in ipairs(category.kinds) do
      local id = describe.call(category, kind)
      for _, parameter in ipairs(kind.parameters) do
        need_row(id, parameter.name)
      end
      for _, column in ipairs(recorded[kind.name] or {}) do
        need_row(id, column[1])
      end
      equal(id .. tostring(section(id) ~= ""), id .. "true")
    end
  end
end)

test("every key of figures and every unit", function()
  for _, entry in ipairs(figure_keys.tables) do
    for _, key in ipairs(entry[3]) do
      need_row("figure." .. entry[1], key[1])
    end
  end
  for _, word in ipairs(engine.unit_words()) do
    need_row("unit words", word)
  end
end)

local documented = {}
for _, entry in ipairs(docs.functions()) do
  documented[entry.name] = entry.meaning
end

--- The functions of a table as scripts see it, and of the tables in it.
local function need_functions(t, prefix, without)
  for _, name in ipairs(ordered.keys(t)) do
    local value = rawget(t, name)
    if type(value) == "table" then
      need_functions(value, prefix .. name .. ".", without)
    elseif type(value) == "function" and not without[name] then
      local meaning = documented[prefix .. name]
      equal(prefix .. name .. ": " .. tostring(meaning ~= nil and #meaning > 0), prefix .. name .. ": true")
      equal(section(prefix .. name) ~= "", true)
    end
  end
end

test("every function that scripts can call, with what it gives", function()
  need_functions(stiction.numeric, "stiction.numeric.", {})
  need_functions(stiction.schemes, "stiction.schemes.", {})
  need_functions(stiction.figure, "stiction.figure.", { spec = true })
  need_functions(check.recorder(), "check.", {})
  for _, path in ipairs(engine.list(engine.library_root() .. "/stiction/reference", false)) do
    local name = path:match("([%w_]+)%.lua$")
    if name and name ~= "init" then
      need_functions(stiction.reference[name], "stiction.reference." .. name .. ".", {})
    end
  end
  for _, name in ipairs { "run:series", "run:columns", "run:max", "run:min", "run:at", "cases:where", "cases:find",
    "cases:values", "q:to", "q:abs", "q:display" } do
    equal(name .. " " .. tostring(#(documented[name] or "") > 0), name .. " true")
  end
end)

test("the page needs nothing but itself", function()
  for _, reach in ipairs { "src=", "href=", "@import", "url(" } do
    equal(page:find(reach, 1, true), nil)
  end
end)
