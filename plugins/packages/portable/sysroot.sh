#!/bin/sh
# sysroot.sh ROOT MACHINE: makes the sysroot for programs on x86_64 or aarch64: Debian 11's glibc (2.31) and static
# libraries, and this machine's header-only libraries. For aarch64, ROOT/compiler gets the cross compiler, and qemu
# to run its programs. Needs apt and, the first time, the network.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
root=$(cd "$1" && pwd) machine=$2
case $machine in
x86_64) architecture=amd64 ;;
aarch64) architecture=arm64 ;;
*) echo "sysroot.sh: $machine is neither x86_64 nor aarch64" >&2; exit 1 ;;
esac
"$here/unpack.sh" "$root" bullseye "$architecture" \
  libc6 libc6-dev linux-libc-dev libcrypt-dev gcc-10-base libgcc-10-dev zlib1g-dev libpng-dev

# Absolute links lead out of the root.
find "$root/lib" "$root"/lib64 "$root/usr/lib" -type l -lname '/*' 2>/dev/null |
  while read -r link; do
    target=$(readlink "$link")
    case $target in "$root"/*) ;; *) ln -sfn "$root$target" "$link" ;; esac
  done

# The unwinder of gcc 12 calls a function of glibc 2.35. The unwinder of gcc 10 has the same interface and does not.
parts=$root/talweg
mkdir -p "$parts/include"
ln -sfn "$root/usr/lib/gcc/$machine-linux-gnu/10/libgcc_eh.a" "$parts/libgcc_eh.a"
for part in CLI OpenMesh eigen3 fmt nlohmann pugiconfig.hpp pugixml.hpp xxhash.h; do
  if [ -e "/usr/include/$part" ]; then
    ln -sfn "/usr/include/$part" "$parts/include/$part"
  fi
done

# The standard library's headers, and pugixml: the only library of this machine that is not headers alone.
if [ "$machine" = x86_64 ]; then
  ln -sfn /usr/include/c++/12 "$parts/include/c++"
  ln -sfn /usr/include/x86_64-linux-gnu/c++/12 "$parts/include/c++machine"
  ln -sfn /usr/lib/x86_64-linux-gnu/libpugixml.a "$parts/libpugixml.a"
else
  # Installed, Debian's cross compilers would take the place of g++-multilib.
  "$here/unpack.sh" "$root/compiler" bookworm amd64 binutils-aarch64-linux-gnu cpp-12-aarch64-linux-gnu \
    gcc-12-aarch64-linux-gnu g++-12-aarch64-linux-gnu libgcc-12-dev-arm64-cross libstdc++-12-dev-arm64-cross \
    qemu-user-static
  "$here/unpack.sh" "$root/pugixml" bookworm arm64 libpugixml-dev
  standard=$root/compiler/usr/aarch64-linux-gnu/include/c++/12
  ln -sfn "$standard" "$parts/include/c++"
  ln -sfn "$standard/aarch64-linux-gnu" "$parts/include/c++machine"
  ln -sfn "$root/pugixml/usr/lib/aarch64-linux-gnu/libpugixml.a" "$parts/libpugixml.a"
fi
