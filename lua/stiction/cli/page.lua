-- The whole reference as one page that needs nothing else: `stiction help --html DIR`.
local columns = require "stiction.cli.columns"
local describe = require "stiction.cli.describe"
local docs = require "stiction.cli.docs"
local engine = require "stiction.engine"
local figure_keys = require "stiction.figure_keys"
local html = require "stiction.html"
local pages = require "stiction.cli.pages"

local head = [[
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Stiction %s: reference</title><style>
%s
input { font: inherit; width: 100%%; box-sizing: border-box; padding: .4rem }
header { position: sticky; top: 0; background: #fff; padding: .5rem 0 } .hidden { display: none }
</style></head><body><header><h1>Stiction %s</h1>
<input id="search" type="search" placeholder="search every name, parameter, column and meaning" aria-label="search"></header>
]]

local tail = [[
<script>
const entries = [...document.querySelectorAll("section")];
const texts = entries.map(entry => entry.textContent.toLowerCase());
document.getElementById("search").addEventListener("input", event => {
  const words = event.target.value.toLowerCase().split(/\s+/).filter(word => word);
  entries.forEach((entry, i) => entry.classList.toggle("hidden", !words.every(word => texts[i].includes(word))));
});
</script></body></html>
]]

local function section(id, title, body)
  return ('<section id="%s"><h3><code>%s</code></h3>\n%s\n</section>'):format(html.plain(id), html.plain(title), body)
end

local function prose(id, title, text)
  return section(id, title, "<pre>" .. html.plain(text) .. "</pre>")
end

local function parameters(kind)
  local list = {}
  for i, parameter in ipairs(kind.parameters) do
    list[i] = { parameter.name, describe.range(parameter), describe.need(parameter), parameter.meaning }
  end
  return #list > 0 and html.rows(list, { "parameter", "range", "default", "meaning" }) or ""
end

local function part(category, kind, recorded)
  local call = describe.call(category, kind)
  local body = { ("<p>%s</p>"):format(html.plain(kind.meaning)) }
  if pages.notes[kind.name] then
    body[#body + 1] = "<pre>" .. html.plain(pages.notes[kind.name]) .. "</pre>"
  end
  if kind.source ~= "" then
    body[#body + 1] = "<p>Source: " .. html.plain(kind.source) .. "</p>"
  end
  body[#body + 1] = parameters(kind)
  if recorded then
    body[#body + 1] = "<p>Records:</p>" .. html.rows(recorded, { "column", "unit", "meaning" })
  end
  return section(call, "stiction." .. call, table.concat(body, "\n"))
end

local function add_parts(list)
  for _, category in ipairs(engine.catalog()) do
    list[#list + 1] = ("<h2>%s: %s</h2>"):format(html.plain(category.name), html.plain(category.meaning))
    local recorded = category.name == "probe" and columns.by_kind(category.kinds) or {}
    for _, kind in ipairs(category.kinds) do
      list[#list + 1] = part(category, kind, recorded[kind.name])
    end
  end
end

local function add_figures(list)
  list[#list + 1] = "<h2>Figures</h2>" .. prose("figure", "figures", pages.figure)
  for _, entry in ipairs(figure_keys.tables) do
    list[#list + 1] = section("figure." .. entry[1], entry[1], ("<p>%s</p>"):format(html.plain(entry[2]))
      .. html.rows(entry[3], { "key", "meaning" }))
  end
end

local function add_functions(list)
  list[#list + 1] = "<h2>Functions</h2>"
  for _, entry in ipairs(docs.functions()) do
    list[#list + 1] = section(entry.name, entry.call, ("<p>%s</p>"):format(html.plain(entry.meaning)))
  end
end

local function add_units(list)
  list[#list + 1] = "<h2>Units</h2>" .. prose("units", "units", pages.units)
  list[#list + 1] = section("unit words", "unit words", html.rows(describe.units(), { "unit", "in SI", "of" }))
end

--- The page, HTML.
return function()
  local list = { head:format(engine.version, html.style, engine.version), "<h2>Commands and studies</h2>" }
  for _, name in ipairs { "commands", "study", "results", "derivatives", "solve", "trade", "fit", "sample", "peers" } do
    list[#list + 1] = prose(name, name, pages[name])
  end
  add_parts(list)
  add_figures(list)
  add_functions(list)
  add_units(list)
  list[#list + 1] = tail
  return table.concat(list, "\n")
end
