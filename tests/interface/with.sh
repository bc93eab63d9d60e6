#!/bin/sh
# with.sh COMPILER ARGUMENT...: runs a compiler; skipped (77) without this compiler.
compiler=$1
shift
command -v "$compiler" >/dev/null || { echo "skipped: there is no $compiler"; exit 77; }
exec "$compiler" "$@"
