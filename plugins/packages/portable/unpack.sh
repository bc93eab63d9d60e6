#!/bin/sh
# unpack.sh FOLDER SUITE ARCHITECTURE PACKAGE...: unpacks Debian packages, without their dependencies, into FOLDER;
# FOLDER/versions lists them. Nothing is installed, so the packages may be for another kind of machine, or conflict
# with installed packages. Needs apt and, the first time, the network.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd) suite=$2 architecture=$3
shift 3
for package; do
  grep -qs "^$package " "$folder/versions" || missing="${missing-} $package"
done
[ -n "${missing-}" ] || exit 0

apt=$folder.apt
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
  "http://deb.debian.org/debian $suite main" >"$apt/sources.list"
quietly() { "$@" >"$apt/log" 2>&1 || { tail -n 10 "$apt/log" >&2; exit 1; }; }
from_debian() { # APT-GET-ARGUMENT...: with lists of our own
  quietly apt-get -qq -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache" -o Dir::State::status=/dev/null \
    -o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o APT::Sandbox::User=root "$@"
}
from_debian update
cd "$apt"
# shellcheck disable=SC2086  # several packages
from_debian download $missing
for file in *.deb; do
  dpkg-deb -x "$file" "$folder"
  # shellcheck disable=SC2016  # dpkg-deb's variables
  dpkg-deb -W --showformat '${Package} ${Version}\n' "$file" >>"$folder/versions"
  rm "$file"
done
