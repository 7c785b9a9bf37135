#!/bin/sh
# One page on what an output holds, one HDF5 file of its table, one sheet of pictures.
. "$(dirname "$0")/common.sh"

figures=no
[ -x "$(dirname "$stiction")/../../postproc/stiction-figures" ] && figures=yes

# a study with everything a page tells: reasons, errors, warnings, a failed result, signs that mean something in HTML
changed soft 's/^  quick = .*/  trade = { quantities = { "force_y", "force_x" }, set = { mu = 0.2 }, knobs = { { "steps", { 5, 10, 20 } } } },/
  s/A block on a plane/A <block> \& a \\"plane\\"/; s/descent = 0.02/descent = 0.3/; s/neo_hookean/linear_elastic/
  s/return math.abs/if run.id == "mu0.4" then error("not <this> one") end return math.abs/'
"$stiction" run soft --check-accuracy --jobs 2 >run.log 2>&1
holds "an output: $(cat run.log)" [ -f out/soft/summary.csv ]
expect 0 "out/soft/report.html" "$stiction" report soft
page=out/soft/report.html
shows() {
  for part in "$@"; do
    grep -qF -- "$part" "$page" || complain "the page does not show '$part'"
  done
}
shows '<title>A &lt;block&gt; &amp; a &quot;plane&quot;</title>' 'Do script, sweep, run, checks and figures work together?' \
  '2 of 3 cases finished' 'enough for the plumbing' '<td>0.001 m</td>' '<td>0, 0.2, 0.4</td>' 'Normal force at the end of the descent' \
  '<th>force_y/(N/m)</th>' ' ± ' 'result failed: result force_x: study.lua' 'not &lt;this&gt; one' \
  'body block will be strained by about 30 %' '→ ' 'all 3 cases: mu0, mu0.2, mu0.4' 'material: linear_elastic' 'friction: coulomb' \
  'first case began' 'Linux' 'file study.lua' 'compiler'
holds "no remedy that is none" [ "$(grep -c '→ nil' "$page")" = 0 ]
holds "warnings once" [ "$(grep -c 'will be strained' "$page")" = 1 ]
holds "the end" [ "$(tail -n 1 "$page")" = "</body></html>" ]
"$stiction" run "$tiny" --jobs 2 >/dev/null 2>&1
expect 0 "tiny.html" "$stiction" report nothing --out out/tiny --to tiny.html
page=tiny.html
shows '6 of 6 checks held' '<td>held</td>' 'No warnings, no remarks, no failed cases.'
[ $figures = no ] || shows '<img alt="force" src="data:image/png;base64,iVBOR'

# whole, and nothing that is elsewhere
cat >parse.lua <<'END'
local test, equal = ...
local engine = require "stiction.engine"
local single = { meta = true, br = true, img = true }
for _, file in ipairs { "tiny.html", "out/soft/report.html" } do
  test(file, function()
    local text, open = engine.read_file(file), {}
    for slash, name in text:gsub("<style>.-</style>", ""):gmatch "<(/?)(%a%w*)[^>]*>" do
      if slash == "/" then
        equal("</" .. table.remove(open) .. ">", "</" .. name .. ">")
      elseif not single[name] then
        open[#open + 1] = name
      end
    end
    equal(#open, 0)
    for _, word in ipairs { "src", "href" } do
      for target in text:gmatch(word .. '="([^"]*)"') do
        equal(target:sub(1, 30) .. tostring(target:find "^#" or target:find "^data:"), target:sub(1, 30) .. "1")
      end
    end
    for id in text:gmatch 'href="#(%w+)"' do
      equal(id .. tostring(text:find('id="' .. id .. '"', 1, true) ~= nil), id .. "true")
    end
  end)
end
END
expect 0 "2 passed, 0 failed" "$stiction" luatest parse.lua

# as a browser sees it: every picture is one, nothing is wider than the page
browser=$(command -v chromium || command -v chromium-browser)
if [ -n "$browser" ]; then
  sed 's|</body>|<script>const all = [...document.images]; document.title = "seen " + all.length + " " +\
    all.filter(i => i.naturalWidth > 100).length + " " + (document.documentElement.scrollWidth <= innerWidth) + " " +\
    document.querySelectorAll("section h2").length</script></body>|' tiny.html >look.html
  HOME=$work timeout 60 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --user-data-dir="$work/browser" \
    --dump-dom "file://$work/look.html" >dom 2>/dev/null </dev/null
  count=0
  [ $figures = no ] || count=1
  sections=7
  [ $figures = no ] && sections=6
  holds "as seen: $(grep -o '<title>.*</title>' dom)" grep -q "<title>seen $count $count true $sections</title>" dom
else
  echo "not looked at in a browser: there is no chromium here"
fi
expect 2 "a page's name ends in .html" "$stiction" report out/tiny --to page.txt
expect 2 "there is neither an output folder nor a study" "$stiction" report nowhere
expect 2 "holds no results" "$stiction" report browser --out .

# damaged files cost what they would have told
cp -r out/tiny damaged
echo '{"results": [true], "layout": 2, "drawn": {"kind": "sobol", "count": 4, "seed": 7}}' >damaged/study.json
echo '[1, {"name": "x", "table": {"columns": 5, "rows": [7]}}]' >damaged/checks.json
echo '{"figures": [3, {"name": []}]}' >damaged/figures.json
sed -i 's/"is": "[a-z_]*"/"is": [4]/; s/"parts": {/"parts": {"x": 3,/; s/"note": "rubber"/"note": []/' damaged/mu0/manifest.json
expect 0 "damaged/report.html" "$stiction" report damaged
holds "the sample" grep -q 'Drawn: 4 values (sobol, seed 7)' damaged/report.html

# a table that other programs open in one line
expect 0 "all.h5: table 'cases' of 3 rows" "$stiction" show out/tiny --h5 all.h5
expect 0 "some.h5: table 'cases' of 2 rows" "$stiction" show out/tiny --where 'mu > 0.1' --columns case,mu,force_y --h5 some.h5
expect 2 "the name of an HDF5 file ends in .h5 or .hdf5" "$stiction" show out/tiny --h5 all.txt
python=
for candidate in /usr/bin/python3 python3; do
  [ -z "$python" ] && $candidate -c 'import h5py' 2>/dev/null && python=$candidate
done
if [ -n "$python" ]; then
  cat >open.py <<'END'
import csv, h5py
table = h5py.File("all.h5")["cases"][:]
rows = list(csv.DictReader(open("out/tiny/summary.csv")))
assert [row["force_y"] for row in rows] == [repr(float(x)) for x in table["force_y"]], table["force_y"]
assert [row["case"].encode() for row in rows] == list(table["case"])
some = h5py.File("some.h5")
assert some["cases"].dtype.names == ("case", "mu", "force_y") and list(some["columns/mu"]) == [0.2, 0.4]
column = h5py.File("all.h5")["columns/force_y"]
assert column.attrs["unit"] in (b"kg s^-2", "kg s^-2"), column.attrs["unit"]
assert column.attrs["meaning"].startswith(type(column.attrs["meaning"])("Normal") if isinstance(column.attrs["meaning"], str) else b"Normal")
assert h5py.File("all.h5")["columns/young"][0] == 1e6
print("opened")
END
  expect 0 "opened" $python open.py
else
  echo "not opened by h5py: it is not installed"
fi

# a picture of every case
if [ $figures = yes ]; then
  expect 0 "sheet.png: von_mises of 3 of 3 cases" "$stiction" show out/tiny --sheet sheet.png
  holds "a picture" [ "$(head -c 4 sheet.png | tail -c 3)" = PNG ]
  cp -r out/tiny floating
  sed -i 's/"obstacles"/"others"/' floating/mu*/manifest.json
  "$stiction" show floating --sheet floating.png >/dev/null
  holds "the plane that the blocks stand on" sh -c '[ -s floating.png ] && ! cmp -s sheet.png floating.png'
  "$stiction" show out/tiny --where 'mu == 0.2' --sheet one.png --field contact_pressure >/dev/null
  holds "a smaller one" [ "$(wc -c <one.png)" -lt "$(wc -c <sheet.png)" ]
fi
# surfaces of half spaces are shown by their pressure
if [ $figures = yes ]; then
  cat >surface.lua <<'END'
local stiction = require "stiction"
local u = stiction.units
return stiction.study {
  title = "A ball", question = "What is drawn of a surface?",
  given = { R = 10*u.mm }, chosen = {}, sweep = { {} }, case_id = function() return "ball" end,
  scene = function(p)
    return stiction.scene { kinematics = "three_dimensional",
      bodies = { base = stiction.body.half_space { young = 1*u.MPa, poisson = 0.3, size = { 2*u.mm, 2*u.mm }, points = { 16, 16 },
        boundary = "free" } },
      obstacles = { ball = stiction.obstacle.height_map { surface = stiction.surface.sphere { radius = p.R },
        times = { 0*u.s, 1*u.s }, z = { 0*u.mm, -0.02*u.mm } } },
      pairs = { touch = stiction.pair { secondary = "base.surface", primary = "ball" } },
      scheme = stiction.scheme.quasi_static {},
      schedule = stiction.schedule { stages = { stiction.stage { to = 1*u.s, steps = 2 } } },
      output = stiction.output { frames = 2 }, probes = { touch = stiction.probe.contact { pair = "touch" } },
    }
  end,
}
END
  "$stiction" run surface.lua --no-figures >run.log 2>&1
  expect 0 "surface.png: contact_pressure of 1 of 1 cases" "$stiction" show out/surface --sheet surface.png
  expect 0 "surface.ogv: contact_pressure of case ball" "$stiction" show out/surface --animate surface.ogv
fi
# a film of one case
if [ $figures = yes ]; then
  expect 0 "film.ogv: beta of case mu0.2 over its time" "$stiction" show out/tiny --case mu0.2 --animate film.ogv --field beta --frames 2 --rate 3
  holds "a film" [ "$(head -c 4 film.ogv)" = OggS ]
  expect 2 "--frames 9: case mu0.2 has 3, and a film shows 2 of them or more" "$stiction" show out/tiny --case mu0.2 --animate none.ogv --frames 9
  holds "no film of frames that are not there" [ ! -e none.ogv ]
fi
expect 2 "a film shows one case, and 3 are chosen; give --case ID" "$stiction" show out/tiny --animate x.ogv
expect 2 "--case: out/tiny has no case 'mu0.3'; did you mean 'mu0.2'?" "$stiction" show out/tiny --case mu0.3 --animate x.ogv
expect 2 "a film's name ends in .ogv" "$stiction" show out/tiny --case mu0.2 --animate x.gif
expect 2 "--frames and --rate are of a film" "$stiction" show out/tiny --frames 3
expect 0 "mu0.2  finished|; 1 chosen" "$stiction" show out/tiny --case mu0.2
expect 2 "there is no field 'von_mise'; did you mean 'von_mises'?" "$stiction" show out/tiny --sheet x.png --field von_mise
expect 2 "a picture's name ends in .png" "$stiction" show out/tiny --sheet x.jpg
expect 2 "none of these cases has fields" "$stiction" show out/tiny --sheet x.png --where 'mu > 1'
finish
