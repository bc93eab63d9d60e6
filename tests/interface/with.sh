#!/bin/sh
# with.sh COMPILER ARGUMENT...: runs it; skipped (77) where there is no such compiler.
compiler=$1
shift
command -v "$compiler" >/dev/null || { echo "skipped: there is no $compiler"; exit 77; }
exec "$compiler" "$@"
