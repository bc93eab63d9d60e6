#!/bin/sh
# clean_root.sh DEBS ROOT [MIRROR]: tries the Debian packages of a folder in a new minimal Debian 12.
# Prints the time and the disk space. Needs root, debootstrap and the network. Not part of CI.
set -eu
debs=$1 root=$2 mirror=${3:-http://deb.debian.org/debian}
consumer=$(cd "$(dirname "$0")/../consumer" && pwd)

start=$(date +%s)
debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1
echo "minimal root: $(du -smx "$root" | cut -f1) MiB, $(($(date +%s) - start)) s"
mkdir "$root/debs"
cp "$debs"/*.deb "$root/debs"
cp -r "$consumer" "$root/consumer"

cat >"$root/try.sh" <<'INSIDE'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
add() { # add WHAT PACKAGE...
  what=$1 before=$(du -smx / | cut -f1) start=$(date +%s)
  shift
  apt-get install -y -qq --no-install-recommends "$@" >/apt.log 2>&1 || { cat /apt.log; exit 1; }
  apt-get clean
  echo "$what: $(($(du -smx / | cut -f1) - before)) MiB, $(($(date +%s) - start)) s"
}
apt-get update -qq
apt-get clean

add "libtalweg0.2 and talweg" /debs/libtalweg0.2_*.deb /debs/talweg_*.deb
talweg --version
printf 'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n' >/m.obj
start=$(date +%s%3N)
talweg draw /m.obj --through 0,1,4,5 -o /drawn.json
talweg smooth /m.obj --curve /drawn.json -o /smooth.vtp
echo "first curve drawn and smoothed in $(($(date +%s%3N) - start)) ms"
test -s /smooth.vtp

add "python3-talweg" /debs/python3-talweg_*.deb
start=$(date +%s%3N)
python3 - <<'PYTHON'
import talweg
mesh = talweg.Mesh("/m.obj")
print(mesh.smooth(mesh.draw([0, 1, 4, 5])).report.termination)
PYTHON
echo "the same from Python in $(($(date +%s%3N) - start)) ms"

add "g++, cmake, make, pkg-config" g++ cmake make pkg-config
add "libtalweg-dev" /debs/libtalweg-dev_*.deb
start=$(date +%s)
cmake -S /consumer -B /build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build /build >/dev/null
/build/smooth_curve
# shellcheck disable=SC2046  # several arguments
g++ -std=c++20 -O2 /consumer/smooth_curve.cpp $(pkg-config --cflags --libs talweg) -o /by_pkg_config
/by_pkg_config >/dev/null
echo "consumer by CMake and by pkg-config: $(($(date +%s) - start)) s"

start=$(date +%s)
apt-get purge -y -qq python3-talweg talweg libtalweg0.2 libtalweg-dev >/dev/null 2>&1
echo "removed in $(($(date +%s) - start)) s"
left=$(find / -xdev -name '*talweg*' -not -path '/debs/*')
test -z "$left" || { echo "left behind: $left"; exit 1; }
INSIDE
env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root chroot "$root" sh /try.sh  # nothing of ours gets in
