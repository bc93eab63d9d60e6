#!/bin/sh
# any_linux.sh OUT ROOT [SUITE [MIRROR]]: tries what ./run release made (OUT) in a new minimal Debian SUITE
# (bullseye) with nothing but Python and numpy: the first example of docs/python.md, and the archive from
# two folders, without leftovers. Prints the disk space and the time of both. Needs root, debootstrap and
# the network. Not part of CI.
set -eu
out=$1 root=$2 suite=${3:-bullseye} mirror=${4:-http://deb.debian.org/debian}
page=$(cd "$(dirname "$0")/../../docs" && pwd)/python.md
start=$(date +%s)
debootstrap --variant=minbase --include=python3,python3-pip,python3-numpy "$suite" "$root" "$mirror" \
  >"$root.log" 2>&1
echo "minimal root: $(du -smx "$root" | cut -f1) MiB, $(($(date +%s) - start)) s"
# Programs find their own path, and the libraries beside them, by /proc.
mount -t proc proc "$root/proc"
trap 'umount "$root/proc"' EXIT
mkdir "$root/given"
cp "$out"/*_x86_64.whl "$out"/talweg-*-linux-x86_64.tar.gz "$root/given"
awk '/^## The first/ { here = 1 } here && /^```$/ { exit } code; here && /^```python/ { code = 1 }' \
  "$page" >"$root/given/example.py"

cat >"$root/given/try.sh" <<'INSIDE'
set -eu
cd /given
export PYTHONDONTWRITEBYTECODE=1 PIP_NO_CACHE_DIR=1 PIP_ROOT_USER_ACTION=ignore PIP_BREAK_SYSTEM_PACKAGES=1
now() { date +%s%3N; } # milliseconds
before=$(du -smx / | cut -f1)
list() { find / -xdev -not -path '/proc*' -not -path '/given*' | sort; }
list >before.txt
start=$(now)
pip3 install -q --no-index *.whl
echo "wheel: installed in $(($(now) - start)) ms"
echo "wheel: $(($(du -smx / | cut -f1) - before)) MiB"
start=$(now)
python3 example.py
echo "wheel: first example in $(($(now) - start)) ms"
pip3 uninstall -q -y talweg
list | diff before.txt - || { echo "left behind by the wheel"; exit 1; }

printf 'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n' >m.obj
mkdir one
start=$(now)
tar -xzf talweg-*.tar.gz -C one --strip-components=1
echo "archive: unpacked in $(($(now) - start)) ms"
echo "archive: $(du -sm one | cut -f1) MiB"
for folder in one "another folder"; do
  if [ ! -d "$folder" ]; then mv one "$folder"; fi
  talweg="./$folder/bin/talweg"
  start=$(now)
  "$talweg" draw m.obj --through 0,1,4,5 -o drawn.json
  "$talweg" smooth m.obj --curve drawn.json -o smooth.vtp
  echo "archive: first curve drawn and smoothed in $(($(now) - start)) ms"
  test "$("$talweg" plugins | wc -l)" -ge 11
  "$talweg" smooth m.obj --curve drawn.json --potential paper -o smooth.vtp
  test -s smooth.vtp
  rm smooth.vtp
done
rm -r "$folder"
list | diff before.txt - || { echo "left behind by the archive"; exit 1; }
echo "runs in two folders, and leaves nothing behind"
INSIDE
env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root chroot "$root" sh /given/try.sh  # nothing of ours gets in
