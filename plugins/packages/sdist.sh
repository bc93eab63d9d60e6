#!/bin/sh
# sdist.sh OUT: makes the source distribution for pip, OUT/talweg-VERSION.tar.gz, with the same bytes for the
# same files and SOURCE_DATE_EPOCH. Needs python3-setuptools and python3-wheel.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$1"
out=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
seconds=${SOURCE_DATE_EPOCH:-$(git -C "$project" log -1 --format=%ct 2>/dev/null || date +%s)}

# Works on a copy of the tree, since setuptools writes files into it.
mkdir -p "$work/tree/plugins/hosts"
for part in CMakeLists.txt LICENSE CHANGELOG.md intrinsic heat core; do
  ln -s "$project/$part" "$work/tree"
done
for part in CMakeLists.txt interface loader methods editing; do
  ln -s "$project/plugins/$part" "$work/tree/plugins"
done
cp -r "$project/plugins/hosts/python" "$work/tree/plugins/hosts"
rm -rf "$work/tree/plugins/hosts/python/build" "$work"/tree/plugins/hosts/python/*.egg-info
(cd "$work/tree/plugins/hosts/python" && /usr/bin/python3 -c \
  "from setuptools import build_meta; build_meta.build_sdist('$work')") >"$work/log" 2>&1 ||
  { tail -n 10 "$work/log" >&2; exit 1; }
file=$(basename "$work"/talweg-*.tar.gz)
mkdir "$work/packed"
tar -xzf "$work/$file" -C "$work/packed"
tar --sort=name --mtime="@$seconds" --owner=0 --group=0 --numeric-owner --format=ustar \
  --mode=u=rwX,go=rX -C "$work/packed" -cf - "${file%.tar.gz}" | gzip -9n >"$out/$file"
