-- Writes the meshes of this study: lua make.lua (for development only; the study reads what it wrote).
--
-- A wavy wall, loops of radius `loop` that open by `opening` to either side, from crest to crest: its section in quadrilaterals
-- (x is the radius, y the axis), and half a tube of it in hexahedra (the axis is z, y >= 0).
local loop, wall, radius, opening = 2, 0.5, 10, math.rad(105) -- mm

local length = 2 * loop * math.sin(opening) -- from a crest to a trough

--- Middle line at s from 0 to 1: {radius, z, and its normal, outwards}.
local function middle(s)
  local at = s * 2 -- in half waves
  local k = at < 0.5 and 0 or at < 1.5 and 1 or 2
  local angle, up = (at - k) * 2 * opening, k == 1 and -1 or 1
  return radius + up * loop * (math.cos(angle) - math.cos(opening)), k * length + loop * math.sin(angle),
    math.cos(angle), up * math.sin(angle)
end

local function point(s, t) -- t from -1 (inside) to 1 (outside)
  local r, z, n_r, n_z = middle(s)
  return r + t * wall / 2 * n_r, z + t * wall / 2 * n_z
end

local function write(path, dim, names, nodes, cells)
  local file = assert(io.open(path, "w"))
  file:write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n", #names, "\n")
  for i, name in ipairs(names) do
    file:write(("%d %d \"%s\"\n"):format(i == #names and dim or dim - 1, i, name))
  end
  file:write("$EndPhysicalNames\n$Nodes\n", #nodes, "\n")
  for i, at in ipairs(nodes) do
    file:write(("%d %.10g %.10g %.10g\n"):format(i, at[1], at[2], at[3]))
  end
  file:write("$EndNodes\n$Elements\n", #cells, "\n")
  for i, cell in ipairs(cells) do
    file:write(("%d %d 2 %d %d %s\n"):format(i, cell.kind, cell.group, cell.group, table.concat(cell, " ")))
  end
  file:write("$EndElements\n")
  file:close()
end

local groups = { "inner", "outer", "low", "high", "cut", "wall" }

local function tube(path, along, through, around)
  local nodes, cells = {}, {}
  local function number(i, j, k) return 1 + i + (along + 1) * (j + (through + 1) * k) end
  for k = 0, around do
    local turn = math.pi * k / around
    for j = 0, through do
      for i = 0, along do
        local r, z = point(i / along, 2 * j / through - 1)
        nodes[number(i, j, k)] = { r * math.cos(turn), r * math.sin(turn), z }
      end
    end
  end
  local function quad(group, a, b, c, d) cells[#cells + 1] = { kind = 3, group = group, a, b, c, d } end
  for k = 0, around - 1 do
    for i = 0, along - 1 do
      for j = 0, through do
        if j == 0 or j == through then
          quad(j == 0 and 1 or 2, number(i, j, k), number(i + 1, j, k), number(i + 1, j, k + 1), number(i, j, k + 1))
        end
      end
    end
    for j = 0, through - 1 do
      quad(3, number(0, j, k), number(0, j + 1, k), number(0, j + 1, k + 1), number(0, j, k + 1))
      quad(4, number(along, j, k), number(along, j + 1, k), number(along, j + 1, k + 1), number(along, j, k + 1))
    end
  end
  for _, k in ipairs { 0, around } do
    for j = 0, through - 1 do
      for i = 0, along - 1 do
        quad(5, number(i, j, k), number(i + 1, j, k), number(i + 1, j + 1, k), number(i, j + 1, k))
      end
    end
  end
  for k = 0, around - 1 do
    for j = 0, through - 1 do
      for i = 0, along - 1 do
        local cell = { kind = 5, group = 6 }
        for _, at in ipairs { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 1, 1 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 1, 0, 1 } } do
          cell[#cell + 1] = number(i + at[1], j + at[2], k + at[3])
        end
        cells[#cells + 1] = cell
      end
    end
  end
  write(path, 3, groups, nodes, cells)
end

local function section(path, along, through)
  local nodes, cells = {}, {}
  local function number(i, j) return 1 + i + (along + 1) * j end
  for j = 0, through do
    for i = 0, along do
      local r, z = point(i / along, 2 * j / through - 1)
      nodes[number(i, j)] = { r, z, 0 }
    end
  end
  local function line(group, a, b) cells[#cells + 1] = { kind = 1, group = group, a, b } end
  for i = 0, along - 1 do
    line(1, number(i, 0), number(i + 1, 0))
    line(2, number(i, through), number(i + 1, through))
  end
  for j = 0, through - 1 do
    line(3, number(0, j), number(0, j + 1))
    line(4, number(along, j), number(along, j + 1))
    for i = 0, along - 1 do
      cells[#cells + 1] = { kind = 3, group = 5, number(i, j), number(i, j + 1), number(i + 1, j + 1), number(i + 1, j) }
    end
  end
  for _, cell in ipairs(cells) do -- counter-clockwise
    if cell.kind == 3 then cell[2], cell[4] = cell[4], cell[2] end
  end
  write(path, 2, { "inner", "outer", "low", "high", "wall" }, nodes, cells)
end

section("section.msh", 24, 2)
for _, around in ipairs { 8, 12, 18 } do
  tube(("tube_%d.msh"):format(around), 24, 2, around)
end
