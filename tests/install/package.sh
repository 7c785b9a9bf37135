#!/bin/sh
# Makes the packages of BUILD below WORK, unpacks them into an empty root and runs studies with what lies there.
set -eu
build=$1 work=$2 source=$(cd "$(dirname "$0")" && pwd)
rm -rf "$work"
mkdir -p "$work/root"
cd "$build"
cpack -G DEB -B "$work" >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }
package=$(ls "$work"/stiction_*.deb)
ranks=$(ls "$work"/stiction-ranks_*.deb 2>/dev/null || true) # where PETSc was there to build with
depends=$(dpkg-deb -f "$package" Depends)
for needed in libcholmod libfftw3 libhdf5 fonts-dejavu-core; do
  case $depends in *$needed*) ;; *) echo "the package does not depend on $needed: $depends"; exit 1 ;; esac
done
case $depends in *petsc* | *mpi*) echo "the package depends on what ranks alone need: $depends"; exit 1 ;; esac
dpkg-deb -x "$package" "$work/root"
[ -z "$ranks" ] || dpkg-deb -x "$ranks" "$work/root"
cd "$work"
own=root/usr/share/stiction
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction run "$own/studies/paper/plate_on_cylinder" --quick --out "$work/out"
grep -q finished out/summary.csv
ls out/figures/*.png >/dev/null
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction new own --from own_mesh
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction run own --quick --no-figures
[ -n "$ranks" ] || exit 0
case $(dpkg-deb -f "$ranks" Depends) in *libpetsc*openmpi-bin* | *openmpi-bin*libpetsc*) ;; *)
  echo "stiction-ranks does not depend on PETSc and mpirun: $(dpkg-deb -f "$ranks" Depends)"
  exit 1
  ;;
esac
env -i PATH=/usr/bin:/bin "HOME=$work" LD_DEBUG=files "LD_DEBUG_OUTPUT=$work/loads" \
  root/usr/bin/stiction run "$source/../cli/block" --ranks 2 --no-figures --out "$work/shared"
grep -qs "root/usr/bin/../lib/stiction/stiction-ranks.so" "$work"/loads.* || { echo "ranks load another build's"; exit 1; }
