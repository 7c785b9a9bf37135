#!/bin/sh
# What results were made of is kept with them: they are computed again from that, also from an archive, elsewhere.
. "$(dirname "$0")/common.sh"
TMPDIR=$work/scratch
export TMPDIR
mkdir "$TMPDIR"

run() { "$stiction" run "$@" --no-figures --jobs 2 >run.log 2>&1 || complain "run $*: $(cat run.log)"; }
count() { find "$1/source" -type f | wc -l; }

# the source is kept by content, once; what becomes of the study does not matter
mkdir -p work/parts
cp -r "$tiny" work/own
mv work/own/block.lua work/parts/block.lua
cp "$here"/../../studies/examples/own_mesh/*.msh work/parts
sed -i 's|require "block"|require "../parts/block.lua"|' work/own/study.lua
run work/own --out o
holds "one copy of each file: $(find o/source)" [ "$(count o)" = 2 ]
holds "a copy under its content" cmp -s work/parts/block.lua "$(find o/source -name block.lua)"
holds "the times" grep -Eq '"started": "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"' o/mu0/manifest.json
holds "the end" grep -Eq '"ended": "[0-9]{4}-[0-9]{2}-[0-9]{2}T' o/mu0/manifest.json
holds "the machine" grep -Eq '"cores": [1-9]' o/mu0/manifest.json
sed -i 's/descent = 0.02/descent = 0.03/' work/own/study.lua
cp -r o before
run work/own --out o --case mu0
holds "a copy of each content: $(find o/source)" [ "$(count o)" = 3 ]
rm -r work
expect 0 "3 of 3 cases recomputed from the kept source: computed by this program on this processor, so to the last bit|6 of 6 results equal to the last bit, 0 differ|3 of 3 histories equal to the last bit" \
  "$stiction" verify before
expect 0 "4 of 4 cases|8 of 8 results equal" "$stiction" verify o # with what stands aside
expect 0 "1 of 1 case chosen of 3|2 of 2 results" "$stiction" verify before --sample 1
first=$(sed -n 's/ *started.*//p' output)
expect 0 "$first  started" "$stiction" verify before --sample 1 --jobs 1

# so is for which processor OpenBLAS computes: digits depend on it
holds "its kernels" grep -q '"processor": ".*kernels of OpenBLAS: ' before/mu0/manifest.json
if grep -q '^flags.* avx2 ' /proc/cpuinfo && [ -z "$OPENBLAS_CORETYPE" ]; then # of a processor OpenBLAS does not know, too
  holds "kernels that fit" grep -Eq 'OpenBLAS: (Haswell|Zen|SkylakeX|Cooperlake|SapphireRapids)"' before/mu0/manifest.json
fi
expect 0 "3 of 3 cases|by another build of the program, on another processor or by several ranks|0 differ too much" \
  env OPENBLAS_CORETYPE=Nehalem "$stiction" verify before

# options are part of it, and a mesh by its content
cp -r "$here"/../../studies/examples/own_mesh meshed
run meshed --quick --out m
run "$tiny" --set steps=4 --set cells=3 --case mu0.2 --out s
rm meshed/*.msh
expect 0 "to the last bit" "$stiction" verify m
expect 0 "1 of 1 case recomputed|2 of 2 results" "$stiction" verify s

# what does not agree is told: exit code 1
spoil() { # FOLDER FILE SED-EXPRESSION: a copy of the output with one file changed
  rm -rf "$1"
  cp -r before "$1"
  # shellcheck disable=SC2086 # a pattern
  sed -i "$3" "$1"/$2
  # shellcheck disable=SC2086
  cmp -s before/$2 "$1"/$2 && complain "$1: nothing was spoilt"
}
spoil summary summary.csv '/^mu0.2,/s/,23\./,24./'
expect 1 "summary.csv: mu0.2: force_y is 24.|in the case's own file" "$stiction" verify summary
spoil source 'source/*/block.lua' 's/poisson = 0.3/poisson = 0.31/'
expect 1 "mu0: not recomputed: ../parts/block.lua is no longer what was read|0 of 3 cases" "$stiction" verify source
rm source/source/*/block.lua
expect 1 "block.lua is not kept" "$stiction" verify source
expect 0 "source.tgz: 3 cases|none can be computed again" "$stiction" pack source --to source.tgz
spoil result mu0.4/manifest.json 's/"force_y":23.9/"force_y":23.8/'
expect 1 "mu0.4: force_y was 23.8|is now 23.9|5 of 6 results equal to the last bit, 1 differs too much" "$stiction" verify result
rm -rf history
cp -r before history
cp before/mu0/series.h5 history/mu0.4
rm history/mu0.2/series.h5
expect 1 "mu0.2: series.h5 is gone|mu0.4: series.h5 is not what the kept source gives|0 differ too much|1 of 3 histories equal" "$stiction" \
  verify history
spoil older mu0/manifest.json '1s/"run":{[^}]*},//'
expect 1 "mu0: not recomputed: it does not say how it was run|2 of 3 cases" "$stiction" verify older

rm -rf lost
cp -r before lost
rm -r lost/mu0.2
printf '{' >lost/mu0.4/manifest.json
expect 1 "mu0.2: its files are gone|mu0.4: lost/mu0.4/manifest.json is damaged|1 of 1 case recomputed" "$stiction" verify lost
expect 1 "lost.tgz: 3 cases|mu0.2: its files are gone|mu0.4: lost/mu0.4/manifest.json is damaged" "$stiction" pack lost --to lost.tgz

spoil files mu0/manifest.json '1s/"path":"study.lua"/"path":["study.lua"]/'
expect 1 "mu0: not recomputed: it does not say how it was run|2 of 3 cases" "$stiction" verify files
expect 0 "files.tgz: 3 cases|'stiction verify files.tgz' computes 2 of them again" "$stiction" pack files --to files.tgz

# another build may differ by what is stated
sed -i '1s/"program":"/"program":"0/; 1s/"force_y":23.\([0-9]*\)[0-9]\{6\}/"force_y":23.\1000000/' before/mu0*/manifest.json
sed -i '2,$s/,23\.\([0-9]*\)[0-9]\{6\},/,23.\1000000,/' before/summary.csv
expect 0 "by another build of the program, on another processor or by several ranks, so within 1e-06 of the largest value|0 differ too much" "$stiction" verify before
holds "to the last bit although changed: $(cat output)" grep -q '3 of 6 results equal' output
expect 1 "3 differ too much" "$stiction" verify before --tolerance 1e-15
expect 1 "differ" "$stiction" verify result --tolerance 0.1

# a file that stands under its whole path may be another one by now
cp -r "$here"/../../studies/examples/own_mesh whole
mesh=$(cd whole && ls ./*.msh)
mkdir elsewhere
mv "whole/$mesh" elsewhere
sed -i "s|path = \"[^\"]*\"|path = \"$work/elsewhere/$mesh\"|" whole/study.lua
run whole --quick --out w
expect 0 "to the last bit" "$stiction" verify w
sed -i '1{h;s/.*/$Comments\nanother\n$EndComments/;G}' "elsewhere/$mesh"
expect 1 "it now reads another file" "$stiction" verify w

# an archive says what it holds, and is enough
expect 0 "packed.tar.gz: 2 cases|stiction verify packed.tar.gz" "$stiction" pack m --to packed.tar.gz --license CC-BY-4.0
expect 2 "there is packed.tar.gz already" "$stiction" pack m --to packed.tar.gz
mkdir -p far/away
mv packed.tar.gz far/away
mv m hidden
cd far/away || exit 1
expect 0 "all files are what ro-crate-metadata.json lists|to the last bit" "$stiction" verify packed.tar.gz
tar xzf packed.tar.gz
holds "the folder of its name" [ -f m/summary.csv ]
expect 0 "all files are what ro-crate-metadata.json lists|to the last bit" "$stiction" verify m
cat >crate.lua <<'END'
local test, equal = ...
local engine = require "stiction.engine"
local graph = engine.decode_json(engine.read_file "m/ro-crate-metadata.json")["@graph"]
local by_id, parts = {}, {}
for _, entity in ipairs(graph) do
  equal(entity["@id"] .. tostring(by_id[entity["@id"]]), entity["@id"] .. "nil")
  by_id[entity["@id"]] = entity
end
for _, part in ipairs(by_id["./"].hasPart) do parts[part["@id"]] = true end
local function each_reference(value, f)
  if type(value) == "table" then
    if value["@id"] and not value["@type"] then f(value["@id"]) end
    for _, inner in pairs(value) do each_reference(inner, f) end
  end
end
test("every file is listed and every listed one exists", function()
  local count = 0
  for _, path in ipairs(engine.list("m", true)) do
    count = count + 1
    local own = path:sub(3)
    equal(own .. tostring(parts[own]), own .. (own == "ro-crate-metadata.json" and "nil" or "true"))
  end
  for id in pairs(parts) do
    count = count - 1
    equal(engine.kind_of_path("m/" .. id), "file")
    equal(by_id[id].contentSize, ("%d"):format(engine.file_size("m/" .. id)))
  end
  equal(count, 1)
end)
test("no reference leads nowhere", function()
  for _, entity in ipairs(graph) do
    each_reference(entity, function(id) equal(id .. tostring(by_id[id] ~= nil or id:find "^https?:" ~= nil), id .. "true") end)
  end
end)
test("a case is a run of the study", function()
  local run = by_id[by_id["./"].mentions[1]["@id"]]
  equal(run["@type"], "CreateAction")
  equal(run.instrument["@id"], by_id["./"].mainEntity["@id"])
  equal(by_id[run.instrument["@id"]]["@type"][3], "ComputationalWorkflow")
  equal(run.startTime:match "^%d+%-%d+%-%d+T%d+:%d+:%d+Z$" ~= nil and run.startTime <= run.endTime, true)
  equal(by_id["./"].license["@id"], "https://spdx.org/licenses/CC-BY-4.0")
  equal(#run.object > 0 and #run.result > 3, true)
end)
END
expect 0 "3 passed, 0 failed" "$stiction" luatest crate.lua
echo more >>m/checks.json
touch m/added.txt
rm m/study.json
expect 1 "file: added.txt is not listed|file: checks.json is not what was packed|file: study.json is missing" "$stiction" verify m
cd "$work" || exit 1

# bad input
expect 2 "there is neither an output folder nor a study at 'nowhere'" "$stiction" verify nowhere
echo nothing >no.tar.gz
expect 2 "no.tar.gz is not an archive, or it is damaged" "$stiction" verify no.tar.gz
tar czf other.tar.gz run.log
expect 2 "other.tar.gz holds no ro-crate-metadata.json" "$stiction" verify other.tar.gz
expect 2 "--tolerance must be a relative difference of 0 or more" "$stiction" verify s --tolerance -1
expect 2 "--sample" "$stiction" verify s --sample 0
expect 2 "an archive's name ends in .tar.gz or .tgz" "$stiction" pack s --to s.zip
expect 2 "there is no folder for" "$stiction" pack s --to no/s.tgz
expect 2 "holds no results" "$stiction" pack far
expect 2 "set TMPDIR to a folder that can be written" env TMPDIR="$work/nowhere" "$stiction" pack s --to nowhere.tgz

# what cannot be written is packed all the same, and its page goes elsewhere
mkdir kept
cp -r s kept/s
if [ "$(id -u)" = 0 ]; then
  chmod 755 "$work" # for whom nothing but reading is allowed
  chmod 777 . "$TMPDIR"
  reader="setpriv --reuid=65534 --regid=65534 --clear-groups"
else
  chmod -R a-w kept
  reader=
fi
chmod -R a+rX kept
expect 0 "page.tgz: " $reader "$stiction" pack kept/s --to page.tgz
expect 2 "cannot write kept/s/report.html; --to FILE puts the page elsewhere" $reader "$stiction" report kept/s
expect 0 "page.html" $reader "$stiction" report kept/s --to page.html
chmod -R u+w kept
holds "scratch folders are left" [ -z "$(ls "$TMPDIR")" ]
finish
