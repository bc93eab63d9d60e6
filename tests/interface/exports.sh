#!/bin/sh
# exports.sh LIBRARY: the library must export talweg_plugin_entry and nothing else.
command -v nm >/dev/null || { echo "skipped: there is no nm"; exit 77; }
names=$(nm -D --defined-only "$1" | awk '{ print $NF }')
test "$names" = talweg_plugin_entry || { echo "$1 exports: $names"; exit 1; }
