# Runs the programs of docs/examples on the sandbox's files.
set -eu -o pipefail
talweg draw vessel.ply --through 12,845,9001 -o drawn.json

smooth_file vessel.ply drawn.json smooth.vtp 2 >smooth.txt
grep 'curve 0: converged' smooth.txt
test -s smooth.vtp
if smooth_file vessel.ply missing.json smooth.vtp 2>error.txt; then exit 1; fi
grep 'missing.json' error.txt

tau_sweep vessel.ply drawn.json | tee table.txt
test "$(grep -c converged table.txt)" = 10

# A host in C writes the same bytes as the driver.
talweg draw vessel.ply --through 12,845,9001 -o drawn.txt
plugin_host mesh.obj drawn.txt host.json 0.5 2 | tee host.txt
test "$(grep -c 'termination: converged' host.txt)" = 2
talweg smooth mesh.obj --curve drawn.txt --tau 2 -o driver.json
cmp host.json driver.json
if plugin_host mesh.obj drawn.txt host.json -1 2>error.txt; then exit 1; fi
grep 'Tau (tau) must be >= 0' error.txt

# A plugin outside Talweg, found by the variable.
TALWEG_PLUGIN_PATH=$(dirname "$(command -v talweg)")/example_plugins
export TALWEG_PLUGIN_PATH
talweg plugins | grep 'example.height'
talweg run example.height --help | grep -- '--level'
talweg run example.height mesh.obj --axis x --level 2 --write-height height.txt --report height.json
grep -c . height.txt >count.txt
test "$(cat count.txt)" = "$(grep -c '^v ' mesh.obj)"
test "$(nm -D --defined-only "$TALWEG_PLUGIN_PATH/height_plugin.so" | grep -c ' T ')" = 1

# A plugin with OpenMesh: it leaves a twentieth of the faces, and keeps the curve's faces.
talweg run example.decimate --help | grep -- '--share'
talweg run example.decimate mesh.obj --curve drawn.txt --share 0.05 --write-mesh small.ply --map map.json \
  --report decimated.json
grep '"faces": 1000' decimated.json
grep 'element face 1000' small.ply
test "$(nm -D --defined-only "$TALWEG_PLUGIN_PATH/decimate_plugin.so" | grep -c ' T ')" = 1

# Tools with OpenMesh: a curve that survives decimation, one mesh per region, a slider.
talweg draw mesh.obj --through 12,845 -o across.json
openmesh_decimate mesh.obj across.json decimated.obj | tee decimated.txt
grep 'edges of the curve are there, to the bit' decimated.txt
test "$(grep -c '^f ' decimated.obj)" -lt "$(($(grep -c '^f ' mesh.obj) / 15))"
if openmesh_decimate mesh.obj missing.json decimated.obj 2>error.txt; then exit 1; fi
grep 'missing.json' error.txt
awk '/^f /{print int(n++ * 3 / faces)}' faces="$(grep -c '^f ' mesh.obj)" mesh.obj >thirds.txt
openmesh_borders mesh.obj thirds.txt region | tee regions.txt
test "$(cut -d: -f1 regions.txt | sort -u | wc -l)" -ge 3
for region in 0 1 2; do talweg info "region-$region.obj" | grep usable; done
head -5 thirds.txt >few.txt
if openmesh_borders mesh.obj few.txt region 2>error.txt; then exit 1; fi
grep 'not a label for each face' error.txt
printf '0\n1\n2.5\n' | openmesh_slider mesh.obj 12 845 slider.om | tee slider.txt
test "$(grep -c '^tau' slider.txt)" = 3
talweg info slider.om | grep usable

# A host with OpenMesh, in single precision.
unset TALWEG_PLUGIN_PATH
openmesh_host mesh.obj 12 845 2 | tee faces.txt
test "$(grep -c 'from the drawing' faces.txt)" -gt 10
if openmesh_host mesh.obj 12 99999 2>error.txt; then exit 1; fi
grep '99999' error.txt
