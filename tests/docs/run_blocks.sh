#!/usr/bin/env bash
# run_blocks.sh BIN PREFIX SCRIPT FILES FOLDER: runs a script in an empty folder with some meshes and curves
# and the contents of FILES, with Talweg's programs in the path and the package in ~/talweg.
set -eu
bin=$1 prefix=$2 script=$3 files=$4 folder=$5

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
ln -s "$prefix" talweg
if [[ -d $files ]]; then cp "$files"/* .; fi
export HOME=$folder PATH=$bin:$PATH
docs_sandbox
exec bash -eu "$script"
