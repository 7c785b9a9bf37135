#!/bin/sh
# Bad input in scripts and settings: one clear message with its place, exit code 2, nothing run.
. "$(dirname "$0")/common.sh"

changed key 's/density = p.density/densitty = p.density/'
expect 2 "block.lua:5: bodies.block|density: is missing|densitty: |did you mean \"density\"" "$stiction" run key
# a table is of the line that its constructor is called in, not of the last one of a function that is called there
changed nested ''
cat >nested/block.lua <<'END'
local stiction = require "stiction"
local function shape(p)
  local cells = { p.cells, p.cells }
  return stiction.mesh.block { size = { p.side, p.side }, cells = cells }
end
local rubber = stiction.material.neo_hookean { young = 1*stiction.units.MPa, poisson = 0.3 }
return function(p)
  return stiction.body { mesh = shape(p), material = rubber, densitty = p.density }
end
END
expect 2 "block.lua:8: bodies.block|densitty: " "$stiction" run nested
changed unit 's/density = p.density/density = p.side/'
expect 2 "block.lua:5: bodies.block.density|kg/m^3" "$stiction" run unit
expect 2 "bodies.block.density: is -3 kg/m^3; it must be > 0 kg/m^3" "$stiction" run "$tiny" --set "density=-3 kg/m^3"
changed both 's/density = p.density/density = -p.density, colour = 3/; s/poisson = 0.3/poisson = 0.7/'
expect 2 "density: is -1000 kg/m^3|colour: |poisson: is 0.7" "$stiction" run both
changed set 's/block.bottom/block.botom/'
expect 2 "botom" "$stiction" run set
changed nowhere 's/primary = "floor"/primary = "flor"/'
expect 2 "flor" "$stiction" run nowhere
changed kind 's/neo_hookean/neo_hokean/'
expect 2 "block.lua:7: there is no material.neo_hokean; did you mean 'neo_hookean'?" "$stiction" run kind
changed sum 's/cells = { p.cells, p.cells }/cells = p.cells + p.side/'
expect 2 "block.lua:6: cannot add the pure number 4 and 1 mm" "$stiction" run sum
changed function 's/poisson = 0.3/poisson = print/'
expect 2 "poisson: a function cannot be part of a scene" "$stiction" run function
[ -e out ] && [ -n "$(find out -name series.h5)" ] && complain "something ran in spite of bad input"

expect 2 "no parameter 'denstiy'; did you mean 'density'?" "$stiction" run "$tiny" --set "denstiy=3"
expect 2 "'density' must be like 1000 kg/m^3, not 3" "$stiction" run "$tiny" --set "density=3"
expect 2 "--set density=1e400 kg/m^3: that is beyond the largest number" "$stiction" run "$tiny" --set "density=1e400 kg/m^3"
expect 2 "--set mu=-1e400: that is beyond the largest number" "$stiction" run "$tiny" --set "mu=-1e400"
expect 2 "unknown unit 'kgg'; did you mean 'kg'?" "$stiction" run "$tiny" --set "density=3 kgg"
expect 2 "density=1, 2 kg/m^3: one value is wanted|sweep = { density = { ... } }" "$stiction" run "$tiny" \
  --set "density=1, 2 kg/m^3"
expect 2 "no case 'mu0.3'; did you mean" "$stiction" run "$tiny" --case mu0.3
touch file
changed half 's/poisson = 0.3/poisson = 0.5/'
expect 2 "cannot make the folder file/out|--out" "$stiction" run "$tiny" --out file/out

expect 2 "poisson: is 0.5; it must be|poisson = 0.499 with interpolation = \"mean_dilatation\"" "$stiction" run half
changed mark ''
for file in study.lua block.lua; do # a byte-order mark, as some editors put first
  printf '\357\273\277' | cat - "$tiny/$file" >"mark/$file"
done
expect 0 "mu0  to run" "$stiction" run mark --list

changed slow '/^ *quick = {/d'
expect 0 "the study has no quick form|it stands in full" "$stiction" run slow --quick --list
changed stale 's/set = { steps = 5 }/set = { stride = 5 }/'
expect 0 "study.quick.set: the study has no parameter 'stride'|--quick is refused for that" "$stiction" run stale --list
expect 2 "study.quick.set: the study has no parameter 'stride'" "$stiction" run stale --quick --list

mkdir scripts
cat >scripts/deep.lua <<'L'
local stiction = require "stiction"
local function innermost(p)
  return p.side.wrong.thing
end
local function middle(p)
  local x = innermost(p)
  return x
end
return stiction.study { title = "deep", given = { side = 1 }, scene = function(p)
  local x = middle(p)
  return x
end }
L
expect 2 "deep.lua:3: |deep.lua:3: in function 'innermost'|deep.lua:6: in function 'middle'|deep.lua:10: in function 'scene'" \
  "$stiction" run scripts/deep.lua
printf 'local function again(x) return again(x) + 1 end\nlocal y = again(1)\n' >scripts/again.lua
expect 2 "again.lua:1: stack overflow|in function|  ..." "$stiction" run scripts/again.lua
holds "the trace of a function that calls itself ends after some of its calls" [ "$(wc -l <output)" -lt 40 ]
for tolerance in 0 1 nan; do
  expect 2 "solve: tolerance = $tolerance must be in [1e-16, 1)" "$stiction" solve "$(dirname "$0")/../contact/problems/rod_slides_mu16.h5" --tolerance $tolerance
done
echo 'local x = = 3' >scripts/syntax.lua
expect 2 "syntax.lua:1: unexpected symbol" "$stiction" run scripts/syntax.lua
echo 'return 3' >scripts/nothing.lua
expect 2 "nothing.lua must end with: return stiction.study" "$stiction" run scripts/nothing.lua
echo 'os.execute("true")' >scripts/os.lua
expect 2 "os.lua:1: os.execute is not there|--trust" "$stiction" run scripts/os.lua
echo 'local f = io.open("x.csv")' >scripts/io.lua
expect 2 "io.lua:1: io.open is not there|--trust" "$stiction" run scripts/io.lua
echo 'dofile("other.lua")' >scripts/dofile.lua
expect 2 "dofile.lua:1: dofile is not there|require" "$stiction" run scripts/dofile.lua
echo 'local a = 5*mm' >scripts/unit.lua
expect 2 "unit.lua:1: |local mm = stiction.units.mm" "$stiction" run scripts/unit.lua
echo 'require "other"' >scripts/require.lua
expect 2 "require.lua:1: there is no module 'other'" "$stiction" run scripts/require.lua
printf 'return require "right"\n' >scripts/left.lua
printf 'return require "left"\n' >scripts/right.lua
echo 'require "left"' >scripts/around.lua
expect 2 "right.lua:1: left.lua is required while it is being read itself (left.lua -> right.lua -> left.lua)" \
  "$stiction" run scripts/around.lua
printf 'require "./one.lua"\n' >one.lua
expect 2 "one.lua:1: |(one.lua -> one.lua)" "$stiction" run one.lua
printf 'error("no")\n' >scripts/left.lua
printf 'print(pcall(require, "left"), (select(2, pcall(require, "left"))))\nerror {}\n' >scripts/around.lua
expect 2 "false|left.lua:1: no|around.lua:2: error(...) with a table instead of words" "$stiction" run scripts/around.lua
changed unit 's/unit = "N\/m"/unit = 1/'
expect 2 "force_y: the unit is a number; a text is wanted, as \"1\" or \"kPa\"" "$stiction" run unit
changed names 's/^  sweep = .*/&\n  case_id = function(p) return p.mu end,/'
expect 2 "study.case_id gave a number; the case's name, a text, is wanted" "$stiction" run names
changed long 's/^  sweep = .*/&\n  case_id = function(p) return ("x"):rep(240) end,/'
expect 2 "a name of 240 characters, more than the 200" "$stiction" run long
changed moving 's/normal = { 0, 1 } }/&, y = { 0*mm, 1*mm }/'
expect 2 "floor.y: has 2 values for 0 times; give one value per time" "$stiction" explain moving
changed nothing 's/^  sweep = .*/sweep = { mu = { (0 \/ 0) * (1*units.mm), 1*units.mm } },/'
expect 2 "value 1 is not a number" "$stiction" run nothing
changed undefined 's/^  sweep = .*/  sweep = { mu = { 0 \/ 0, 0.2 } },/'
expect 2 "value 1 is not a number; it must be a number" "$stiction" run undefined
changed spaced 's/^  sweep = .*/  sweep = { ["my mu"] = { 0.2, 0.3 } },/'
expect 2 "cases cannot be called by the names that are swept, as in 'my mu0.2'|case_id(p)" "$stiction" run spaced
changed listed 's/^  sweep = .*/  sweep = { { mu = 0.2 }, { mu = 0.3 }, { mu = 0.2 } },/'
expect 0 "1 of the 3 cases of the sweep stand in it twice" "$stiction" run listed --list
changed single 's/pairs = { sole = /pairs = /; s/\(coulomb { mu = p.mu }\) } }/\1 }/'
expect 2 "pairs: is one pair by itself; name it, as in pairs = { one = pair { ... } }" "$stiction" run single
expect 2 "friction.mu: is 1e+15; it must be in [0, 1e+06]" "$stiction" run "$tiny" --set mu=1e15
expect 2 "no help on 'zz'; 'stiction help' tells" "$stiction" help zz
mkdir scripts/sub
echo 'return {}' >scripts/sub/other.lua
for name in sub/other ./sub/other; do
  echo "require '$name'" >scripts/require.lua
  expect 2 "require.lua:1: require '$name': |'$name.lua'; |require 'sub.other'" "$stiction" run scripts/require.lua
done

changed result 's/"sole", "force_y"/"sole", "forcey"/'
expect 2 "study.lua:34: |no series 'sole/forcey'; did you mean 'sole/force_y'?" "$stiction" run result --jobs 2
holds "something ran" [ -z "$(find out/result -name series.h5)" ]
finish
