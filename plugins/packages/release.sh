#!/usr/bin/env bash
# release.sh OUT: makes all released files, in OUT/out: wheels, source distribution, archives and Blender
# add-ons, for Linux and (where mingw-w64's g++ is) for Windows, ParaView plugin and Debian packages (for the
# ParaView and the Debian that are here), the page and the npm package (where ./run page has made them), sources
# of the OpenFlipper plugin; SHA256 sums, an SPDX list, notes.
# release.sh OUT windows: only the files for Windows, beside the files in OUT/out.
# release.sh OUT arm64: wheel and archive for 64-bit ARM, cross compiled, beside the files in OUT/out.
# Two runs give the same bytes. Needs apt and the network for the first run, g++-12, cmake, ninja,
# dpkg-dev, python3-setuptools, python3-wheel and the libraries that ./run installs.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(cd "$here/../.." && pwd)
mkdir -p "$1/out"
work=$(cd "$1" && pwd)
out=$work/out
version=$(sed -n 's/^project(talweg VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git -C "$project" log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH LC_ALL=C TZ=UTC
umask 022

suitesparse() { # SuiteSparse's sources, by apt, with lists in a folder of this script
  local apt=$work/apt
  [[ ! -d $work/sources/suitesparse-5.12.0+dfsg ]] || return 0
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$work/sources"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "http://deb.debian.org/debian bookworm main" >"$apt/sources.list"
  local options=(-qq -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=root)
  (apt-get "${options[@]}" update && cd "$work/sources" &&
    apt-get "${options[@]}" source --only-source suitesparse=1:5.12.0+dfsg-2) >"$work/sources.log" 2>&1 ||
    { tail -n 10 "$work/sources.log" >&2; exit 1; }
}

# packed FOLDER FILE: an archive with the same bytes for the same files.
packed() {
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --format=gnu \
    -C "$(dirname "$1")" -cf - "$(basename "$1")" | gzip -9n >"$2"
}

# wheel PLUGINS TAG: the Python package with plugins for one kind of system.
wheel() {
  local source=$work/python
  rm -rf "$source"
  cp -r "$project/plugins/hosts/python" "$source"
  find "$source" -name __pycache__ -prune -exec rm -rf {} +
  cp "$project/LICENSE" "$source"
  (cd "$source" && TALWEG_PLUGIN_PATH=$1 TALWEG_WHEEL_TAG=$2 /usr/bin/python3 -c \
    "from setuptools import build_meta; build_meta.build_wheel('$out')") >"$work/wheel.log" 2>&1 ||
    { tail -n 10 "$work/wheel.log" >&2; exit 1; }
}

# archive MACHINE TALWEG...: program and plugins, with completions as the command TALWEG... tells them.
archive() {
  local tree=$work/talweg-$version-linux-$1 built=$work/portable-$1/tree
  shift
  rm -rf "$tree"
  cp -r "$built" "$tree"
  mkdir -p "$tree"/share/{bash-completion/completions,zsh/site-functions,fish/vendor_completions.d}
  "$@" completion bash >"$tree/share/bash-completion/completions/talweg"
  "$@" completion zsh >"$tree/share/zsh/site-functions/_talweg"
  "$@" completion fish >"$tree/share/fish/vendor_completions.d/talweg.fish"
  cp "$project"/{LICENSE,CHANGELOG.md,CITATION.cff} "$tree"
  packed "$tree" "$out/$(basename "$tree").tar.gz"
}

# linux MACHINE: wheel and archive for any Linux on x86_64 or aarch64, which qemu runs here.
linux() {
  local sysroot=$work/sysroot-$1 built=$work/portable-$1 plugins=$work/portable-$1/tree/lib/talweg/plugins
  local talweg=("$built/tree/bin/talweg") tag
  "$here/portable/sysroot.sh" "$sysroot" "$1"
  "$here/portable/build.sh" "$sysroot" "$1" "$work/sources/suitesparse-5.12.0+dfsg" "$built"
  if [[ $1 == aarch64 ]]; then
    talweg=("$sysroot/compiler/usr/bin/qemu-aarch64-static" -L "$sysroot" "${talweg[@]}")
  fi
  python3 "$here/wheel_tag.py" "$built/tree/bin/talweg" "$plugins"/*.so* >/dev/null
  tag=$(python3 "$here/wheel_tag.py" "$plugins"/*.so*)
  wheel "$plugins" "$tag"
  archive "$1" "${talweg[@]}"
}

openflipper() { # the plugin's sources, because OpenFlipper compiles its plugins together with itself
  local plugin=$work/talweg-openflipper-$version
  rm -rf "$plugin"
  cp -r "$project/plugins/hosts/openflipper" "$plugin"
  cp "$project/LICENSE" "$plugin"
  packed "$plugin" "$out/talweg-openflipper-$version.tar.gz"
}

has_mingw() { command -v x86_64-w64-mingw32-g++-posix >/dev/null; }

windows() { # program, plugins, loader with headers; wheel; Blender add-on
  local tree=$work/talweg-$version-windows-x86_64 plugins=$work/windows/tree/lib/talweg/plugins
  "$here/windows/build.sh" "$work/sources/suitesparse-5.12.0+dfsg" "$work/windows"
  rm -rf "$tree"
  cp -r "$work/windows/tree" "$tree"
  cp "$project"/{LICENSE,CHANGELOG.md,CITATION.cff} "$tree"
  python3 "$here/same_zip.py" "$tree" "$out/talweg-$version-windows-x86_64.zip" "$SOURCE_DATE_EPOCH"
  wheel "$plugins" win_amd64
  blender "$plugins" "talweg_blender-$version-windows.zip"
}

# blender PLUGINS FILE: the add-on with these plugins.
blender() {
  local stage=$work/blender addon=$work/blender/talweg_blender
  rm -rf "$stage"
  mkdir "$stage"
  cp -r "$project/plugins/hosts/blender/talweg_blender" "$addon"
  cp -r "$project/plugins/hosts/python/talweg" "$addon/talweg"
  find "$stage" -name __pycache__ -prune -exec rm -rf {} +
  cp -r "$1" "$addon/talweg/plugins"
  cp "$project/LICENSE" "$addon"
  mkdir -p "$addon/page/pictures" # the page that the help button opens
  cp "$project/docs/blender.md" "$addon/page"
  cp "$project"/docs/pictures/blender*.png "$addon/page/pictures"
  python3 "$here/same_zip.py" "$addon" "$out/$2" "$SOURCE_DATE_EPOCH"
}

# The filters for ParaView on this kind of system, with the portable plugins.
paraview() {
  local build=$work/paraview tree=$work/talweg-paraview-$version log=$work/paraview.log
  if ! ls /usr/lib/*/cmake/paraview-*/paraview-config.cmake >/dev/null 2>&1; then
    echo "No ParaView plugin: there is no paraview-dev (docs/paraview.md says what it needs)"
    return 0
  fi
  { cmake -S "$project" -B "$build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib \
      -DTALWEG_BUILD_PARAVIEW=ON -DTALWEG_PANEL_PLUGINS="$work/portable-x86_64/tree/lib/talweg/plugins" \
      -DTALWEG_BUILD_TESTS=OFF -DTALWEG_BUILD_DEMO=OFF -DTALWEG_BUILD_DRIVER=OFF &&
    cmake --build "$build" --parallel "${TALWEG_JOBS:-$(nproc)}" --target talweg-paraview; } >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; exit 1; }
  rm -rf "$tree"
  cmake --install "$build" --prefix "$tree" --component paraview --strip >/dev/null
  mkdir -p "$tree/lib/talweg"
  cp -r "$work/portable-x86_64/tree/lib/talweg/plugins" "$tree/lib/talweg"
  cp "$project/LICENSE" "$project/docs/paraview.md" "$tree"
  local paraview
  paraview=$(basename "$tree"/lib/paraview-*)
  packed "$tree" "$out/talweg-$version-$paraview-debian-x86_64.tar.gz"
}

# Debian packages for the system of this machine.
debian() {
  local build=$work/debian log=$work/debian.log
  local flags="-ffile-prefix-map=$project=. -ffile-prefix-map=$work=build"
  rm -rf "$build/packages"
  # A removed run path leaves space of its length, so the length must not depend on the folder.
  { cmake --preset package -S "$project" -B "$build" -DCMAKE_CXX_FLAGS="$flags" \
      -DCMAKE_BUILD_RPATH_USE_ORIGIN=ON &&
    cmake --build "$build" --parallel "${TALWEG_JOBS:-$(nproc)}" &&
    (cd "$build" && cpack -G DEB -B packages); } >"$log" 2>&1 || { tail -n 20 "$log" >&2; exit 1; }
  cp "$build"/packages/*.deb "$out"
}

page() {
  if [[ ! -e $project/build/page/index.html ]]; then
    echo "No page: ./run page has not been run"
    return 0
  fi
  rm -rf "$work/talweg-page-$version"
  cp -r "$project/build/page" "$work/talweg-page-$version"
  cp "$project/LICENSE" "$work/talweg-page-$version"
  python3 "$here/same_zip.py" "$work/talweg-page-$version" "$out/talweg-page-$version.zip" "$SOURCE_DATE_EPOCH"
}

npm_package() { # WebAssembly for Node and browsers; npm packs the same files into the same bytes
  if [[ ! -e $project/build/npm/package.json ]] || ! command -v npm >/dev/null; then
    echo "No npm package: ./run page has not been run, or there is no npm"
    return 0
  fi
  rm -rf "$work/npm"
  mkdir "$work/npm"
  npm pack --silent --pack-destination "$work/npm" "$project/build/npm" >/dev/null
  mv "$work/npm/talweg-$version.tgz" "$out/talweg-npm-$version.tgz"
}

notes() { # the newest part of the changelog
  awk '/^## /{ if (seen++) exit } seen' "$project/CHANGELOG.md" >"$out/NOTES.md"
}

listed() { # the parts of each file, and checksums
  local list=talweg-$version.spdx.json root=$work/sysroot-$1
  (cd "$out" && rm -f SHA256SUMS "$list" && shopt -s nullglob &&
    python3 "$here/spdx.py" "$version" "$SOURCE_DATE_EPOCH" "$root" ./*.{whl,tar.gz,tgz,zip,deb} >"$work/$list" &&
    mv "$work/$list" . && sha256sum -- * >SHA256SUMS && ls -l)
}

if [[ ${2:-} == windows ]]; then
  has_mingw || { echo "For Windows g++-mingw-w64-x86-64-posix is needed: apt install it." >&2; exit 1; }
  suitesparse
  windows
  if [[ -d $work/sysroot-x86_64 ]]; then listed x86_64; fi  # the list needs the versions of its parts
  exit
fi
suitesparse
if [[ ${2:-} == arm64 ]]; then
  linux aarch64
  listed aarch64
  exit
fi
rm -rf "$out"
mkdir "$out"
linux x86_64
"$here/sdist.sh" "$out"
openflipper
blender "$work/portable-x86_64/tree/lib/talweg/plugins" "talweg_blender-$version.zip"
if has_mingw; then windows; else echo "No files for Windows: there is no g++-mingw-w64-x86-64-posix"; fi
paraview
debian
page
npm_package
notes
listed x86_64
