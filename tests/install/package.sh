#!/bin/sh
# Makes the package of BUILD below WORK, unpacks it into an empty root and runs a study with what lies there.
set -eu
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work/root"
cd "$build"
cpack -G DEB -B "$work" >"$work/cpack.log" 2>&1 || { cat "$work/cpack.log"; exit 1; }
package=$(ls "$work"/stiction_*.deb)
depends=$(dpkg-deb -f "$package" Depends)
for needed in libcholmod libhdf5 fonts-dejavu-core; do
  case $depends in *$needed*) ;; *) echo "the package does not depend on $needed: $depends"; exit 1 ;; esac
done
dpkg-deb -x "$package" "$work/root"
cd "$work"
own=root/usr/share/stiction
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction run "$own/studies/paper/plate_on_cylinder" --quick --out "$work/out"
grep -q finished out/summary.csv
ls out/figures/*.png >/dev/null
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction new own --from own_mesh
env -i PATH=/usr/bin:/bin "HOME=$work" root/usr/bin/stiction run own --quick --no-figures
