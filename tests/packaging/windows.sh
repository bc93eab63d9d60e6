#!/usr/bin/env bash
# windows.sh OUT WORK [MESHES DRIVER]: tries the zip for Windows that ./run release made (OUT), by wine, in a
# new prefix and in folders with umlauts and spaces: every command, plugins, long paths, \ and drive letters,
# CRLF, Ctrl-C, files that others have open, wrong inputs; the loader in a program of its own. With MESHES
# (NAME.ply with NAME.through) and the DRIVER of this system also that results are the same (tests/agreement).
# Needs wine64, g++-mingw-w64-x86-64-posix and unzip.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
meshes=${3:+$(realpath "$3")}
driver=${4:+$(realpath "$4")}
wine=$(command -v wine64 || echo /usr/lib/wine/wine64)
export LC_ALL=C.UTF-8 WINEPREFIX=$work/prefix WINEDEBUG=-all
place="$work/Ünter Wegs"
rm -rf "$place" "$work/prefix"
mkdir -p "$place"
zip=$(echo "$1"/talweg-*-windows-x86_64.zip)
unzip -q "$zip" -d "$place"
tree=$(echo "$place"/talweg-*)
"$wine" wineboot -i >"$work/wineboot.log" 2>&1
talweg() { "$wine" "$tree/bin/talweg.exe" "$@"; }

fail() { echo "$1" >&2; exit 1; }
# refused CODE WORDS ARGUMENT...: the program ends with this code and one line that has these words.
refused() {
  local code=$1 words=$2 status=0
  shift 2
  talweg "$@" >"$work/out.log" 2>"$work/err.log" || status=$?
  [[ $status == "$code" ]] || fail "talweg $*: exit code $status, not $code: $(cat "$work/err.log")"
  grep -qF -- "$words" "$work/err.log" || fail "talweg $*: $(cat "$work/err.log")"
  [[ $(wc -l <"$work/err.log") == 1 ]] || fail "talweg $*: more than one line: $(cat "$work/err.log")"
}

mkdir "$place/Größe 1"
cd "$place/Größe 1"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n' >mäsh.obj
sed 's/$/\r/' mäsh.obj >crlf.obj

talweg --version | grep -q "^talweg [0-9]" || fail "no version"
talweg info mäsh.obj | grep -v '^time ' >info.txt
talweg info crlf.obj | sed 's/crlf/mäsh/' | grep -v '^time ' | cmp - info.txt || fail "CRLF is read otherwise"
talweg draw mäsh.obj --through 0,1,4,5 -o drawn.json
talweg smooth mäsh.obj --curve drawn.json -o smooth.vtp --report report.json
talweg smooth mäsh.obj --curve drawn.json --potential paper -o paper.vtp
talweg smooth mäsh.obj --curve drawn.json -q -o -.vtp >piped.vtp
cmp smooth.vtp piped.vtp || fail "the standard output has other bytes"
talweg measure mäsh.obj smooth.vtp >measured.txt
talweg cut mäsh.obj --curve drawn.json -o cut.ply
printf '0\n0\n1\n1\n0\n1\n' >labels.txt
talweg labels mäsh.obj labels.txt -o labels.vtp
test "$(talweg plugins | wc -l)" -ge 11 || fail "plugins are missing"
talweg plugins | grep -qi "refused\|cannot" && fail "a plugin was refused: $(talweg plugins)"

# Names: a drive's letter and \, forward slashes, links to the folder above, more than 260 characters.
drive=$("$wine" winepath -w "$PWD" | tr -d '\r')
talweg draw "$drive\\mäsh.obj" --through 0,1,4,5 -o "$drive\\again.json"
cmp drawn.json again.json || fail "another name gives another curve"
long=$(printf 'ein-langer-name-%02d/' {1..20})
mkdir -p "$long"
cp mäsh.obj "$long"
talweg draw "${long}mäsh.obj" --through 0,1,4,5 -o "${long}drawn.json"
cmp drawn.json "${long}drawn.json" || fail "a long name gives another curve"
talweg smooth mäsh.obj --curve drawn.json -o smooth.vtp # replaces the old file
test -z "$(find . -name '*.tmp*')" || fail "temporary files are left"

# Wrong inputs.
refused 2 "Cannot read nichts.obj: No such file or directory." info nichts.obj
refused 1 "would overwrite an input" draw mäsh.obj --through 0,1 -o "$drive\\MÄSH.obj"
refused 1 "would be written twice" draw mäsh.obj --through 0,1 -o neu.json -o NEU.json
mkdir -p ordner.obj
refused 2 "it is a directory" info ordner.obj
refused 1 "was not expected" smooht mäsh.obj
refused 2 "Cannot write nirgends" draw mäsh.obj --through 0,1 -o nirgends/drawn.json
echo "The program works: $(talweg --version | head -n 1 | tr -d '\r')"

# Other programs: one reads the old file for a while, another presses Ctrl-Break in a long computation.
gcc=x86_64-w64-mingw32-gcc-posix
$gcc -municode -O1 "$here/windows_habits.c" -o "$work/habits.exe"
habits() { "$wine" "$work/habits.exe" "$@"; }
program=$tree/bin/talweg.exe
before=$(cat smooth.vtp)
habits hold smooth.vtp 700 "$program" draw mäsh.obj --through 0,3 -o smooth.vtp ||
  fail "a file that is read for a moment is not replaced"
test "$before" != "$(cat smooth.vtp)" || fail "the old curve is still there"
status=0
habits hold smooth.vtp 9000 "$program" smooth mäsh.obj --curve drawn.json -o smooth.vtp 2>err.txt || status=$?
[[ $status == 2 ]] && grep -q "Cannot write smooth.vtp: another program has it open" err.txt ||
  fail "a file that is read for long: exit code $status, $(cat err.txt)"

# A host in C by another compiler, with the loader's library.
$gcc -I"$tree/include" "$here/../interface/list_plugins.c" "$tree/lib/talweg_loader.lib" -o "$tree/bin/list.exe"
test "$("$wine" "$tree/bin/list.exe" | wc -l)" -ge 11 || fail "the loader finds no plugins"
rm "$tree/bin/list.exe"
$gcc -I"$tree/include" "$here/../../docs/examples/plugin_host.c" "$tree/lib/talweg_loader.lib" \
  -o "$tree/bin/host.exe"
cp mäsh.obj mesh.obj
printf '0\n1\n5\n' >curve.txt
"$wine" "$tree/bin/host.exe" mesh.obj curve.txt host.json 1 >host.txt
rm "$tree/bin/host.exe"
talweg smooth mesh.obj --curve curve.txt --tau 1 -o program.json
tr -d '\r' <host.json | cmp - program.json || fail "the host in C has another curve than the program"
echo "The loader works"

if [[ -n $meshes ]]; then
  cat >"$work/talweg.exe.sh" <<SCRIPT
#!/bin/sh
exec "$wine" "$program" "\$@"
SCRIPT
  chmod +x "$work/talweg.exe.sh"
  python3 "$here/../agreement/agree.py" "$work/agreement" "$meshes" "$driver" "$work/talweg.exe.sh" --quick
fi
