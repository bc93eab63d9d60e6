#!/bin/sh
# Runs batch.ofs in a real OpenFlipper and compares its files with the driver's, byte for byte. usage:
# batch.sh TALWEG SCENES PLUGINS, with TALWEG_OPENFLIPPER (the program) and TALWEG_OPENFLIPPER_PLUGIN
# (libPlugin-Talweg.so) in the environment. Exit code 77: they are not given.
set -eu
talweg=$1 scenes=$2 plugins=$3
here=$(cd "$(dirname "$0")" && pwd)
if [ ! -x "${TALWEG_OPENFLIPPER:-}" ] || [ ! -f "${TALWEG_OPENFLIPPER_PLUGIN:-}" ]; then
  echo "skipped: TALWEG_OPENFLIPPER and TALWEG_OPENFLIPPER_PLUGIN name no OpenFlipper and no" \
    "Plugin-Talweg; docs/openflipper.md tells how to get both"
  exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$scenes" "$folder" >/dev/null
through=$(sed 's/^--through //; s/ .*//' "$folder/vessel.through" | cut -d , -f 1-12)
printf '%s\n' OFF '7 4 0' '0 0 0' '-1 0 0' '-1 -1 0' '0 -1 0' '1 0 0' '1 1 0' '0 1 0' \
  '3 0 1 2' '3 0 2 3' '3 0 4 5' '3 0 5 6' >"$folder/bowtie.off"

HOME=$folder/home
export HOME TALWEG_PLUGIN_PATH="$plugins" QT_QPA_PLATFORM=offscreen XDG_RUNTIME_DIR="$folder"
mkdir -p "$HOME/.OpenFlipper/ACG"
printf '[PluginControl]\nAdditionalPlugins=%s\n' "$TALWEG_OPENFLIPPER_PLUGIN" \
  >"$HOME/.OpenFlipper/ACG/OpenFlipper.ini"
loop=$(sed 's/^--through //; s/ .*//' "$folder/vessel.through")
sed "s#@FOLDER@#$folder#g; s#@THROUGH@#$through#; s#@LOOP@#$loop#" "$here/batch.ofs" >"$folder/batch.ofs"
timeout 300 "$TALWEG_OPENFLIPPER" --batch "$folder/batch.ofs" >"$folder/console" 2>&1 || true
log=$HOME/.OpenFlipper/OpenFlipper.log
grep -a ' : ok: \|FAILED\|Talweg\|TALWEG' "$log" | sed "s#$folder#FOLDER#g" || true
if ! grep -aq 'TALWEG BATCH OK' "$log"; then
  tail -n 30 "$log" "$folder/console"
  echo "no success line"
  exit 1
fi

pin=$(echo "$through" | cut -d , -f 3)
same() {  # NAME OPTION...
  name=$1
  shift
  "$talweg" --quiet smooth "$folder/vessel.ply" --curve "$folder/drawing.json" "$@" \
    -o "$folder/driver_$name.json"
  cmp "$folder/$name.json" "$folder/driver_$name.json"
  echo "same bytes as the driver: $name.json, $(wc -c <"$folder/$name.json") bytes"
}
same tau_1
same tau_6 --tau 6
same pinned --pin "$pin"

# The cut of the host's mesh equals the driver's.
"$talweg" --quiet cut "$folder/vessel.ply" --curve "$folder/loop.json" -o "$folder/driver_cut.off"
"$talweg" --quiet cut "$folder/vessel.ply" --curve "$folder/loop.json" -o "$folder/driver_part.off" \
  --split --cap
/usr/bin/python3 - "$folder" <<'PYTHON'
import sys


def mesh(name):
    """The vertices and faces of the host's PLY, in text, or of an OFF file."""
    lines = open(f"{sys.argv[1]}/{name}").read().splitlines()
    if name.endswith(".ply"):
        vertices, faces = (int(line.split()[2]) for line in lines if line.startswith("element "))
        lines = lines[lines.index("end_header") + 1 :]
    else:
        vertices, faces = map(int, lines[1].split()[:2])
        lines = lines[2:]
    points = [tuple(map(float, line.split()[:3])) for line in lines[:vertices]]
    return points, [tuple(map(int, line.split()[1:4])) for line in lines[vertices : vertices + faces]]


def area(points, faces):
    total = 0
    for a, b, c in ((points[k] for k in face) for face in faces):
        u = [q - p for p, q in zip(a, b)]
        v = [q - p for p, q in zip(a, c)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        total += sum(x * x for x in n) ** 0.5 / 2
    return total


for host, driver in ("cut", "driver_cut"), ("part_0", "driver_part-0"), ("part_1", "driver_part-1"):
    (p, f), (q, g) = mesh(f"{host}.ply"), mesh(f"{driver}.off")
    assert (len(p), len(f)) == (len(q), len(g)), (host, len(p), len(f), len(q), len(g))
    assert abs(area(p, f) - area(q, g)) < 1e-4 * area(q, g), (host, area(p, f), area(q, g))
    print(f"{host}.ply: {len(f)} faces and area {area(p, f):.4f}, as the driver's")
PYTHON

# The host's file stores the faces, vertices and edges of the points.
cmp "$folder/result.pol" "$folder/again.pol"
/usr/bin/python3 - "$folder" <<'PYTHON'
import json
import sys

points = json.load(open(sys.argv[1] + "/last.json"))["curves"][0]["points"]
words = open(sys.argv[1] + "/result.pol").read().split()


def handles(name):
    begin = words.index(name) + 1
    return [int(word) for word in words[begin : begin + len(points)]]


assert handles("VFHANDLES") == [point["face"] for point in points]
for point, vertex, edge in zip(points, handles("VVHANDLES"), handles("VEHANDLES")):
    zeros = point["barycentric"].count(0)
    assert (vertex >= 0) == (zeros == 2), point
    assert (edge >= 0) == (zeros == 1), point
print(f"handles of {len(points)} points in result.pol: the driver's faces; vertices and edges where they lie")
PYTHON
