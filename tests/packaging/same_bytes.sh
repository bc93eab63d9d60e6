#!/bin/sh
# same_bytes.sh FOLDER: makes the release twice, in new clones whose paths have different lengths, the second
# time without ccache. All files of both releases must have the same bytes. Needs the programs of
# ./run release, and twice its time. Not part of CI.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
rm -rf "$1"
mkdir -p "$1/a/longer/path"
folder=$(cd "$1" && pwd)
for clone in one a/longer/path/two; do
  start=$(date +%s) log=$folder/$(basename "$clone").log
  git clone -q "$project" "$folder/$clone"
  project=$folder/one # the same commit, even if the checkout changes meanwhile
  (cd "$folder/$clone" && ./run page && plugins/packages/release.sh build/release) >"$log" 2>&1 ||
    { tail -n 20 "$log" >&2; exit 1; }
  echo "$clone: $(($(date +%s) - start)) s"
  export CCACHE_DISABLE=1
done
diff "$folder/one/build/release/out/SHA256SUMS" "$folder/a/longer/path/two/build/release/out/SHA256SUMS"
echo "the same bytes: $(wc -l <"$folder/one/build/release/out/SHA256SUMS") files"
