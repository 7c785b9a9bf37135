-- What an output holds as an RO-Crate (1.1) of the Workflow Run Crate profile (0.5): the study is the workflow, each
-- case a run of it.
local archive = require "stiction.archive"
local engine = require "stiction.engine"
local ordered = require "stiction.ordered"
local provenance = require "stiction.provenance"

local crate = {}

local profiles = {
  { "https://w3id.org/ro/wfrun/process/0.5", "Process Run Crate", "0.5" },
  { "https://w3id.org/ro/wfrun/workflow/0.5", "Workflow Run Crate", "0.5" },
  { "https://w3id.org/workflowhub/workflow-ro-crate/1.0", "Workflow RO-Crate", "1.0" },
}
local contexts = { "https://w3id.org/ro/crate/1.1/context", "https://w3id.org/ro/terms/workflow-run/context" }

local formats = { csv = "text/csv", json = "application/json", png = "image/png", svg = "image/svg+xml",
  pdf = "application/pdf", html = "text/html", h5 = "application/x-hdf5", lua = "text/x-lua", pvd = "application/xml",
  vtu = "application/xml", vti = "application/xml", ogv = "video/ogg", msh = "model/mesh", stl = "model/stl",
  txt = "text/plain" }

local function id_of(path)
  return (path:gsub("[^%w%-._~/+@=]", function(sign) return ("%%%02X"):format(sign:byte()) end))
end

local function ref(id)
  return { ["@id"] = id }
end

local Graph = {}
Graph.__index = Graph

function Graph:add(id, kind, entity)
  entity["@id"], entity["@type"] = id, kind
  self.list[#self.list + 1], self.by_id[id] = entity, entity
  return entity
end

local function add_files(graph, folder, files, sums)
  for _, path in ipairs(files) do
    graph:add(id_of(path), "File", { name = path, contentSize = ("%d"):format(engine.file_size(folder .. "/" .. path)),
      sha256 = sums[path], encodingFormat = formats[path:match("%.(%w+)$")] })
  end
end

local function add_profiles(graph)
  for _, profile in ipairs(profiles) do
    graph:add(profile[1], "CreativeWork", { name = profile[2], version = profile[3] })
  end
  graph:add("#lua", "ComputerLanguage", { name = "Lua", version = "5.4", url = "https://www.lua.org/" })
  graph:add("#stiction", "SoftwareApplication", { name = "Stiction", softwareVersion = engine.version })
end

--- A slot of the study that its cases fill or give.
local function add_slot(graph, id, name, unit, additional)
  if not graph.by_id[id] then
    graph:add(id, "FormalParameter", { name = name, additionalType = additional, unitText = unit ~= "" and unit or nil,
      conformsTo = ref "https://bioschemas.org/profiles/FormalParameter/1.0-RELEASE" })
  end
  return ref(id)
end

local kinds_of_value = { number = "Float", string = "Text", boolean = "Boolean" }

--- The values that a case was given, and their slots, added to `inputs`.
local function add_values(graph, case, inputs)
  local list = {}
  for _, name in ipairs(ordered.keys(case.parameters)) do
    local value, unit = case.parameters[name], ""
    if type(value) == "table" then
      value, unit = value.value, tostring(value.unit or "")
    end
    local slot, id = "#parameter-" .. id_of(name), ("#%s/%s"):format(id_of(case.name), id_of(name))
    inputs[slot] = add_slot(graph, slot, name, unit, kinds_of_value[type(value)] or "Text")
    graph:add(id, "PropertyValue", { name = name, value = type(value) == "number" and engine.number_text(value)
      or tostring(value), unitText = unit ~= "" and unit or nil, exampleOfWork = ref(slot) })
    list[#list + 1] = ref(id)
  end
  return list
end

--- The kept files that a case was made of, the study's own first; those that are in the archive.
local function source_of(graph, case)
  local list = {}
  for _, file in ipairs(provenance.files_of(case.ended) or {}) do
    local id = id_of(provenance.name_of(file))
    list[#list + 1] = graph.by_id[id] and ref(id) or nil
  end
  return list
end

--- Marks a kept study file as a workflow.
local function add_workflow(graph, id, about)
  local entity = graph.by_id[id]
  entity["@type"], entity.programmingLanguage = { "File", "SoftwareSourceCode", "ComputationalWorkflow" }, ref "#lua"
  entity.softwareRequirements, entity.name, entity.description = ref "#stiction", about.title, about.question
  return entity
end

local function results_of(graph, files, case)
  local list, front = {}, case.name .. "/"
  for _, path in ipairs(files) do
    if path:sub(1, #front) == front then
      list[#list + 1] = ref(id_of(path))
    end
  end
  for _, name in ipairs(ordered.keys(case.results)) do
    local id = ("#%s/result/%s"):format(id_of(case.name), id_of(name))
    local slot, value = "#result-" .. id_of(name), case.results[name]
    value = type(value) == "number" and engine.number_text(value) or tostring(value)
    graph:add(id, "PropertyValue", { name = name, value = value,
      exampleOfWork = ref(slot) })
    list[#list + 1] = ref(id)
  end
  return list
end

--- The run of a case. Its workflow is named in `workflows`.
local function add_run(graph, case, files, inputs, workflows, about)
  local run, source = type(case.ended.run) == "table" and case.ended.run or {}, source_of(graph, case)
  local values = add_values(graph, case, inputs)
  table.move(source, 2, #source, #values + 1, values)
  local finished, id = case.verdict == "finished", "#run-" .. id_of(case.name)
  if source[1] then
    workflows[#workflows + 1] = not workflows[source[1]["@id"]] and source[1]["@id"] or nil
    workflows[source[1]["@id"]] = add_workflow(graph, source[1]["@id"], about)
  end
  graph:add(id, "CreateAction", { name = "Case " .. case.name, instrument = source[1], object = values,
    result = results_of(graph, files, case), startTime = run.started, endTime = run.ended,
    actionStatus = "http://schema.org/" .. (finished and "CompletedActionStatus" or "FailedActionStatus"),
    error = not finished and (case.verdict .. ": " .. case.reason) or nil,
    description = run.processor and ("Stiction %s on %s"):format(tostring(run.version), run.processor) or nil })
  return ref(id)
end

local function refs_of(slots)
  local list = {}
  for _, id in ipairs(ordered.keys(slots)) do
    list[#list + 1] = ref(id)
  end
  return list
end

--- The licence as the root tells it: an entity of its own, or words where there is none.
local function license_of(graph, name)
  if not name then
    return "not stated"
  end
  local id = name:find "^https?://" and name or "https://spdx.org/licenses/" .. id_of(name)
  graph:add(id, "CreativeWork", { name = name, url = id })
  return ref(id)
end

--- Text of the metadata of an output's files. outcome: of outcomes.read; about: {title =, question =, license = (or
--- nil)}.
function crate.describe(outcome, files, about)
  local graph = setmetatable({ list = {}, by_id = {} }, Graph)
  graph:add(archive.metadata, "CreativeWork", { about = ref "./",
    conformsTo = { ref "https://w3id.org/ro/crate/1.1", ref(profiles[3][1]) } })
  local root = graph:add("./", "Dataset", { name = about.title, license = license_of(graph, about.license),
    description = about.question ~= "" and about.question or "Results of the study '" .. about.title .. "'",
    datePublished = engine.utc_now(), hasPart = {}, mentions = {}, conformsTo = {} })
  for i, profile in ipairs(profiles) do
    root.conformsTo[i] = ref(profile[1])
  end
  add_profiles(graph)
  add_files(graph, outcome.folder, files, archive.sums(outcome.folder, files))
  for i, path in ipairs(files) do
    root.hasPart[i] = ref(id_of(path))
  end
  local inputs, outputs, workflows = {}, {}, {}
  for _, column in ipairs(outcome.columns) do
    if column.kind == "result" then
      local slot = "#result-" .. id_of(column.of)
      outputs[slot] = add_slot(graph, slot, column.of, column.unit, "Float")
    end
  end
  for i, case in ipairs(outcome.cases) do
    root.mentions[i] = add_run(graph, case, files, inputs, workflows, about)
  end
  for _, id in ipairs(workflows) do
    workflows[id].input, workflows[id].output = refs_of(inputs), refs_of(outputs)
  end
  root.mainEntity = workflows[#workflows] and ref(workflows[#workflows]) or nil
  return engine.encode_json({ ["@context"] = contexts, ["@graph"] = graph.list }, 2) .. "\n"
end

return crate
