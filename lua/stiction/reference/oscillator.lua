-- Time schemes on the free oscillator u'' = -omega^2 u, by the formulas of their papers. Pure numbers.
local oscillator = {}

-- One step of (u, dt v, dt^2 a), z = (omega dt)^2.

--- Jean 1999: u at theta, the force at xi of the step.
local function jean(theta, xi)
  return function(u, v, z)
    local next_v = (v - z * (u + xi * (1 - theta) * v)) / (1 + z * xi * theta)
    return u + (1 - theta) * v + theta * next_v, next_v, 0
  end
end

--- Newmark's rates (Newmark 1959) with M at 1 - alpha_m and F at 1 - alpha_f of the step (Chung and
--- Hulbert 1993).
local function family(beta, gamma, alpha_m, alpha_f)
  return function(u, v, z, a)
    local coast = u + v + (0.5 - beta) * a
    local next_a = (-z * ((1 - alpha_f) * coast + alpha_f * u) - alpha_m * a) / (1 - alpha_m + z * (1 - alpha_f) * beta)
    return coast + beta * next_a, v + (1 - gamma) * a + gamma * next_a, next_a
  end
end

local makers = {
  jean = jean,
  newmark = function(beta, gamma) return family(beta, gamma, 0, 0) end,
  generalised_alpha = function(rho)
    local m, f = (2 * rho - 1) / (rho + 1), rho / (rho + 1)
    return family((1 - m + f) ^ 2 / 4, 0.5 - m + f, m, f)
  end,
  --- Hilber, Hughes and Taylor 1977.
  hht = function(alpha) return family((1 - alpha) ^ 2 / 4, 0.5 - alpha, 0, -alpha) end,
  central_difference = function() -- velocity Verlet
    return function(u, v, z)
      local half = v - 0.5 * z * u
      return u + half, half - 0.5 * z * (u + half), 0
    end
  end,
}

local function march(method, phase, steps, u, v)
  local step = makers[method[1]](table.unpack(method, 2))
  local z = phase ^ 2
  local a = -z * u
  v = v * phase
  for _ = 1, steps do
    u, v, a = step(u, v, z, a)
  end
  return u, v / phase
end

--- u and v / omega after `steps` steps from u = 0, v = omega. method: {"jean", theta, xi}, {"newmark", beta, gamma},
--- {"generalised_alpha", rho_inf}, {"hht", alpha} or {"central_difference"}; phase: omega dt.
function oscillator.swing(method, phase, steps)
  return march(method, phase, steps, 0, 1)
end

--- The same from u = 1 at rest.
function oscillator.release(method, phase, steps)
  return march(method, phase, steps, 1, 0)
end

--- Kinetic + potential energy after these steps over that at the start, from u = 0 or at rest.
function oscillator.energy_kept(method, phase, steps, released)
  local u, v = march(method, phase, steps, released and 1 or 0, released and 0 or 1)
  return u ^ 2 + v ^ 2
end

--- Angular frequency of the n-th mode of a bar held at one end, rad/s, from equal linear cells of size h: with consistent
--- mass (c / h) sqrt(6 (1 - cos kh) / (2 + cos kh)), with lumped mass (2 c / h) sin(kh / 2), k = (n - 1/2) pi / L.
function oscillator.bar_frequency(c, length, h, n, lumped)
  local kh = (n - 0.5) * math.pi / length * h
  if lumped then
    return 2 * c / h * math.sin(kh / 2)
  end
  return c / h * math.sqrt(6 * (1 - math.cos(kh)) / (2 + math.cos(kh)))
end

--- Modes of that bar, of N equal cells, let go undeformed when every node between its ends weighs the same and the free
--- end nothing: list of {omega =, tip = amplitude at the free end over the sag at rest there, share = of the strain
--- energy of the sag}. The sag at node i is i (2 N - 1 - i) / (N (N - 1)) of that at the end; the nodal modes sin(k x) are
--- orthogonal with half the weight at the end.
function oscillator.sag_modes(c, length, cells, lumped)
  local modes, whole = {}, 0
  for n = 1, cells do
    local kh, projection = (n - 0.5) * math.pi / cells, 0
    for i = 1, cells do
      local sag = i * (2 * cells - 1 - i) / (cells * (cells - 1))
      projection = projection + (i == cells and 0.5 or 1) * sag * math.sin(kh * i)
    end
    local amplitude = projection * 2 / cells
    local energy = amplitude ^ 2 * (1 - math.cos(kh))
    whole = whole + energy
    modes[n] = { omega = oscillator.bar_frequency(c, length, length / cells, n, lumped),
      tip = amplitude * math.sin(kh * cells), share = energy }
  end
  for _, mode in ipairs(modes) do
    mode.share = mode.share / whole
  end
  return modes
end

return oscillator
