#!/bin/sh
# check_tag.sh TAG: whether the sources may be released under this tag: it is vVERSION, and the changelog and the
# citation have that version with the same date.
set -eu
project=$(cd "$(dirname "$0")/../.." && pwd)
fail() { echo "check_tag.sh: $*" >&2; exit 1; }
version=$(sed -n 's/^project(talweg VERSION \([0-9.]*\).*/\1/p' "$project/CMakeLists.txt")
[ "$1" = "v$version" ] || fail "the tag is $1, but CMakeLists.txt has version $version"
newest=$(grep -m 1 '^## ' "$project/CHANGELOG.md")
date=${newest#"## $version - "}
case $date in
20[0-9][0-9]-[01][0-9]-[0-3][0-9]) ;;
*) fail "the newest part of CHANGELOG.md is \"$newest\"; it should be \"## $version - YEAR-MONTH-DAY\"" ;;
esac
grep -qx "version: $version" "$project/CITATION.cff" || fail "CITATION.cff has another version than $version"
grep -qx "date-released: $date" "$project/CITATION.cff" || fail "CITATION.cff should have date-released: $date"
