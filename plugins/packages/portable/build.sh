#!/bin/sh
# build.sh SYSROOT MACHINE SUITESPARSE OUT: builds driver and plugins for any Linux on MACHINE (x86_64, aarch64) with
# the sysroot's glibc or a newer one, and installs them into OUT/tree with the shared library that they need.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sysroot=$(cd "$1" && pwd) machine=$2 suitesparse=$(cd "$3" && pwd)
mkdir -p "$4"
out=$(cd "$4" && pwd)
if [ -d "$sysroot/compiler" ]; then
  PATH=$sysroot/compiler/usr/bin:$PATH
  export PATH LD_LIBRARY_PATH="$sysroot/compiler/usr/lib/x86_64-linux-gnu"
fi
"$machine-linux-gnu-gcc-12" --sysroot="$sysroot" -O2 -fPIC -c "$here/newer_glibc.c" \
  -o "$sysroot/talweg/newer_glibc.o"
jobs=${TALWEG_JOBS:-$(nproc)}
compile() { # compile TARGET SOURCE BUILD CMAKE-ARGUMENT...
  target=$1 source=$2 build=$3
  shift 3
  # Entries of ccache from another folder would contain its paths, which CMake would read.
  CCACHE_DISABLE=1 cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE="$here/toolchain.cmake" -DTALWEG_SYSROOT="$sysroot" \
    -DTALWEG_MACHINE="$machine" -DTALWEG_SUITESPARSE="$suitesparse" "$@" >"$build.log" 2>&1 ||
    { tail -n 20 "$build.log" >&2; exit 1; }
  cmake --build "$build" --parallel "$jobs" --target "$target" >>"$build.log" 2>&1 ||
    { tail -n 20 "$build.log" >&2; exit 1; }
}
compile cholmod "$here/cholmod" "$out/cholmod"
# Run paths are final from the start: if CMake replaced longer ones, their space would remain.
# shellcheck disable=SC2016  # $ORIGIN is the linker's
compile talweg "$here/../../.." "$out/talweg" -DCMAKE_INSTALL_PREFIX=/opt/talweg -DCMAKE_INSTALL_LIBDIR=lib \
  -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON \
  -DCMAKE_INSTALL_RPATH='$ORIGIN;$ORIGIN/../lib/talweg/plugins' -DTALWEG_SUPERNODAL=OFF \
  -DTALWEG_CHOLMOD_BUILD="$out/cholmod" -DTALWEG_BUILD_TESTS=OFF -DTALWEG_BUILD_DEMO=OFF
rm -rf "$out/tree"
cmake --install "$out/talweg" --prefix "$out/tree" --component driver --strip >/dev/null
plugins=$out/tree/lib/talweg/plugins
cp "$out/cholmod/libtalweg-cholmod.so.3" "$plugins"
"$machine-linux-gnu-strip" --strip-unneeded "$plugins/libtalweg-cholmod.so.3"

# Licences of all parts.
mkdir "$plugins/licences"
cp "$here/../../../LICENSE" "$plugins/licences/talweg"
for package in g++-12 libopenmesh-dev libeigen3-dev libfmt-dev libpugixml-dev nlohmann-json3-dev \
  libcli11-dev libxxhash-dev; do
  cp "/usr/share/doc/$package/copyright" "$plugins/licences/$package"
done
for package in libgcc-10-dev zlib1g-dev libpng-dev; do
  cp "$sysroot/usr/share/doc/$package/copyright" "$plugins/licences/$package"
done
cp "$suitesparse/debian/copyright" "$plugins/licences/suitesparse"
cp "$suitesparse/CHOLMOD/Core/lesser.txt" "$plugins/licences/LGPL-2.1"
cat >"$plugins/licences/README" <<'TEXT'
libtalweg-cholmod.so.3 is CHOLMOD's Core, Check and Cholesky, AMD and COLAMD of SuiteSparse 5.12.0
(LGPL 2.1 or later, BSD). It may be replaced: compile plugins/packages/portable/cholmod of Talweg's
sources with changed sources of SuiteSparse 5 (apt-get source suitesparse, Debian 12), and put the
library in the place of the one beside the plugins. The other files are licences of other parts.
TEXT
