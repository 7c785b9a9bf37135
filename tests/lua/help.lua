-- The columns of probes as help shows them: those of every kind, with units and meanings.
local test, equal = ...
local columns = require "stiction.cli.columns"
local engine = require "stiction.engine"

local probes
for _, category in ipairs(engine.catalog()) do
  probes = category.name == "probe" and category.kinds or probes
end

local function unit_of(kind, name)
  for _, column in ipairs(columns.by_kind(probes)[kind]) do
    if column[1] == name then
      return column[2]
    end
  end
end

test("every kind of probe tells its columns", function()
  local found = columns.by_kind(probes)
  for _, kind in ipairs(probes) do
    equal(#found[kind.name] > 0, true)
    for _, column in ipairs(found[kind.name]) do
      equal(#column[2] > 0 and #column[3] > 0, true)
    end
  end
  equal(unit_of("contact", "force_y"), "N (N/m in plane strain)")
  equal(unit_of("contact_line", "friction_2"), "Pa (in space)")
  equal(unit_of("force", "moment"), "N (in the plane)")
  equal(unit_of("momentum", "l"), "N s (in the plane)")
  equal(unit_of("node", "u_x"), "m")
  equal(unit_of("contact", "gap_mean"), "m (of half spaces)")
  equal(unit_of("energy", "stabilisation_loss"), "J (J/m in plane strain)")
  equal(unit_of("energy", "relaxation_loss"), "J (J/m in plane strain)")
  equal(unit_of("energy", "unaccounted"), "J (J/m in plane strain)")
end)
