-- Does what --check-accuracy claims hold? Changed scenes of four studies, each with coarse settings, with every setting a
-- level finer by itself, and with all of them two levels finer, which stands for the truth.
--
--     ./stiction run studies/trade/claims            46 scenes
--     ./stiction run studies/trade/claims --quick    7 scenes; run in CI
local stiction = require "stiction"
local scenes = require "scenes"
local claim = stiction.claim

local studies = {
  sphere = require "../sphere_indentation", plate = require "../plate_on_cylinder", hertz = require "../hertz",
  bar = require "../bar_impact",
}

local by_name, runs, quick = {}, {}, {}
for _, scene in ipairs(scenes) do
  local study = studies[scene.study]
  scene.p = claim.parameters(study, scene.set)
  scene.variants = claim.variants(claim.knobs(study), scene.p)
  scene.truth = claim.finer(study, scene.p, 2)
  by_name[scene.name] = scene
  local names = { "base", "truth" }
  for i, variant in ipairs(scene.variants) do
    scene["finer" .. i] = claim.with(scene.p, variant)
    names[#names + 1] = "finer" .. i
  end
  for _, name in ipairs(names) do
    runs[#runs + 1] = { scene = scene.name, run = name }
    quick[#quick + 1] = scene.quick and runs[#runs] or nil
  end
end

local function parameters(p)
  local scene = by_name[p.scene]
  return p.run == "base" and scene.p or scene[p.run]
end

--- Makes a case of this study one of the study whose scene it runs: its parameters and results.
local function as_own(case, study, p)
  case.p, case.results = p, {}
  for _, entry in ipairs(study.results) do
    case.results[entry.name] = entry.compute(case, p)
  end
  return case
end

--- What was claimed of a scene and how far it was off, by quantity; nil where a run is missing.
local function judged(cases, scene)
  local study, list, by_id = studies[scene.study], {}, {}
  for _, case in ipairs(cases) do by_id[case.id] = case end
  local base, truth = by_id[scene.name .. "_base"], by_id[scene.name .. "_truth"]
  if not base or not truth then return nil end
  for i = 1, #scene.variants do
    list[i] = as_own(by_id[scene.name .. "_finer" .. i], study, scene["finer" .. i])
  end
  return claim.judge(study, as_own(base, study, scene.p), scene.variants, list, as_own(truth, study, scene.truth))
end

local function percent(x) return 100 * x end

--- {scene =, quantity =, claim =, error =} of all that decides, and the scenes where all of that holds.
local function verdicts(cases)
  local rows, held, count = {}, 0, 0
  for _, scene in ipairs(scenes) do
    local found, good = judged(cases, scene), true
    for name, its in pairs(found or {}) do
      if its.judged and not its.unmoved then
        rows[#rows + 1] = { scene = scene, quantity = name, claim = its.relative, error = its.error, changes = its.changes }
        good = good and its.error <= its.relative
      end
    end
    count, held = count + (found and 1 or 0), held + (found and good and 1 or 0)
  end
  return rows, held, count
end

return stiction.study {
  title = "How near is near: what --check-accuracy claims, against runs two levels finer",
  question = "Does the true error lie within the claim in 95 of 100 changed scenes?",
  sweep = runs, quick = { sweep = quick },
  case_id = function(p) return p.scene .. "_" .. p.run end,
  scene = function(p) return studies[by_name[p.scene].study].scene(parameters(p)) end,
  check = function(cases, check)
    local rows, held, count = verdicts(cases)
    local words, single, wide = {}, 0, 0
    for i, row in ipairs(rows) do
      local changes = {}
      for k, variant in ipairs(row.scene.variants) do
        changes[k] = ("%s %.3g"):format(variant.knob, percent(row.changes[k]))
      end
      words[i] = { row.scene.name .. ": " .. row.quantity, row.scene.words, percent(row.claim), percent(row.error),
        table.concat(changes, "; ") }
      single = single + (row.error <= row.claim and 1 or 0)
      wide = wide + (row.claim > 10 * row.error and 1 or 0)
    end
    check.table { title = "Claims and errors", columns = { "scene: quantity", "changed", "claim, %", "error, %", "changes, %" },
      rows = words }
    check.within("share of scenes where every claim holds", held / count, 0.95, 1)
    check.within("share of claims that hold", single / #rows, 0.95, 1)
    check.within("share of claims more than ten times the error: a claim that says nothing holds always", wide / #rows, 0, 0.5)
  end,
  figures = function(cases)
    local curves, colour = {}, { sphere = 1, plate = 2, hertz = 3, bar = 4 }
    local points = {}
    for _, row in ipairs(verdicts(cases)) do
      local own = points[row.scene.study] or { x = {}, y = {} }
      points[row.scene.study] = own
      own.x[#own.x + 1], own.y[#own.y + 1] = math.max(percent(row.error), 1e-4), math.max(percent(row.claim), 1e-4)
    end
    for _, name in ipairs { "sphere", "plate", "hertz", "bar" } do
      local own = points[name]
      if own then
        curves[#curves + 1] = { label = name, x = own.x, y = own.y, colour = colour[name], style = "points" }
      end
    end
    curves[#curves + 1] = { label = "claim = error", x = { 1e-2, 1e3 }, y = { 1e-2, 1e3 }, colour = 0, style = "dash" }
    return { stiction.figure.lines { name = "claims", title = "below the line the claim failed",
      legend = "below", x = { label = "error against two levels finer, %", log = true }, y = { label = "claim, %", log = true },
      curves = curves } }
  end,
}
