#!/bin/sh
# pkg_config.sh PREFIX SOURCE VERSION CXX FLAG...: builds and runs a consumer by talweg.pc alone.
set -eu
prefix=$1 source=$2 version=$3
shift 3
if ! command -v pkg-config >/dev/null; then
  echo "SKIPPED: no pkg-config here"
  exit 77
fi
folder=$(dirname "$(find "$prefix" -name talweg.pc)")
export PKG_CONFIG_PATH="$folder"
pkg-config --exact-version="$version" talweg
program=$prefix/smooth_curve_by_pkg_config
# shellcheck disable=SC2046  # several arguments
"$@" -std=c++20 "$source" $(pkg-config --cflags --libs talweg) -o "$program"
LD_LIBRARY_PATH=$(dirname "$folder") "$program"
