#!/bin/sh
# arm64.sh ROOT [MIRROR]: compiles `intrinsic` and its tests for 64-bit ARM in a new minimal Debian 12 and
# runs them by qemu. In a root of its own, since Debian's cross compiler and the g++-multilib of .ci/nightly
# exclude each other. Needs root, debootstrap and the network. Not part of CI.
set -eu
root=$1 mirror=${2:-http://deb.debian.org/debian}
project=$(cd "$(dirname "$0")/../.." && pwd)
if [ ! -e "$root/usr/bin/apt-get" ]; then
  debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 ||
    { tail -n 5 "$root.log" >&2; exit 1; }
fi
rm -rf "$root/talweg"
mkdir -p "$root/talweg/tests/packaging"
cp -r "$project/intrinsic" "$root/talweg"
cp -r "$project/tests/intrinsic" "$root/talweg/tests"
cp -r "$project/tests/packaging/arm64" "$root/talweg/tests/packaging"
for header in "$project"/tests/*.hpp; do cp "$header" "$root/talweg/tests"; done
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
cat >"$root/try.sh" <<'INSIDE'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
apt-get update -qq
apt-get install -y -qq --no-install-recommends g++-aarch64-linux-gnu cmake ninja-build libeigen3-dev \
  googletest qemu-user >/apt.log 2>&1 || { tail -n 20 /apt.log; exit 1; }
start=$(date +%s)
cmake -S /talweg/tests/packaging/arm64 -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release >/build.log 2>&1 &&
  cmake --build /build --parallel "$1" >>/build.log 2>&1 || { tail -n 30 /build.log; exit 1; }
echo "compiled for $(aarch64-linux-gnu-g++ -dumpmachine): $(($(date +%s) - start)) s"
start=$(date +%s)
cd /build
qemu-aarch64 -L /usr/aarch64-linux-gnu ./intrinsic_test --gtest_brief=1
echo "run by qemu: $(($(date +%s) - start)) s"
INSIDE
chroot "$root" sh /try.sh "${TALWEG_JOBS:-$(nproc)}"
