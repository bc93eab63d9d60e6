#!/usr/bin/env bash
# Counts instructions per stage and compares them with instructions.txt, or stores them there.
# usage: check_instructions.sh PROGRAM FOLDER [--store]
set -euo pipefail
program=$1 folder=$2 mode=${3:-}
stored=$(dirname "${BASH_SOURCE[0]}")/instructions.txt
limit=5 # percent

compiler=$("$program" --compiler)
if [[ $mode != --store ]]; then
  known=$(sed -n 's/^# compiler: //p' "$stored")
  if [[ $known != "$compiler" ]]; then
    echo "Skipped: the stored counts are of $known, this is $compiler."
    echo "Another compiler makes other instructions; './run bench --store' stores its counts."
    exit 0
  fi
fi

mkdir -p "$folder"
rm -f "$folder"/callgrind.*
valgrind --tool=callgrind --collect-atstart=no --callgrind-out-file="$folder/callgrind" \
  "$program" >"$folder/valgrind.log" 2>&1 ||
  { tail -n 20 "$folder/valgrind.log" >&2; exit 1; }

# Each dump names its stage and ends with its total.
for dump in "$folder"/callgrind.*; do
  awk '/^desc: Trigger: Client Request: / { stage = $5 }
       /^(summary|totals): / { count = $2 }
       /^part: / { part = $2 }
       END { if (stage != "") print part, stage, count }' "$dump"
done | sort -n | awk '{ print $2, $3 }' >"$folder/instructions.txt"
stages=$("$program" --stages)
(($(wc -l <"$folder/instructions.txt") == stages)) || { echo "not every stage was counted" >&2; exit 1; }

if [[ $mode == --store ]]; then
  { echo "# Instructions per stage on the generated mesh of 50,000 faces (./run bench --store)."
    echo "# factor, solve and set_curve depend on the BLAS, too, and OpenBLAS on the processor."
    echo "# compiler: $compiler"
    cat "$folder/instructions.txt"; } >"$stored"
  cat "$stored"
  exit 0
fi

awk -v limit="$limit" '
  /^#/ { next }
  NR == FNR { stored[$1] = $2; next }
  {
    if (!($1 in stored)) { printf "%-12s %14d not stored  <-- new\n", $1, $2; failed = 1; next }
    change = 100 * ($2 / stored[$1] - 1)
    bad = change > limit || change < -limit
    printf "%-12s %14d stored %14d  %+6.1f %%%s\n", $1, $2, stored[$1], change, bad ? "  <-- beyond" : ""
    if (bad) failed = 1
  }
  END { exit failed }' "$stored" "$folder/instructions.txt" ||
  { echo "Instruction counts changed by more than $limit %; if on purpose: ./run bench --store" >&2; exit 1; }
