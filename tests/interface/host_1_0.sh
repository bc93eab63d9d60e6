#!/bin/sh
# host_1_0.sh SOURCES INCLUDE FOLDER PLUGIN...: a host in C built with the header of the interface 1.0 runs
# the plugins, with the same results as in a host built with the present header.
set -eu
sources=$1 include=$2 folder=$3
shift 3
cc -std=c11 -O1 -Wall -Werror -I"$sources/host_1_0" "$sources/host_1_0/host.c" -ldl -o "$folder/host_1_0"
cc -std=c11 -O1 -Wall -Werror -I"$include" "$sources/host_1_0/host.c" -ldl -o "$folder/host_now"
"$folder/host_1_0" "$@" >"$folder/host_1_0.txt"
"$folder/host_now" "$@" >"$folder/host_now.txt"
cmp "$folder/host_1_0.txt" "$folder/host_now.txt"
grep -q '^talweg.cut' "$folder/host_1_0.txt"
grep -q '^  mesh' "$folder/host_1_0.txt"
# Only talweg.labels needs a parameter of a type that 1.0 does not have.
if [ "$(grep -c '^  status [^0]' "$folder/host_1_0.txt")" != 1 ]; then
  grep '^talweg\|^  status' "$folder/host_1_0.txt" >&2
  exit 1
fi
grep -q 'There are no labels' "$folder/host_1_0.txt"
