# The programs of docs/examples on the sandbox's files.
set -eu -o pipefail
talweg draw vessel.ply --through 12,845,9001 -o drawn.json

smooth_file vessel.ply drawn.json smooth.vtp 2 >smooth.txt
grep 'curve 0: converged' smooth.txt
test -s smooth.vtp
if smooth_file vessel.ply missing.json smooth.vtp 2>error.txt; then exit 1; fi
grep 'missing.json' error.txt

tau_sweep vessel.ply drawn.json | tee table.txt
test "$(grep -c converged table.txt)" = 10
