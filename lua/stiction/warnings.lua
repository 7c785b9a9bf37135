-- What is known against cases before they run, told once for all that are alike.
local fault = require "stiction.fault"
local report = require "stiction.report"

local warnings = {}

local most_ids = 6 -- of the cases alike, by name

--- Notes that this case asks for this.
local function add_change(group, words, id)
  for _, change in ipairs(group.changes) do
    if change.words == words then
      change.ids[#change.ids + 1] = id
      return
    end
  end
  group.changes[#group.changes + 1] = words and { words = words, ids = { id } } or nil
end

local most_changes = 4 -- told of a group

--- The first number of per cent in a text.
local function per_cent(text)
  return tonumber(text:match "([%d.][%d.e+-]*) %%")
end

--- Is more told of in the one text than in the other?
local function is_worse(text, other)
  local own, least = per_cent(text), per_cent(other)
  return own ~= nil and least ~= nil and own > least
end

--- Warnings of one wording whatever their numbers, in the order of their first: {text = of the most per cent, changes = (what
--- each of them asks for, once: {words =, ids =}), ids =}.
function warnings.groups(told)
  local groups, by_words = {}, {}
  for _, entry in ipairs(told) do
    for _, warning in ipairs(entry.warnings or {}) do
      local words = warning.text:gsub("%d[%d.e+-]*", "#")
      local group = by_words[words]
      if not group then
        group = { text = warning.text, changes = {}, ids = {} }
        groups[#groups + 1], by_words[words] = group, group
      elseif is_worse(warning.text, group.text) then
        group.text = warning.text
      end
      add_change(group, warning.change, entry.id)
      if group.ids[#group.ids] ~= entry.id then
        group.ids[#group.ids + 1] = entry.id
      end
    end
  end
  return groups
end

--- "all 3 cases: a, b, c", of so many.
function warnings.cases_of(ids, count)
  if #ids == 1 then
    return "case " .. ids[1]
  end
  local shown = table.concat(ids, ", ", 1, math.min(#ids, most_ids))
  return ("%s: %s%s"):format(#ids == count and ("all %d cases"):format(count) or ("%d cases"):format(#ids), shown,
    #ids > most_ids and ", ..." or "")
end

--- What a group's cases ask for, a text each, and how many texts more there are.
function warnings.changes_of(group, count)
  local texts = {}
  for i = 1, math.min(#group.changes, most_changes) do
    local change = group.changes[i]
    texts[i] = change.words .. (#group.changes > 1 and (" (%s)"):format(warnings.cases_of(change.ids, count)) or "")
  end
  return texts, #group.changes - #texts
end

--- Prints the groups of told = {{id =, warnings =}}.
function warnings.show(told)
  for _, group in ipairs(warnings.groups(told)) do
    report.line("warning: %s (%s%s)", group.text, #group.ids > 1 and "or alike, in " or "", warnings.cases_of(group.ids, #told))
    local texts, more = warnings.changes_of(group, #told)
    for _, text in ipairs(texts) do
      report.line("  -> %s", text)
    end
    if more > 0 then
      report.line("  and %d more, which 'stiction explain STUDY --case ID' tells", more)
    end
  end
end

--- Bad input if there is any.
function warnings.refuse(told)
  local count = #warnings.groups(told)
  if count > 0 then
    fault.input("--strict: %d warning%s; mend what they say, or run without --strict", count, count > 1 and "s" or "")
  end
end

return warnings
