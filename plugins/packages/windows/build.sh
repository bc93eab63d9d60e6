#!/bin/sh
# build.sh SUITESPARSE OUT: driver, plugins, loader and headers for Windows on x86-64, installed into
# OUT/tree with all that they need. Needs g++-mingw-w64-x86-64-posix, cmake, ninja, the network for the
# first run, and the header-only libraries that ./run installs.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
project=$(cd "$here/../../.." && pwd)
suitesparse=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)
installed=$out/root  # the libraries
jobs=${TALWEG_JOBS:-$(nproc)}
configure() { # configure SOURCE BUILD CMAKE-ARGUMENT...
  source=$1 build=$2
  shift 2
  # Entries of ccache from another folder would contain its paths, which CMake would read.
  { CCACHE_DISABLE=1 cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
      -DCMAKE_TOOLCHAIN_FILE="$here/toolchain.cmake" -DTALWEG_WINDOWS="$installed" \
      -DTALWEG_SUITESPARSE="$suitesparse" "$@" &&
    cmake --build "$build" --parallel "$jobs"; } >"$build.log" 2>&1 || { tail -n 20 "$build.log" >&2; exit 1; }
}
configure "$here/libraries" "$out/libraries"
cmake --install "$out/libraries" --prefix "$installed" >/dev/null
configure "$here/../portable/cholmod" "$out/cholmod"
configure "$project" "$out/talweg" -DCMAKE_INSTALL_PREFIX=/talweg -DCMAKE_INSTALL_LIBDIR=lib \
  -DTALWEG_SUPERNODAL=OFF -DTALWEG_CHOLMOD_BUILD="$out/cholmod" -DTALWEG_BUILD_TESTS=OFF \
  -DTALWEG_BUILD_DEMO=OFF
tree=$out/tree
rm -rf "$tree"
cmake --install "$out/talweg" --prefix "$tree" --component driver --strip >/dev/null
rm -r "$tree/share" # the manual page
# A program looks for its libraries in its own folder, a plugin in its own.
library=libtalweg-cholmod.dll.3
for folder in bin lib/talweg/plugins; do
  cp "$out/cholmod/$library" "$tree/$folder"
  x86_64-w64-mingw32-strip --strip-unneeded "$tree/$folder/$library"
done
cp "$out/talweg/bin/talweg_loader.dll" "$tree/bin"
x86_64-w64-mingw32-strip --strip-unneeded "$tree/bin/talweg_loader.dll"
cp "$out/talweg/plugins/loader/talweg_loader.lib" "$tree/lib"
mkdir -p "$tree/include/talweg/loader" "$tree/include/talweg/plugin"
cp "$project/plugins/loader/talweg_loader.h" "$tree/include/talweg/loader"
cp "$project"/plugins/interface/*.h "$project"/plugins/interface/*.hpp "$tree/include/talweg/plugin"

# Licences of all that is inside.
licences=$tree/lib/talweg/plugins/licences
cp -r "$installed/licences" "$licences"
cp "$project/LICENSE" "$licences/talweg"
for package in gcc-mingw-w64-x86-64-posix mingw-w64-x86-64-dev libopenmesh-dev libeigen3-dev libfmt-dev \
  nlohmann-json3-dev libcli11-dev libxxhash-dev; do
  cp "/usr/share/doc/$package/copyright" "$licences/$package"
done
cp "$suitesparse/debian/copyright" "$licences/suitesparse"
cp "$suitesparse/CHOLMOD/Core/lesser.txt" "$licences/LGPL-2.1"
cat >"$licences/README" <<'TEXT'
libtalweg-cholmod.dll.3 is CHOLMOD's Core, Check and Cholesky, AMD and COLAMD of SuiteSparse 5.12.0
(LGPL 2.1 or later, BSD). It may be replaced: compile plugins/packages/portable/cholmod of Talweg's
sources with changed sources of SuiteSparse 5 (apt-get source suitesparse, Debian 12) and
plugins/packages/windows/toolchain.cmake, and put the library in the places of those beside the program
and beside the plugins. The other files are licences of other parts.
TEXT
