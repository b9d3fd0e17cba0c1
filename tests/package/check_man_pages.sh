#!/usr/bin/env bash
# There is a manual page of the program and of each subcommand, roff takes it without a warning, and it
# shows each option that `microslip COMMAND --help` shows.
# Usage: check_man_pages.sh PROGRAM FOLDER
set -euo pipefail
program="$1" folder="$2"

command -v groff >/dev/null || { echo "no groff" >&2; exit 77; }

subcommands() { "$program" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p'; }
options() { "$program" "$@" --help | sed -n '/^Options:/,/^$/p' | grep -oE '^  -[^ ]+' | tr ', ' '\n\n' | grep -- -; }

shown() { gzip -dc "$1" | groff -man -ww -Tutf8 -P-c -P-b -P-o -P-u -rHY=0 -rLL=200n; }

checked=0
check() {
  local page="$folder/$1.1.gz" text warnings option
  shift
  [[ -f $page ]] || { echo "$page is missing" >&2; exit 1; }
  warnings="$(shown "$page" 2>&1 >/dev/null)"
  [[ -z $warnings ]] || { printf '%s:\n%s\n' "$page" "$warnings" >&2; exit 1; }
  text="$(shown "$page")"
  for option in $(options "$@"); do
    grep -qE -- "^ *(-h, )?$option( |,|$)" <<<"$text" || { echo "$page does not show $option" >&2; exit 1; }
  done
  for option in NAME SYNOPSIS OPTIONS "EXIT STATUS" "$("$program" --version)"; do
    grep -qF -- "$option" <<<"$text" || { echo "$page has no $option" >&2; exit 1; }
  done
  checked=$((checked + 1))
}

check microslip
for subcommand in $(subcommands); do
  check "microslip-$subcommand" "$subcommand"
  shown "$folder/microslip.1.gz" | grep -qF "microslip-$subcommand(1)" ||
    { echo "microslip(1) does not name $subcommand" >&2; exit 1; }
done

pages=("$folder"/*)
echo "$checked pages"
[[ $checked -gt 5 && $checked -eq ${#pages[@]} ]] || { echo "pages: ${pages[*]}" >&2; exit 1; }
