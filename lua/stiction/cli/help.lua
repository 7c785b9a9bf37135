-- stiction help: everything a scene can hold, from the engine's own descriptions; and how a study is written.
local columns = require "stiction.cli.columns"
local describe = require "stiction.cli.describe"
local engine = require "stiction.engine"
local fault = require "stiction.fault"
local figure_keys = require "stiction.figure_keys"
local page = require "stiction.cli.page"
local pages = require "stiction.cli.pages"
local report = require "stiction.report"

local function find(list, name)
  for _, entry in ipairs(list) do
    if entry.name == name then
      return entry
    end
  end
end

local function show_parameter(parameter)
  report.line("    %s: %s; %s", parameter.name, describe.range(parameter), describe.need(parameter))
  report.line("%s", report.wrapped(parameter.meaning, "        "))
end

local function show_kind(category, kind)
  report.line("%s{ ... }", describe.call(category, kind))
  report.line("%s", report.wrapped(kind.meaning, "    "))
  if pages.notes[kind.name] then
    report.line("%s", pages.notes[kind.name])
  end
  if kind.source ~= "" then
    report.line("%s", report.wrapped("Source: " .. kind.source, "    "))
  end
  for _, parameter in ipairs(kind.parameters) do
    show_parameter(parameter)
  end
end

--- What a probe records: the columns of its group in series.h5.
local function show_columns(kind)
  report.line("    Its columns, for run:series(\"NAME\", \"COLUMN\") and figures (\"NAME/COLUMN\"), NAME being the probe's in the scene:")
  local rows = {}
  for i, column in ipairs(kind) do
    rows[i] = { "        " .. column[1], column[2], column[3] }
  end
  report.table(rows)
end

--- The columns of one kind of probe, or of all.
local function show_probes(kinds, wanted)
  local found = columns.by_kind(kinds)
  for _, kind in ipairs(kinds) do
    if not wanted or kind.name == wanted then
      report.line("\n%s: %s", kind.name, kind.meaning)
      show_columns(found[kind.name])
    end
  end
end

local function show_figures()
  report.line("%s", pages.figure)
  for _, entry in ipairs(figure_keys.tables) do
    report.line("\n%s", entry[2])
    for _, key in ipairs(entry[3]) do
      report.line("    %s", key[1])
      report.line("%s", report.wrapped(key[2], "        "))
    end
  end
end

local function show_category(category)
  report.line("%s: %s", category.name, category.meaning)
  for _, kind in ipairs(category.kinds) do
    report.line()
    show_kind(category, kind)
  end
end

local function show_units()
  local rows = describe.units()
  table.insert(rows, 1, { "unit", "in SI", "" })
  report.line("%s", pages.units)
  report.table(rows)
end

local function show_overview(catalog)
  report.line("%s\nParts of a scene:", pages.overview)
  for _, category in ipairs(catalog) do
    local kinds = {}
    for i, kind in ipairs(category.kinds) do
      kinds[i] = kind.name
    end
    local alone = #kinds == 1 and kinds[1] == category.name
    report.line("  %s: %s%s", category.name, category.meaning, alone and "" or " (" .. table.concat(kinds, ", ") .. ")")
  end
end

--- Shows every kind called `topic`, or the one of a category ("load"); false if there is none.
local function show_kinds(catalog, topic, only)
  local found = false
  for _, category in ipairs(catalog) do
    local kind = (not only or category.name == only) and find(category.kinds, topic)
    if kind then
      show_kind(category, kind)
      if category.name == "probe" then
        show_probes(category.kinds, kind.name)
      end
      found = true
    end
  end
  return found
end

local function known_topics(catalog)
  local topics = { "units", "study", "commands", "new", "figure", "columns", "results", "derivatives", "solve", "trade", "fit",
    "sample", "peers" }
  for _, category in ipairs(catalog) do
    topics[#topics + 1] = category.name
    for _, kind in ipairs(category.kinds) do
      topics[#topics + 1] = kind.name
    end
  end
  return topics
end

--- What the page of commands says of one; nil if it is none.
local function of_command(topic)
  local lines = {}
  for line in (pages.commands .. "\n"):gmatch("([^\n]*)\n") do
    local goes_on = #lines > 0 and line:find("^ ")
    if line == "" or #lines > 0 and not goes_on then
      break -- other paragraphs are of all commands
    elseif goes_on or line:match("^%l+") == topic then
      lines[#lines + 1] = line
    end
  end
  return #lines > 0 and table.concat(lines, "\n") or nil
end

--- "materials" and "bodies" mean material and body.
local function singular(topic)
  return (topic:gsub("ies$", "y"):gsub("s$", ""))
end

local function write_page(folder)
  local made, reason = engine.make_folder(folder)
  if not made then
    fault.input("--html: no folder can be made at '%s': %s", folder, reason)
  end
  engine.write_file(folder .. "/index.html", page())
  report.line("%s/index.html", folder)
  return 0
end

return function(options)
  if options.html then
    return write_page(options.html)
  end
  local catalog, topic = engine.catalog(), options.topic
  local category_name, name = (topic or ""):match("^([%w_]+)%.([%w_]+)$")
  topic = name or topic
  if not topic then
    show_overview(catalog)
  elseif name and show_kinds(catalog, name, category_name) then
    return 0
  elseif topic == "units" then
    show_units()
  elseif topic == "figure" or topic == "figures" then
    show_figures()
  elseif topic == "columns" then
    show_probes(find(catalog, "probe").kinds)
  elseif pages[topic] then
    report.line("%s", pages[topic])
  else
    local category, command = find(catalog, topic) or find(catalog, singular(topic)), of_command(topic)
    if category then
      show_category(category)
      if category.name == "probe" then
        show_probes(category.kinds)
      end
    elseif command then
      report.line("%s\n\n'stiction %s --help' lists its options.", command, topic)
    elseif not show_kinds(catalog, topic) then
      local meant = fault.meant(topic, known_topics(catalog))
      fault.input("there is no help on '%s'%s", options.topic, #meant > 0 and meant or "; 'stiction help' tells what there is help on")
    end
  end
  return 0
end
