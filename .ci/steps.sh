# shellcheck shell=bash
# Functions of .ci/run and .ci/nightly. A script sources this file, defines a function step_NAME for each step,
# and calls run_steps with a line "NAME  WHAT" for each step, in order. Steps after a failed step still run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DEBIAN_FRONTEND=noninteractive
export TALWEG_CMAKE_ARGS="-DTALWEG_WERROR=ON ${TALWEG_CMAKE_ARGS:-}"
jobs=${TALWEG_JOBS:-$(nproc)}
SECONDS=0

# The folder in which this machine stores the last commits that passed.
memory=${XDG_CACHE_HOME:-$HOME/.cache}/talweg

root=()
if ((EUID != 0)); then root=(sudo); fi

# Runs apt-get; prints its output only if it fails.
quiet_apt() {
  local log
  log=$(mktemp)
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get "$@" >"$log" 2>&1 || {
    tail -n 20 "$log"
    rm -f "$log"
    return 1
  }
  rm -f "$log"
}

# install PACKAGE...: installs missing packages; NAME- removes a package.
install() {
  local package missing=()
  for package; do
    if [[ $package == *- ]]; then
      if is_installed "${package%-}"; then missing+=("$package"); fi
    elif ! is_installed "$package"; then
      missing+=("$package")
    fi
  done
  ((${#missing[@]} > 0)) || return 0
  quiet_apt update -qq
  quiet_apt install -y -qq --no-install-recommends "${missing[@]}"
}

is_installed() { [[ $(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null) == ii* ]]; }

# configure PRESET CMAKE-ARGUMENT...
configure() { cmake --preset "$1" -DTALWEG_WERROR=ON "${@:2}" >/dev/null; }

# test_in FOLDER ALLOWED-SKIPS CTEST-ARGUMENT...
test_in() {
  local status=0
  ctest --test-dir "$1" --output-on-failure --parallel "$jobs" --output-junit tests.xml \
    --test-output-size-passed 1000000 --timeout 600 "${@:3}" || status=$?
  .ci/skips "$1/tests.xml" "$2" || status=1
  return $status
}

# Reasons for which a test may be skipped: missing programs that Debian does not have, and, without the folder
# of meshes, missing meshes.
not_here='OpenFlipper|trimesh|pyvista|OpenBLAS with threads'
meshes=${TALWEG_MESHES:-../shared/meshes}
if [[ ! -d $meshes || ! -d $meshes/../reference ]]; then not_here+='|TALWEG_MESHES'; fi

slow_under_sanitizers='TheResultFollowsTau|Reference|RealMesh|RealBuildings'

# Selects the BLAS that ./run installs; tests of the factorization choose others by name.
use_serial_openblas() {
  local arch library
  arch=$(g++ -print-multiarch)
  for library in lib{blas,lapack}.so.3 libopenblas.so.0; do
    "${root[@]}" update-alternatives --quiet --set "$library-$arch" \
      "/usr/lib/$arch/openblas-serial/$library"
  done
}

table=()
failed=0

# run_step NAME WHAT: runs a step in a shell of its own, so that -e ends only the step.
run_step() {
  local begin=$SECONDS status=0 outcome=ok
  printf '\n== %s: %s (%d min %02d s so far)\n' "$1" "$2" $((SECONDS / 60)) $((SECONDS % 60))
  set +e
  (
    set -e
    source .ci/cache.sh  # an earlier step may have installed ccache
    "step_$1"
  )
  status=$?
  set -e
  if ((status != 0)); then
    outcome=FAILED
    failed=1
  fi
  local seconds=$((SECONDS - begin))
  table+=("$(printf '%-7s %3d min %02d s  %s: %s' $outcome $((seconds / 60)) $((seconds % 60)) "$1" "$2")")
}

# run_steps "WANTED NAMES" <steps: runs all steps, or the wanted ones, and prints a table at the end. `failed`
# is 1 if a step has failed. Must not be called in a condition, in which -e would not end a step at its
# failure.
run_steps() {
  local wanted=$1 name what known=' ' steps=()
  while read -r name what; do
    [[ -n $name ]] || continue
    known+="$name "
    if [[ -z $wanted || " $wanted " == *" $name "* ]]; then steps+=("$name $what"); fi
  done
  for name in $wanted; do
    [[ $known == *" $name "* ]] || {
      echo "There is no step $name, but these:$known" >&2
      exit 2
    }
  done
  for what in "${steps[@]}"; do run_step "${what%% *}" "${what#* }"; done
  # The failed tests are repeated at the end of the output.
  if ((failed != 0)); then .ci/failed "$((SECONDS + 60))" build/tests.xml build/*/tests.xml; fi
  printf '\n== %d min %02d s\n' $((SECONDS / 60)) $((SECONDS % 60))
  printf '%s\n' "${table[@]}"
}
