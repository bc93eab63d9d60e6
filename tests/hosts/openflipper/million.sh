#!/bin/sh
# Prints the time of a slider's step at a million faces by million.ofs; tests no bound. Arguments and
# environment as for batch.sh. With DISPLAY and PICTURES as 4th argument in a window.
set -eu
scenes=$2 plugins=$3 pictures=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
probe=$(dirname "${TALWEG_OPENFLIPPER_PLUGIN:-}")/libPlugin-TalwegProbe.so
if [ ! -x "${TALWEG_OPENFLIPPER:-}" ] || [ ! -f "${TALWEG_OPENFLIPPER_PLUGIN:-}" ]; then
  echo "skipped: TALWEG_OPENFLIPPER and TALWEG_OPENFLIPPER_PLUGIN name no OpenFlipper and no" \
    "Plugin-Talweg; docs/openflipper.md tells how to get both"
  exit 77
fi
if [ ! -f "$probe" ]; then
  echo "skipped: there is no $probe; build the plugin with -DTALWEG_BUILD_PROBE=ON"
  exit 77
fi
folder=$(mktemp -d)
host=
finish() {
  [ -z "$host" ] || kill "$host" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT
"$scenes" "$folder" >/dev/null
/usr/bin/python3 "$here/refine.py" "$folder/vessel.ply" "$folder/million.ply" 2
through=$(sed 's/^--through //; s/ .*//' "$folder/vessel.through")
sed "s#@FOLDER@#$folder#g; s#@THROUGH@#$through#" "$here/million.ofs" >"$folder/million.ofs"

HOME=$folder/home XDG_RUNTIME_DIR=$folder TALWEG_PLUGIN_PATH=$plugins
export HOME XDG_RUNTIME_DIR TALWEG_PLUGIN_PATH
mkdir -p "$HOME/.OpenFlipper/ACG"
printf '[PluginControl]\nAdditionalPlugins=%s, %s\n' "$TALWEG_OPENFLIPPER_PLUGIN" "$probe" \
  >"$HOME/.OpenFlipper/ACG/OpenFlipper.ini"
log=$HOME/.OpenFlipper/OpenFlipper.log
if [ -n "$pictures" ]; then
  "$TALWEG_OPENFLIPPER" "$folder/million.ofs" >"$folder/console" 2>&1 &
  host=$!
  for _ in $(seq 120); do grep -aq 'MILLION OK' "$log" 2>/dev/null && break; sleep 1; done
  sleep 3
  import -window root "$pictures/million.png"
else
  sed -i '/setToolBoxActive/d' "$folder/million.ofs"
  QT_QPA_PLATFORM=offscreen timeout 300 "$TALWEG_OPENFLIPPER" --batch "$folder/million.ofs" \
    >"$folder/console" 2>&1 || true
fi
grep -a 'Talweg : .*open after\|curve(s)\|Scripting' "$log" | sed "s#$folder#FOLDER#g" || true
grep -aq 'FACES 962336' "$log" && grep -aq 'MILLION OK' "$log"
