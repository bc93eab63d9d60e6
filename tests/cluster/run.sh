#!/usr/bin/env bash
# run.sh BIN SOURCE FOLDER: runs the examples of docs/many.md on a cluster: Slurm's job array with a dependent
# job, Snakemake with Slurm, dask. Tasks, nodes and workers are killed meanwhile, and every file must equal
# that of `talweg smooth --batch`. Needs root; takes minutes. Not part of CI.
set -euo pipefail
bin=$1 source=$2 folder=$3
here=$(dirname "$(realpath "$0")")
fail() {
  printf 'cluster: %s\n' "$*" >&2
  exit 1
}
say() { printf '%4d s  %s\n' "$SECONDS" "$*"; }

rm -rf "$folder"
mkdir -p "$folder"
folder=$(realpath "$folder")
cluster=$folder/slurm_cluster
# shellcheck source=tests/cluster/slurm.sh
. "$here/slurm.sh"
export PATH=$bin:$PATH
cd "$folder"

# The page's file of this name.
page_file() {
  awk -v mark="<!-- file: $1 -->" '
    $0 == mark { found = 1; next }
    found && /^```/ { if (++fences == 2) exit; next }
    found { print }' "$source/docs/many.md" >"$1"
  [[ -s $1 ]] || fail "docs/many.md has no file $1"
}

compare_with_batch() { # compare_with_batch WHAT FOLDER TABLE
  local name
  for name in batch/*.vtp; do
    cmp "$name" "$2/${name#batch/}" || fail "$1: ${name#batch/} is not that of --batch"
  done
  # Without the column `line`, which has the line in another table.
  diff <(cut -d , -f 2- batch.csv | sort) <(cut -d , -f 2- "$3" | sort) >/dev/null ||
    fail "$1: the table is not that of --batch"
  say "$1: $(find "$2" -name '*.vtp' | wc -l) files and the table are those of --batch"
}

some_rows_of() { [[ $(cat slurm/"$1".csv.part 2>/dev/null | wc -l) -gt 10 ]]; }

# A task that runs on the node and has written results.
task_on() {
  local task
  for task in $(squeue -h -t running -w "$1" -o %K); do
    if some_rows_of "$task"; then
      echo "$task"
      return
    fi
  done
  return 1
}

slurm_test() {
  page_file smooth.sbatch
  page_file submit.sh
  mkdir -p slurm
  . ./submit.sh
  wait_for 60 "task at work on n1" task_on n1 >/dev/null
  local task
  task=$(task_on n1)
  say "Slurm: task $task is started again after $(wc -l <slurm/"$task".csv.part) lines"
  scontrol requeue "${job}_$task"
  wait_for 60 "task at work on n2" task_on n2 >/dev/null
  say "Slurm: node n2 dies during task $(task_on n2)"
  kill_node n2
  wait_for 60 "node that is down" eval '[[ $(sinfo -h -N -n n2 -o %t) == down* ]]'
  say "Slurm: n2 is down; its task waits again"
  start_node n2
  wait_for 600 "end of the array" job_is_over "$job"
  wait_for 120 "table" test -s slurm.csv
  wait_for 60 "end of the last job" eval '[[ -z $(squeue -h) ]]'
  compare_with_batch Slurm slurm slurm.csv
}

snakemake_test() {
  page_file Snakefile
  page_file config.yaml
  page_file status.sh
  chmod +x status.sh
  snakemake --quiet all --profile . --cores 2 --groups smooth=smooth \
    --group-components smooth=100 >snakemake.log 2>&1 &
  local engine=$!
  wait_for 120 "output of Snakemake" eval '[[ $(ls snakemake 2>/dev/null | wc -l) -gt 50 ]]'
  say "Snakemake: node n2 dies after $(find snakemake -name '*.csv' | wc -l) runs"
  kill_node n2
  wait_for 60 "node that is down" eval '[[ $(sinfo -h -N -n n2 -o %t) == down* ]]'
  start_node n2
  wait "$engine" || fail "Snakemake failed: $(tail -n 5 snakemake.log)"
  compare_with_batch Snakemake snakemake snakemake.csv
}

say "generating vessels"
talweg-scenes --patients 2000 vessels
mv vessels/cases.csv .
talweg --quiet smooth --batch cases.csv --tau 2 -o 'batch/{patient}.vtp' --summary batch.csv --jobs 2
say "2,000 vessels by --batch"
start_slurm
slurm_test
head -n 401 cases.csv >fewer.csv
mv fewer.csv cases.csv
rm -r batch
talweg --quiet smooth --batch cases.csv --tau 2 -o 'batch/{patient}.vtp' --summary batch.csv --jobs 2
snakemake_test
PYTHONPATH=$source/plugins/hosts/python TALWEG_PLUGIN_PATH=$bin/../lib/talweg/plugins \
  PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 "$here/dask_test.py" "$source/docs/examples" "$folder"
say "all is well"
