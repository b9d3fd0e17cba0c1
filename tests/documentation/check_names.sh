#!/usr/bin/env bash
# Whether a document describes all columns, keys and tables of files that the program wrote: `name [unit]` of CSV,
# "key" of JSON, key and [table] of TOML. Names of channels and joints become those of the document by
# expressions of sed -E. Usage: check_names.sh DOCUMENT [-e EXPRESSION]... FILE...
set -euo pipefail
document="$1"
shift
expressions=(-e '/^$/d')
while [[ "${1:-}" == -e ]]; do
  expressions+=(-e "$2")
  shift 2
done

names() {
  case "$1" in
    *.csv) grep -v '^#' "$1" | sed -n '1s/,/\n/gp' ;;
    *.json) grep -oE '"[A-Za-z_0-9]+":' "$1" | tr -d '":' ;;
    *.toml) sed -nE 's/^([A-Za-z_]+) = .*/\1/p; s/^(\[.*\])$/\1/p' "$1" ;;
  esac | sed -E "${expressions[@]}" | sort -u
}

status=0
count=0
for file in "$@"; do
  found="$(names "$file")"
  [[ -n "$found" ]] || { echo "$file: no names" >&2; status=1; }
  while read -r name; do
    count=$((count + 1))
    grep -qF -e "\`$name\`" -e "$name = " -e "\"$name\": " <(sed 's/^\(\[.*\]\) .*/`\1`/; s/^\(\[.*\]\)$/`\1`/' "$document") && continue
    echo "$file: '$name' is not in $document" >&2
    status=1
  done <<<"$found"
done
echo "$count names in $# files"
exit "$status"
