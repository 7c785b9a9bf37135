#!/bin/sh
# Mesh files with sets of cells: a law for each, the same of every format; what is refused; a scale that nobody gave.
. "$(dirname "$0")/common.sh"

# two layers of two cells each, 2 mm by 2 mm, in millimetres
cat >bar.inp <<'END'
*NODE
1, 0., 0.
2, 1., 0.
3, 2., 0.
4, 0., 1.
5, 1., 1.
6, 2., 1.
7, 0., 2.
8, 1., 2.
9, 2., 2.
*ELEMENT, TYPE=CPE4, ELSET=soft
1, 1, 2, 5, 4
2, 2, 3, 6, 5
*ELEMENT, TYPE=CPE4, ELSET=stiff
3, 4, 5, 8, 7
4, 5, 6, 9, 8
*ELSET, ELSET=left
1, 3
*NSET, NSET=foot
1, 2, 3
*NSET, NSET=head
7, 8, 9
** a set of nodes and one of cells may share a name, as Abaqus writes them
*NSET, NSET=soft
1, 2
END
cat >bar.msh <<'END'
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
1 1 "foot"
1 2 "head"
2 3 "soft"
2 4 "stiff"
$EndPhysicalNames
$Nodes
9
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0 2 0
8 1 2 0
9 2 2 0
$EndNodes
$Elements
8
1 1 2 1 1 1 2
2 1 2 1 1 2 3
3 1 2 2 2 7 8
4 1 2 2 2 8 9
5 3 2 3 3 1 2 5 4
6 3 2 4 4 4 5 8 7
7 3 2 3 3 2 3 6 5
8 3 2 4 4 5 6 9 8
$EndElements
END
points="0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 0 2 0 1 2 0 2 2 0"
cat >bar.vtk <<END
# vtk DataFile Version 3.0
bar
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 9 double
$points
CELLS 4 20
4 0 1 4 3
4 1 2 5 4
4 3 4 7 6
4 4 5 8 7
CELL_TYPES 4
9
9
9
9
CELL_DATA 4
SCALARS layer int 1
LOOKUP_TABLE default
1 1 2 2
POINT_DATA 9
SCALARS end int 1
LOOKUP_TABLE default
1 1 1 0 0 0 2 2 2
END
cat >bar.vtu <<END
<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="9" NumberOfCells="4">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">$points</DataArray></Points>
<Cells><DataArray type="Int64" Name="connectivity" format="ascii">0 1 4 3 1 2 5 4 3 4 7 6 4 5 8 7</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8 12 16</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">9 9 9 9</DataArray></Cells>
<PointData><DataArray type="Int32" Name="end" format="ascii">1 1 1 0 0 0 2 2 2</DataArray></PointData>
<CellData><DataArray type="Int32" Name="layer" format="ascii">1 1 2 2</DataArray>
<DataArray type="Float64" Name="density" format="ascii">1 1 2 2</DataArray></CellData>
</Piece></UnstructuredGrid></VTKFile>
END
cat >bar.lua <<'END'
local stiction = require "stiction"
local u = stiction.units
local mm, s, MPa = u.mm, u.s, u.MPa
local function law(young) return stiction.material.linear_elastic { young = young, poisson = 0 } end
local groups = { soft = law(1*MPa), stiff = law(9*MPa) }
local arrays = { layer_1 = law(1*MPa), layer_2 = law(9*MPa) }
local sets = { ["bar.inp"] = groups, ["bar.msh"] = groups, ["bar.vtk"] = arrays, ["bar.vtu"] = arrays }

return stiction.study {
  title = "Two layers in series",
  chosen = { scale = { 1*mm, "of the files" }, pull = { 0.02*mm, "a hundredth" } },
  sweep = { file = { "bar.inp", "bar.msh", "bar.vtk", "bar.vtu" } },
  scene = function(p)
    local named = sets[p.file] == groups
    local foot, head = named and "bar.foot" or "bar.end_1", named and "bar.head" or "bar.end_2"
    return stiction.scene {
      bodies = { bar = stiction.body { mesh = stiction.mesh.msh_file { path = p.file, scale = p.scale },
        material = sets[p.file], density = 1000*u.kg/u.m^3 } },
      motions = { stiction.motion.fix { set = foot },
        stiction.motion.drive { set = head, times = { 0*s, 1*s }, y = { 0*mm, p.pull } } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*s, steps = 1 } } },
      probes = { head = stiction.probe.force { set = head } },
    }
  end,
  results = { force = { unit = "N/m", meaning = "that stretches it",
    function(run) return math.abs(run:at(1*s, "head", "force_y")) end } },
  check = function(cases, check)
    for _, case in ipairs(cases) do -- width * pull / (h / E_soft + h / E_stiff)
      check.close(case.id, case.results.force, 2e-3 * 0.02e-3 / (1e-3 / 1e6 + 1e-3 / 9e6), 1e-9)
    end
  end,
}
END
expect 0 "4 of 4 checks held" "$stiction" run bar.lua --no-figures
expect 0 "material of soft|young = 1 MPa|material of stiff|young = 9 MPa|by the most compliant" \
  "$stiction" explain bar.lua --case filebar.inp
holds "the manifest tells both laws" grep -q '"stiff": *{' out/bar/filebar.inp/manifest.json

# what does not give each cell one law
changed_bar() { # NAME SED-EXPRESSION
  sed "$2" bar.lua >"$1.lua"
}
changed_bar bare 's/soft = law(1\*MPa), //'
expect 2 "bare.lua:|bodies.bar.material: gives no law to 2 of 4 cells, such as that at (0.0005, 0.0005) m; sets of cells are: left, soft, stiff" \
  "$stiction" run bare.lua --no-figures --case filebar.inp
changed_bar twice 's/soft = law(1\*MPa), /soft = law(1*MPa), left = law(1*MPa), /'
expect 2 "gives two laws to the cell at (0.0005, 0.0005) m, which is in left and in soft" \
  "$stiction" run twice.lua --no-figures --case filebar.inp
changed_bar nodes 's/soft = law(1\*MPa), /foot = law(1*MPa), /'
expect 2 'names "foot", which is no set of cells of the mesh; those are: left, soft, stiff' \
  "$stiction" run nodes.lua --no-figures --case filebar.inp
changed_bar lawless 's/material = sets\[p.file\]/material = { young = 1*MPa }/'
expect 2 "bodies.bar.material" "$stiction" run lawless.lua --no-figures --case filebar.inp

# layers that share no node: the lower one holds nothing of the upper
sed 's/^9$/12/; s/^9 2 2 0$/9 2 2 0\n10 0 1 0\n11 1 1 0\n12 2 1 0/; s/4 5 8 7$/10 11 8 7/; s/5 6 9 8$/11 12 9 8/' bar.msh >cut.msh
changed_bar seam 's/bar.msh/cut.msh/; s/stiction.motion.fix { set = foot },//; s/times = /x = { 0*mm, 0*mm }, times = /'
expect 2 "bodies.bar: is in parts that no cell joins; the one about (1 mm, 500 um) can move along x, move along y, turn: no motion" \
  "$stiction" run seam.lua --no-figures --case filecut.msh
changed_bar held 's/bar.msh/cut.msh/; s/times = /x = { 0*mm, 0*mm }, times = /'
expect 0 "filecut.msh  finished" "$stiction" run held.lua --no-figures --case filecut.msh # each by itself, without force

# a mesh without a scale, beside a way of hundredths of a millimetre
changed_bar metres 's/, scale = p.scale//; s/  chosen = { scale = { 1\*mm, "of the files" }, /  chosen = { /; s/check = /other = /'
sed -i '/^  other = /,/^  end,/d' metres.lua
warning="body bar: its mesh file is taken to be in metres and 2 m long, 1e+05 times the way of bar.head (20 um)"
expect 0 "warning: $warning|scale = 1*mm if the file is in millimetres" "$stiction" run metres.lua --no-figures --case filebar.inp
expect 0 "$warning" "$stiction" explain metres.lua --case filebar.inp
sed 's/path = p.file/path = p.file, scale = 1*u.m/' metres.lua >given.lua
expect 0 "finished" "$stiction" run given.lua --no-figures --case filebar.inp
holds "a scale that is given is believed" [ "$(grep -c 'taken to be' output)" = 0 ]

# cells with nodes in their middle: how to convert them
printf '# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 9 double\n0 0 0 1 0 0 1 1 0 0 1 0 .5 0 0 1 .5 0 .5 1 0 0 .5 0 .5 .5 0\nCELLS 1 10\n9 0 1 2 3 4 5 6 7 8\nCELL_TYPES 1\n28\n' >nine.vtk
sed 's/bar\.vtk/nine.vtk/g' bar.lua >nine.lua
expect 2 "cells of kind quad9, with nodes in the middle of faces; quad8 is computed on" "$stiction" run nine.lua --no-figures --case filenine.vtk
echo '<VTKFile type="PolyData"></VTKFile>' >poly.vtu
sed 's/bar\.vtu/poly.vtu/g' bar.lua >poly.lua
expect 2 "poly.vtu: not an unstructured grid of VTK" "$stiction" run poly.lua --no-figures --case filepoly.vtu
head -c 700 bar.vtu >cut.vtu
sed 's/bar\.vtu/cut.vtu/g' bar.lua >cut.lua
expect 2 "cut.vtu: the file is damaged; VTK says: " "$stiction" run cut.lua --no-figures --case filecut.vtu
holds "in one line of words: $(cat output)" [ "$(wc -l <output)" = 1 ]
holds "without addresses: $(cat output)" [ "$(grep -c '(0x' output)" = 0 ]
finish
