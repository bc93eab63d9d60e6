#!/bin/bash
# completion.sh TALWEG: bash completes the commands and options of the help. zsh and fish, if they are
# installed, accept the scripts.
set -eu
talweg=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*"; exit 1; }

"$talweg" completion bash >"$work/bash"
# shellcheck source=/dev/null
. "$work/bash"
completed() { # completed WORD...: what bash offers for the last word
  COMP_WORDS=(talweg "$@") COMP_CWORD=$# COMPREPLY=()
  _talweg
  printf '%s\n' ${COMPREPLY[@]+"${COMPREPLY[@]}"}
}
[[ $(completed sm) == smooth ]] || fail "sm does not become smooth"
[[ $(completed smooth --max-d) == --max-deviation ]] || fail "--max-d does not become --max-deviation"
[[ $(completed smooth m.ply --qui) == --quiet ]] || fail "options of all commands are missing"
[[ -z $(completed smooth m) ]] || fail "files are left to bash"
[[ -z $(completed info --max-d) ]] || fail "info has no --max-deviation"

commands=$("$talweg" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[[ $(completed "" | sort) == "$(sort <<<"$commands")" ]] || fail "not the commands of the help"
for command in $commands; do
  help=$("$talweg" "$command" --help | grep -oE '^ +(-[a-zA-Z],)?--[a-z][a-z-]*' | grep -oE -e '--.*')
  [[ -n $help ]] || fail "$command has no options"
  for option in $help; do
    completed "$command" "$option" | grep -qx -e "$option" || fail "$command: no $option"
  done
done
for shell in zsh fish; do
  "$talweg" completion "$shell" >"$work/$shell"
  grep -q max-deviation "$work/$shell"
  if command -v "$shell" >/dev/null; then
    "$shell" -n "$work/$shell"
  else
    echo "skipped: no $shell (Debian: $shell)"
  fi
done
if "$talweg" completion csh 2>"$work/error"; then fail "csh is completed"; fi
[[ $(wc -l <"$work/error") == 1 ]] || fail "more than a sentence on csh"
