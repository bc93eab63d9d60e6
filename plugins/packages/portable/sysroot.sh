#!/bin/sh
# sysroot.sh ROOT [MIRROR]: makes a minimal Debian 11 (glibc 2.31) to build against, with this machine's
# header-only libraries beside it. Needs root, debootstrap and the network.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$1 mirror=${2:-http://deb.debian.org/debian}
if [ ! -d "$root/usr/include" ]; then
  debootstrap --variant=minbase --include=libc6-dev,libgcc-10-dev,zlib1g-dev,libpng-dev bullseye \
    "$root" "$mirror" >"$root.log" 2>&1 || { tail -n 5 "$root.log" >&2; exit 1; }
fi
root=$(cd "$root" && pwd)

# Absolute links would lead out of the root.
find "$root/usr/lib/x86_64-linux-gnu" "$root/usr/lib64" -maxdepth 1 -type l -lname '/*' |
  while read -r link; do
    target=$(readlink "$link")
    case $target in "$root"/*) ;; *) ln -sfn "$root$target" "$link" ;; esac
  done

# The unwinder of gcc 12 needs glibc 2.35; the unwinder of gcc 10, with the same interface, does not.
mkdir -p "$root/talweg/include"
ln -sfn "$root/usr/lib/gcc/x86_64-linux-gnu/10/libgcc_eh.a" "$root/talweg/libgcc_eh.a"
gcc-12 --sysroot="$root" -O2 -fPIC -c "$here/newer_glibc.c" -o "$root/talweg/newer_glibc.o"
for part in CLI OpenMesh eigen3 fmt nlohmann pugiconfig.hpp pugixml.cpp pugixml.hpp xxhash.h; do
  if [ -e "/usr/include/$part" ]; then
    ln -sfn "/usr/include/$part" "$root/talweg/include/$part"
  fi
done
