#!/bin/sh
# Draws in a real OpenFlipper by mouse events on a virtual display, and checks the results: an open and a
# closed curve, a moved and a pinned point, the slider of tau, undo, redo, writing and reading. usage:
# mouse.sh TALWEG SCENES PLUGINS [PICTURES]; the environment as for batch.sh. Exit code 77: there is no
# OpenFlipper, Xvfb or xdotool.
set -eu
talweg=$1 scenes=$2 plugins=$3 pictures=${4:-}
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
for tool in Xvfb xdotool; do
  if ! command -v "$tool" >/dev/null; then
    echo "skipped: $tool is missing (apt install xvfb xdotool)"
    exit 77
  fi
done
folder=$(mktemp -d)
number=${TALWEG_DISPLAY:-97}
Xvfb ":$number" -screen 0 1000x900x24 +extension GLX >/dev/null 2>&1 &
server=$!
host=
finish() {
  [ -z "$host" ] || kill "$host" 2>/dev/null || true
  kill "$server" 2>/dev/null || true
  rm -rf "$folder"
}
trap finish EXIT
sleep 2

"$scenes" "$folder" >/dev/null
DISPLAY=:$number HOME=$folder/home XDG_RUNTIME_DIR=$folder TALWEG_PLUGIN_PATH=$plugins
TALWEG_PROBE=$folder/asked
export DISPLAY HOME XDG_RUNTIME_DIR TALWEG_PLUGIN_PATH TALWEG_PROBE
mkdir -p "$HOME/.OpenFlipper/ACG"
printf '[PluginControl]\nAdditionalPlugins=%s, %s\n' "$TALWEG_OPENFLIPPER_PLUGIN" "$probe" \
  >"$HOME/.OpenFlipper/ACG/OpenFlipper.ini"
log=$HOME/.OpenFlipper/OpenFlipper.log
through=$(sed 's/^--through //; s/ .*//' "$folder/vessel.through" | cut -d , -f 1-12)
sed "s#@FOLDER@#$folder#g; s#@THROUGH@#$through#" "$here/mouse.ofs" >"$folder/mouse.ofs"
"$TALWEG_OPENFLIPPER" "$folder/mouse.ofs" >"$folder/console" 2>&1 &
host=$!

fail() {
  echo "FAILED: $1"
  tail -n 20 "$log" "$folder/console" || true
  [ -z "$pictures" ] || import -window root "$pictures/failed.png" || true
  exit 1
}
# Waits until the log has a line, after the last mark, that matches.
marked=0
mark() { marked=$(wc -l <"$log"); }
expect() {  # PATTERN WHAT
  for _ in $(seq 100); do
    if tail -n "+$((marked + 1))" "$log" 2>/dev/null | grep -aq "$1"; then
      echo "ok: $2: $(tail -n "+$((marked + 1))" "$log" | grep -a "$1" | tail -n 1 |
        sed 's/, The result cuts.*//')"
      return
    fi
    sleep 0.3
  done
  fail "$2 (no '$1' in the log)"
}
picture() { [ -z "$pictures" ] || { sleep 1; import -window root "$pictures/$1.png"; }; }
click() { xdotool mousemove "$1" "$2"; sleep 0.2; xdotool click 1; sleep 0.4; }
# clicks X,Y...: clicks points of the screen, one after the other.
clicks() { for at in "$@"; do click "${at%,*}" "${at#*,}"; done; }
# Asks the probe for a widget: the panel scrolls to it, and the log gets its place and text.
ask() {
  echo "$1" >"$TALWEG_PROBE"
  for _ in $(seq 100); do [ -e "$TALWEG_PROBE" ] || return 0; sleep 0.1; done
  fail "the probe answers"
}
place() { grep -a " : WIDGET $1 " "$log" | tail -n 1 | sed "s/.*WIDGET $1 //"; }  # x y width height
middle() { place "$1" | awk '{ print int($1 + $3 / 2), int($2 + $4 / 2) }'; }
press() { ask "$1"; click $(middle "$1"); }
row() {  # NUMBER: clicks the name in a row of the list of curves
  ask talwegCurves
  set -- "$1" $(place talwegCurves)
  click "$(($2 + 50))" "$(($3 + 14 + 19 * $1))"
}
# Types a file's name into the open dialog.
type_name() { sleep 2; xdotool type --delay 30 "$1"; xdotool key Return; sleep 1; }

for _ in $(seq 100); do grep -aq ' : READY' "$log" 2>/dev/null && break; sleep 0.5; done
grep -aq ' : READY' "$log" || fail "the host is ready"
expect "has changed and is opened again" "the host moves a mesh"
expect "MOVED \([0-9.]*[0-9]\{9\}\)[0-9]* \1" "the curve on the moved mesh has the same length"
expect "DELETED 1 true 2 1 true 2 true 1 true 0 false" "deleted lines are curves less, until undo"
sleep 2

mark
clicks 178,280 187,320
expect "SCENE drawn [1-9]" "what is drawn is a line in the scene"
mark
xdotool mousemove 184 335; sleep 0.2; xdotool mousemove 181 350
expect "SCENE drawn [1-9][0-9]* leg [1-9]" "the next leg follows the mouse before the click"
clicks 181,350 190,375 185,395 208,410 222,436 245,422 268,440 290,428 318,468
if grep -aq "OFF THE SURFACE" "$log"; then fail "the drawn lines lie on the surface"; fi
echo "ok: the drawn lines lie on the surface"
picture drawing
xdotool key BackSpace
expect "1 curve(s)" "an open curve, its last point taken back"
clicks 318,450
mark
xdotool key Return
expect "Finish curve" "Enter ends the curve"

mark
clicks 330,330 345,322 360,327 378,322 396,337 390,352 400,368 385,380 380,398 350,392 328,385 334,360
click 330 330
expect "Draw\|Close curve" "a click on the first point closes a curve"
expect "2 curve(s)" "two curves"
picture closed

mark
xdotool mousemove 245 422 click --repeat 2 --delay 80 1
expect "Pin point" "a double click pins a point"
sleep 2
expect "2 curve(s)" "the two curves, one with the pin"

mark
xdotool mousemove 208 410 mousedown 1
for x in 206 204 202 200; do xdotool mousemove "$x" 415; sleep 0.1; done
xdotool mouseup 1
expect "Move point" "a point is dragged"
expect "2 curve(s)" "the two curves, one with the dragged point"
moved=$(grep -a "curve(s)" "$log" | tail -n 1 | sed 's/.*length //; s/, deviation.*//')

mark
ask talwegTauSlider
set -- $(place talwegTauSlider)
y=$(($2 + $4 / 2))
xdotool mousemove "$(($1 + $3 / 4 + 3))" "$y" mousedown 1
for part in 40 50 60 70 80; do xdotool mousemove "$(($1 + $3 * part / 100))" "$y"; sleep 0.2; done
xdotool mouseup 1
expect "Name : 'Tau'" "the slider is one step"
expect "tau [1-9][0-9.]*" "tau follows"
picture slider
sled=$(grep -a "curve(s)" "$log" | tail -n 1 | sed 's/.*length //; s/, deviation.*//')
[ "$sled" != "$moved" ] || fail "the slider changes the curves"

mark
click 551 46  # the host's own undo
expect "length $moved" "the host's undo brings the curves back to the last digit"
mark
press talwegRedo
expect "length $sled" "redo brings the later curves back"

press talwegWriteResult
mark
type_name "$folder/result.json"
expect "Wrote" "the result is written"
press talwegWriteDrawing
mark
type_name "$folder/drawing.json"
expect "Wrote" "the drawing is written"
mark
press talwegClear
sleep 1
press talwegReadDrawing
type_name "$folder/drawing.json"
expect "2 curve(s)" "the drawing is read again"
"$talweg" --quiet measure "$folder/vessel.ply" "$folder/result.json" "$folder/drawing.json" \
  --report "$folder/measured.json"
echo "ok: the driver reads both: $(grep -o '"length": [0-9.]*' "$folder/measured.json" | head -n 1)"

mark
xdotool mousemove 472 275 mousedown 1
for at in "468 300" "476 315" "486 325" "488 340" "502 350" "496 365" "502 380" "488 395" "488 412" \
  "472 422" "468 438" "450 445" "440 460" "420 455"; do
  xdotool mousemove $at
  sleep 0.15
done
xdotool mouseup 1
expect "Name : 'Draw'" "a painted stroke is one step"
xdotool key Return
expect "3 curve(s)" "the painted curve"
mark
clicks 300,500 310,520
xdotool key Escape
expect "Drop curve" "Esc drops a curve"
expect "3 curve(s)" "three curves are left"
picture painted

# The view moves during drawing, and the unfinished curve stays.
clicks 300,500
for button in 2 3; do
  mark
  xdotool mousemove 500 600 mousedown $button
  for x in 510 520 530; do xdotool mousemove $x 605; sleep 0.1; done
  for x in 520 510 500; do xdotool mousemove $x 600; sleep 0.1; done
  xdotool mouseup $button
  expect "VIEW CHANGED" "the view follows button $button"
done
mark
xdotool click 4 click 5
expect "VIEW CHANGED" "the view follows the wheel"
xdotool key Escape
mark
xdotool keydown shift mousemove 300 500 click 1 keyup shift mousemove 500 600 key ctrl+z
expect "undo\|Undo\|curve(s)" "Ctrl+Z"
mark
xdotool key ctrl+y
sleep 1
if tail -n "+$((marked + 1))" "$log" | grep -aq "Created backup.*'Draw'"; then fail "Shift and a click beside a point draw nothing"; fi
echo "ok: Shift and a click beside a point draw nothing"

# Boxes and dialogs get their keys although a curve is being drawn.
clicks 300,500 310,520
press talwegTauBox
mark
xdotool key ctrl+a BackSpace 3 Return
expect "tau 3," "Backspace and Enter in a box are the box's"
press talwegWriteDrawing
sleep 2
xdotool key BackSpace Escape
sleep 1
click 310 520  # its last point, which gives the viewer the focus
mark
xdotool key Return
expect "Finish curve" "Enter finishes the curve that was being drawn, with both points"
expect "4 curve(s)" "the finished curve is the fourth"
mark
for _ in 1 2 3 4; do press talwegUndo; done  # its end, tau, its two points
expect "3 curve(s)" "undo takes the fourth curve away"

# Curves as objects of the scene.
says() {  # WIDGET PATTERN WHAT
  mark
  ask "$1"
  expect "TEXT $1: $2" "$3"
}
row 2
says talwegCurves "row .*, selected Curve 2 .*, row Curve 3" "a click in the list selects a curve"
click 245 422  # a pin of the first one
says talwegCurves "selected Curve 1" "a click on a point selects its curve"
mark
click 211 425
says talwegCurves "selected Curve 1 [^,]*, row Curve 2 [^,]*, row Curve 3 [^,]*$" \
  "a click on a curve selects it, and draws nothing"
mark
xdotool keydown ctrl mousemove 187 336 click 1 keyup ctrl
expect "Name : 'Insert point'" "Ctrl and a click on a curve insert a point"
expect "3 curve(s)" "the curve with the inserted point is still one of three"
mark
press talwegPin
expect "Name : 'Pin curve'" "the points of the selected curve are pinned"
mark
press talwegOwnTauTick
expect "Name : 'Tau of curve'" "the selected curve gets a tau of its own"
mark
press talwegClosed
expect "Name : 'Close curve'" "the selected curve is closed"
mark
press talwegClosed
expect "Name : 'Open curve'" "the selected curve is opened"
ask talwegCurves
set -- $(place talwegCurves)
mark
xdotool mousemove "$(($1 + 50))" "$(($2 + 33))" click --repeat 2 --delay 80 1
sleep 1
xdotool type --delay 30 "dome"
xdotool key Return
expect "Name : 'Rename curve'" "a double click names a curve"
says talwegCurves "selected dome" "the list has the name"
mark
press talwegRemove
expect "Name : 'Remove curve'" "the selected curve is removed"
expect "2 curve(s)" "two curves are left"
mark
press talwegUndo
expect "3 curve(s)" "undo brings the removed curve back"
mark
press talwegPoints
expect "SCENE drawn [1-9][0-9]* leg 0 points 0 " "points can be hidden"
press talwegPoints

# Combs, the places of the largest values, colours.
mark
press talwegComb
expect "comb [1-9]" "a comb of curvature"
says talwegCombText ".*[1-9].*1/unit" "the panel tells the scale of the comb"
mark
press talwegMark
xdotool key Down Return
expect "VIEW CHANGED" "the view turns to the largest deviation"
says talwegMarkText "[0-9.]* units, Curve 3" "the panel tells the largest deviation"
picture comb
press talwegComb
mark
press talwegColours
xdotool key Down Return
sleep 2
picture deviation
press talwegColours
xdotool key Down Return
sleep 3
picture distance
kill -0 "$host" || fail "the host still runs"
echo "TALWEG MOUSE OK"
