#!/bin/sh
# layout.sh SOURCES INCLUDE FOLDER: compiles the assertions of layout.c, in C and in C++, with every available
# compiler.
set -eu
for compiler in gcc clang; do
  command -v $compiler >/dev/null || continue
  $compiler -std=c11 -I"$2" -c -o "$3/layout.o" "$1/layout.c"
  $compiler -std=c++11 -I"$2" -c -o "$3/layout.o" -x c++ "$1/layout.c"
done
