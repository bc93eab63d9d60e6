#!/bin/sh
# arm64.sh OUT FOLDER TALWEG [MESH CURVE]: tries the files of ./run release arm64 (in folder OUT) by qemu in new
# roots in FOLDER, one with nothing but Debian 11's glibc. There the archive smooths CURVE on MESH (else a drawing
# of the Python tests) as TALWEG, the program for this machine, does here, to 1e-12 of the curve's size, and refuses
# a missing file by a sentence. In the other, with Debian 11's Python and numpy, the wheel passes fast tests of the
# Python package, one of which compares with TALWEG. Needs root, for chroot, numpy and the network. Not part of CI.
set -eu
work=$(cd "$1/.." && pwd) talweg=$(realpath "$3")
project=$(cd "$(dirname "$0")/../.." && pwd)
qemu=$work/sysroot-aarch64/compiler/usr/bin/qemu-aarch64-static
rm -rf "$2"
mkdir -p "$2"
folder=$(cd "$2" && pwd)
if [ $# -ge 5 ]; then
  mesh=$4 curve=$5
else
  mesh=$folder/hills.obj curve=$folder/staircase.txt
  TALWEG_SOURCE=$project PYTHONPATH=$project/tests/hosts/python PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 - \
    "$mesh" "$curve" <<'PYTHON'
import sys

import support

support.write_obj(sys.argv[1], *support.hills())
support.np.savetxt(sys.argv[2], support.staircase(), "%d")
PYTHON
fi
unpack() { # unpack ROOT PACKAGE...
  unpacked=$1
  shift
  "$project/plugins/packages/portable/unpack.sh" "$unpacked" bullseye arm64 libc6 "$@"
}

root=$folder/root
unpack "$root"
mkdir "$root/given"
cp "$qemu" "$root/given/qemu"
cp "$mesh" "$root/given/mesh.${mesh##*.}"
cp "$curve" "$root/given/curve.${curve##*.}"
tar -xzf "$work"/out/talweg-*-linux-aarch64.tar.gz -C "$root/given"
there() { # the program in the root, with nothing of this machine's environment
  (cd "$root/given" && env -i PATH=/usr/sbin:/usr/bin chroot "$root" /given/qemu "/given/$(echo talweg-*)/bin/talweg" "$@")
}
there --version
start=$(date +%s%3N)
there smooth "/given/mesh.${mesh##*.}" --curve "/given/curve.${curve##*.}" -o /given/smooth.json
echo "smoothed by qemu: $(($(date +%s%3N) - start)) ms"
"$talweg" --quiet smooth "$mesh" --curve "$curve" -o "$folder/smooth.json"
python3 - "$folder/smooth.json" "$root/given/smooth.json" <<'PYTHON'
import json
import sys

here, there = ([point["xyz"] for curve in json.load(open(name))["curves"] for point in curve["points"]]
               for name in sys.argv[1:])
if len(here) != len(there):
    sys.exit(f"{len(there)} points, and {len(here)} on this machine")
size = max(max(column) - min(column) for column in zip(*here))
farthest = max(abs(a - b) for p, q in zip(here, there) for a, b in zip(p, q))
same = open(sys.argv[1], "rb").read() == open(sys.argv[2], "rb").read()
print(f"{len(here)} points, farthest {farthest / size:.1e} of the curve's size{', the same bytes' if same else ''}")
sys.exit(farthest > 1e-12 * size)
PYTHON
if there smooth "/given/mesh.${mesh##*.}" --curve /given/nothing.txt 2>"$folder/refused"; then exit 1; fi
cat "$folder/refused"
grep -q 'Cannot read /given/nothing.txt: No such file or directory.' "$folder/refused"

root=$folder/python
unpack "$root" libgcc-s1 libcrypt1 zlib1g libexpat1 libffi7 libuuid1 libbz2-1.0 liblzma5 libssl1.1 \
  python3.9-minimal libpython3.9-minimal libpython3.9-stdlib python3-numpy libblas3 liblapack3 libgfortran5
python3 -m zipfile -e "$work"/out/talweg-*_aarch64.whl "$folder/site"
libraries=/usr/lib/aarch64-linux-gnu
cd "$project/tests/hosts/python"
for name in arrays curvature cut interface per_curve threads; do
  PYTHONPATH="$folder/site:$root/usr/lib/python3/dist-packages" PYTHONDONTWRITEBYTECODE=1 TALWEG_SOURCE=$project \
    TALWEG_DRIVER=$talweg LC_ALL=C.UTF-8 "$qemu" -L "$root" -E LD_LIBRARY_PATH="$libraries/blas:$libraries/lapack" \
    "$root/usr/bin/python3.9" run.py "test_$name" >"$folder/$name.log" 2>&1 || {
    tail -n 30 "$folder/$name.log" >&2
    exit 1
  }
  echo "test_$name: $(grep '^Ran ' "$folder/$name.log")"
done
