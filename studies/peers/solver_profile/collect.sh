#!/bin/sh
# Contact problems of our own studies, for the study beside: collect.sh DIR [STICTION]
# Runs one case of each study and leaves every so many steps' problem in DIR/<study>/<case>/problems/; the friction problems that
# are kept beside come to DIR/friction/problems/.
set -e
here=$(cd "$(dirname "$0")" && pwd)
out=${1:?a folder} stiction=${2:-$here/../../../stiction}

case_of() { # STUDY CASE EVERY [OPTIONS]
  study=$1 case=$2 every=$3
  shift 3
  "$stiction" run "$here/../../$study" --case "$case" --problems "$every" --no-figures --jobs 1 \
    --out "$out/$(basename "$study")" "$@"
}

case_of paper/plate_on_cylinder v1000_mu0.4 10 --quick
case_of paper/plate_on_cylinder v1000_mu0.8 10
case_of paper/sphere_indentation A_deformable 20 --quick
case_of paper/sphere_indentation A_space 20 --quick
case_of proofs/greco_block quad4_64 1 --quick
case_of proofs/ironing slab_quad4_mu0.3_200_mortar 10 --quick
case_of proofs/ironing die_quad8_mu0.3_200_spline 10 --quick
case_of proofs/capstan phi180_mu0.6 2 --quick
case_of proofs/dcb C1e+10_1000 10 --quick
case_of proofs/peeled_film cell200_in0.1s 10 --quick
case_of proofs/cattaneo_mindlin quad4_16 1 --quick
case_of proofs/nonmatching_slide mu0.3_200_mortar 5 --quick
case_of proofs/jkr_cylinder stiffness0.3_cells4 10 --quick
case_of proofs/hertz_3d pair_16_block_200_slope_0.005 1 --quick
case_of peers/block3d cells8 1 --quick
case_of peers/slide2d cells8_materialblatz_ko_mu0.5 4 --quick
mkdir -p "$out/friction/problems"
cp "$here"/../friction_problems/problems/*.h5 "$out/friction/problems"
