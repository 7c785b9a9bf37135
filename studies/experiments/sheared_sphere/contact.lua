-- The contact of a ball with a plate that moves by U(t) along x, from the histories of its points (probe.contact_line, with
-- the pair's direction along x): where each point is, how far inside the contact, what area the contact covers. Of a half,
-- y >= 0, the other half is the mirrored one.
local contact = {}

local columns = { "X", "Y", "slip", "slip_2", "area", "pressure", "gap" }

--- All histories that are needed, a list of columns per point.
function contact.read(run)
  local points = {}
  for k = 1, math.floor(run:series("line", "count")[1]) do
    points[k] = {}
    for _, name in ipairs(columns) do points[k][name] = run:series("line", name, k) end
  end
  return points
end

-- Distance inside the edge, m, negative outside, by Hertz's shapes at it: p^2 falls as 2 p0^2 / a, and the gap is
-- 8 sqrt(2) / (3 pi) a^2 / R (d / a)^3/2.
local function inside(pressure, gap, hertz)
  if pressure > 0 then return hertz.a * (pressure / hertz.peak) ^ 2 / 2 end
  return -hertz.a * (math.max(gap, 0) * 3 * math.pi * hertz.radius / (8 * math.sqrt(2) * hertz.a ^ 2)) ^ (2 / 3)
end

--- Points at the step `at`: reference and present place {X, Y, x, y}, m, reference area, m^2, and the share of it that is in
--- contact: whole where the edge is more than half a cell off. hertz: {a =, peak =, radius =}. The slip of a point in reach is its own way
--- less the plate's.
function contact.points(histories, U, at, hertz, cell)
  local list = {}
  for k, h in ipairs(histories) do
    list[k] = { X = h.X[at], Y = h.Y[at], x = h.X[at] + h.slip[at] + U, y = h.Y[at] + h.slip_2[at], area = h.area[at],
      share = math.min(1, math.max(0, 0.5 + inside(h.pressure[at], h.gap[at], hertz) / cell)) }
  end
  return list
end

-- The points within `radius` of one, and those of the mirrored half.
local function neighbours(points, p, radius)
  local list = {}
  for _, q in ipairs(points) do
    local far = (q.X - p.X) ^ 2
    if far + (q.Y - p.Y) ^ 2 < radius ^ 2 then list[#list + 1] = q end
    if q.Y > 0 and far + (q.Y + p.Y) ^ 2 < radius ^ 2 then list[#list + 1] = { X = q.X, Y = -q.Y, x = q.x, y = -q.y } end
  end
  return list
end

-- Area ratio of the surface about a point: det of the plane gradient of x by X, least squares over its neighbours.
local function stretch(points, p, radius)
  local XX, XY, YY, xX, xY, yX, yY = 0, 0, 0, 0, 0, 0, 0
  for _, q in ipairs(neighbours(points, p, radius)) do
    local X, Y, x, y = q.X - p.X, q.Y - p.Y, q.x - p.x, q.y - p.y
    XX, XY, YY = XX + X * X, XY + X * Y, YY + Y * Y
    xX, xY, yX, yY = xX + x * X, xY + x * Y, yX + y * X, yY + y * Y
  end
  return (xX * yY - xY * yX) / (XX * YY - XY * XY)
end

--- What both halves cover: {reference =, area =} m^2, and {length =, width =} of the ellipse of the same second moments, m.
--- Gradients are taken over `radius`.
function contact.patch(points, radius)
  local patch, x, xx, yy = { reference = 0, area = 0 }, 0, 0, 0
  for _, p in ipairs(points) do
    if p.share > 0 then
      local reference = 2 * p.area * p.share
      local area = reference * stretch(points, p, radius)
      patch.reference, patch.area = patch.reference + reference, patch.area + area
      x, xx, yy = x + area * p.x, xx + area * p.x ^ 2, yy + area * p.y ^ 2
    end
  end
  patch.length = 4 * math.sqrt(xx / patch.area - (x / patch.area) ^ 2)
  patch.width = 4 * math.sqrt(yy / patch.area)
  return patch
end

return contact
