-- The time schemes that studies compare, each with its settings and what theory says of it.
local fault = require "stiction.fault"
local parts = require("stiction.parts").constructors()

local schemes = {}

-- name, kind, settings, order: of accuracy on a smooth problem that has a contact surface, whose nodes "implicit"
-- integrates by backward Euler. recursion: what reference.oscillator calls it, where contact nodes move like all others.
local list = {}

local function add(name, kind, settings, more)
  list[#list + 1] = { name = name, kind = kind, settings = settings, order = more.order, recursion = more.recursion }
end

local function add_theta_xi()
  local function jean(theta, xi) return { "jean", theta, xi } end
  add("default", "theta_xi", {}, { order = 1 })
  add("cells", "theta_xi", { contact_inertia = "cells" }, { order = 1 })
  add("paper", "theta_xi", { theta = 0.5, xi = 0.5, contact_weight = 1, contact_inertia = "full" },
    { order = 2, recursion = jean(0.5, 0.5) })
  add("paper_055", "theta_xi", { theta = 0.55, xi = 0.55, contact_weight = 1, contact_inertia = "full" },
    { order = 1, recursion = jean(0.55, 0.55) })
  add("backward_euler", "theta_xi", { theta = 1, xi = 1, contact_weight = 1, contact_inertia = "full" },
    { order = 1, recursion = jean(1, 1) })
  add("half_one", "theta_xi", { theta = 0.5, xi = 1, contact_weight = 1, contact_inertia = "full" },
    { order = 1, recursion = jean(0.5, 1) })
  add("averaged", "theta_xi", { theta = 0.5, xi = 0.5, contact_weight = 0.5, contact_inertia = "full" },
    { order = 2, recursion = jean(0.5, 0.5) })
  add("massless", "theta_xi", { theta = 0.5, xi = 0.5, contact_inertia = "none" }, { order = 2 })
  add("massless_backward", "theta_xi", { theta = 1, xi = 1, contact_inertia = "none" }, { order = 1 })
  add("damped", "theta_xi", { theta = 0.55, xi = 0.55, contact_inertia = "implicit" }, { order = 1 })
  add("paper_velocity", "theta_xi", { theta = 0.5, xi = 0.5, contact_inertia = "full", contact_level = "velocity" },
    { order = 2, recursion = jean(0.5, 0.5) })
  add("default_velocity", "theta_xi", { contact_level = "velocity" }, { order = 1 })
  add("massless_velocity", "theta_xi", { theta = 0.5, xi = 0.5, contact_inertia = "none", contact_level = "velocity" },
    { order = 2 })
  add("moreau_jean", "moreau_jean", {}, { order = 2, recursion = jean(0.5, 0.5) })
  add("moreau_jean_elastic", "moreau_jean", { restitution = 1 }, { order = 2, recursion = jean(0.5, 0.5) })
  add("moreau_jean_055", "moreau_jean", { theta = 0.55 }, { order = 1, recursion = jean(0.55, 0.55) })
end

--- With every cure of the contact nodes, at both levels.
local function add_cures(kind, settings, recursion)
  for _, level in ipairs { "position", "velocity" } do
    for _, inertia in ipairs { "full", "implicit", "none" } do
      local own = { contact_inertia = inertia, contact_level = level }
      for key, value in pairs(settings) do
        own[key] = value
      end
      local cure = inertia == "none" and "massless" or inertia
      add(kind .. "_" .. cure .. (level == "velocity" and "_velocity" or ""), kind, own,
        { order = inertia == "implicit" and 1 or 2, recursion = inertia == "full" and recursion or nil })
    end
  end
end

add_theta_xi()
add_cures("newmark", {}, { "newmark", 0.25, 0.5 })
add("newmark_damped", "newmark", { beta = 0.3025, gamma = 0.6, contact_inertia = "full" },
  { order = 1, recursion = { "newmark", 0.3025, 0.6 } })
add_cures("generalised_alpha", { rho_inf = 0.8 }, { "generalised_alpha", 0.8 })
add_cures("hht", { alpha = -0.05 }, { "hht", -0.05 })
add("central_difference", "central_difference", {}, { order = 2, recursion = { "central_difference" } })

local by_name, names = {}, {}
for i, entry in ipairs(list) do
  by_name[entry.name], names[i] = entry, entry.name
end

--- All names, in the order of the list.
function schemes.names()
  return table.move(names, 1, #names, 1, {})
end

--- {name =, kind =, settings =, order =, recursion = nil | {...}}; do not change it.
function schemes.about(name)
  return by_name[name] or fault.script("there is no scheme '%s'%s; schemes: %s", tostring(name),
    fault.meant(name, names), table.concat(names, ", "))
end

--- The part of a scene.
function schemes.make(name)
  local entry = schemes.about(name)
  return parts.scheme[entry.kind](entry.settings)
end

return schemes
