#!/bin/sh
# stiction peers: its words are judged before anything runs; with stored results it needs no other program.
. "$(dirname "$0")/common.sh"

expect 0 "Usage: stiction peers|--turns|--stored|--problems" "$stiction" peers --help
expect 2 "there is no case 'blok3d'; did you mean 'block3d'?" "$stiction" peers blok3d
expect 2 "there is no size 'huge'; there are small, medium, large, largest" "$stiction" peers --size huge
expect 2 "--turns" "$stiction" peers --turns 0
holds "something ran" [ ! -e out ]

expect 0 "block3d cells=8, CalculiX: its stored results|GetFEM (stored)|press|allowed|output: out/peers" \
  "$stiction" peers block3d --quick --stored
holds "peers.csv" grep -q "^block3d,cells=8,GetFEM,true,drag,N,31.8" out/peers/peers.csv
holds "peers.json" grep -q '"agrees": true' out/peers/peers.json
holds "the case's own output" [ -s out/peers/block3d_cells_8/cells8/manifest.json ]
expect 0 "Siconos NSN_AC_HYB (stored)|error|energy" "$stiction" peers friction_problems --quick --stored --out other
mkdir empty
expect 1 "p01_flat_nc49: no answer|there is no file" "$stiction" peers friction_problems --quick --stored --problems empty --out missing
finish
