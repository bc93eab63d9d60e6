#!/bin/sh
# autopkgtest.sh DEBS ROOT [MIRROR]: the tests in debian/tests, each on the Debian packages in DEBS, in a
# minimal Debian 12, which is made in ROOT if ROOT does not exist. Needs root, debootstrap, autopkgtest,
# dpkg-dev and the network. Not part of CI.
set -eu
debs=$(cd "$1" && pwd) root=$2 mirror=${3:-http://deb.debian.org/debian}
here=$(cd "$(dirname "$0")" && pwd)
if [ ! -e "$root/usr/bin/apt-get" ]; then
  debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 ||
    { tail -n 5 "$root.log" >&2; exit 1; }
fi
clean="env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8" # nothing of ours gets in
tree=$(mktemp -d)
# A test of this kind cannot remove the packages that it installs, so each test has a copy of the root.
trap 'rm -rf "$tree" "$root.copy"' EXIT
cp -r "$here/debian" "$here/../consumer" "$tree"
awk '/^## The first/ { here = 1 } here && /^```$/ { exit } code; here && /^```python/ { code = 1 }' \
  "$here/../../docs/python.md" >"$tree/example.py"
chmod +x "$tree"/debian/tests/*
for test in command-line python development; do
  rm -rf "$root.copy"
  cp -a "$root" "$root.copy"
  start=$(date +%s) log=$root.$test
  rm -rf "$log"
  $clean autopkgtest --quiet --test-name="$test" --output-dir="$log" --no-built-binaries --apt-upgrade \
    "$debs"/*.deb "$tree/" -- chroot "$root.copy" >"$root.$test.log" 2>&1 ||
    { tail -n 40 "$root.$test.log" >&2; exit 1; }
  echo "$(cat "$log/summary"), $(($(date +%s) - start)) s"
done
