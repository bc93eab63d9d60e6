#!/bin/sh
# man_page.sh TALWEG PAGE: the manual page names every command and option of the help, and no others.
set -eu
talweg=$1 page=$2
words() { grep -oE -e '--[a-z][a-z-]+' | sort -u; }

help=$("$talweg" --help)
commands=$(printf '%s\n' "$help" | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
test -n "$commands"
for command in $commands; do
  grep -q "^\.B talweg $command\$" "$page" || { echo "$page has no synopsis of $command"; exit 1; }
  help="$help
$("$talweg" "$command" --help)"
done
in_help=$(printf '%s\n' "$help" | words)
in_page=$(sed 's/\\-/-/g' "$page" | words)
if [ "$in_help" != "$in_page" ]; then
  printf 'Options of the help:\n%s\nand of %s:\n%s\n' "$in_help" "$page" "$in_page"
  exit 1
fi
