#!/usr/bin/env bash
# British spelling, by aspell, of all Markdown and pages of Doxygen below ROOT and of the comments in all
# C++ headers; and no word stands twice in succession. Words that aspell does not know are in ROOT/docs/words.txt, one a
# line, sorted (LC_ALL=C), none that is used nowhere.
# Usage: check_spelling.sh ROOT
set -euo pipefail
export LC_ALL=C.UTF-8
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
cd "$1"
words=docs/words.txt

if ! command -v aspell >/dev/null || ! aspell dicts | grep -qx en_GB; then
  echo "skipped: no aspell with British English, scripts/setup installs it"
  exit 77
fi

find_files() {
  find . -mindepth 1 \( -name '.*' -o -path ./build -o -name node_modules \) -prune -o "$@" -type f -printf '%P\n' | sort
}
mapfile -t documents < <(find_files \( -name '*.md' -o -name '*.dox' \))
mapfile -t headers < <(find_files -name '*.hpp')

work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

{
  ((${#documents[@]} == 0)) || awk -f "$here/markdown_parts.awk" "${documents[@]}"
  ((${#headers[@]} == 0)) || awk -f "$here/comment_parts.awk" "${headers[@]}"
} | grep $'^prose\t' >"$work/parts" || { echo "nothing to spell below $PWD" >&2; exit 1; }
mapfile -t places < <(cut -f 2,3 --output-delimiter : "$work/parts")

# Text that is not English is replaced by a ~: names of files and of code, abbreviations in capitals,
# what has digits, commands of Doxygen. So does the 's of names.
cut -f 4- "$work/parts" | sed -E -e 's/\\//g' -e "s/['’]s\b//g" -e 's/@[a-z]+(\{[^}]*\})?/~/g' \
  -e 's/[A-Za-z-]*\.(csv|toml|json|hpp|cpp|md|svg|html|txt|js)\b/~/g' -e 's/(^|[^A-Za-z])\.[a-z0-9]+/\1~/g' \
  -e 's/(doi:)?10\.[0-9]{4,}\/[^] |)]*/~/g' -e 's/[A-Za-z-]+\(/~(/g' \
  -e 's/[A-Za-z0-9_:]*(_|::|[a-z][A-Z]|[A-Z][A-Z]|[0-9])[A-Za-z0-9_:]*/~/g' >"$work/text"

offences=0
offend() {
  echo "$1" >&2
  offences=$((offences + 1))
}

grep -v '^#' "$words" >"$work/words" || true
LC_ALL=C sort -c -u "$work/words" || offend "$words: not sorted, or a word twice"
{ echo "personal_ws-1.1 en 0 utf-8" && cat "$work/words"; } >"$work/personal.pws"

# With -a aspell answers each line by a line a wrong word, "& word n offset: a, b" or "# word offset", and
# a blank one.
misspelt() { # <language> of lines on standard input: "number word suggestions"
  sed 's/^/^/' | aspell --lang="$1" --encoding=utf-8 --personal="$work/personal.pws" --ignore=2 --sug-mode=ultra -a |
    awk 'NR == 1 { next }
         /^$/ { ++line; next }
         /^#/ { print line + 1 "\t" $2 }
         /^&/ { sub(/,$/, "", $7); print line + 1 "\t" $2 "\t" $5, $6, $7 }'
}
misspelt en_GB <"$work/text" >"$work/wrong"

while IFS=$'\t' read -r line word suggestions; do
  place="${places[line - 1]}"
  # Titles of papers keep their spelling.
  if [[ $place == docs/bibliography.md:* ]] && [[ -z $(misspelt en_US <<<"$word") ]]; then continue; fi
  offend "$place: $word${suggestions:+; perhaps $suggestions}"
done <"$work/wrong"

while read -r place word; do
  offend "$place: $word $word"
done < <(paste <(printf '%s\n' "${places[@]}") "$work/text" | awk -F '[\t:]' '{
  if ($1 != file || $2 > line + 1) last = ""
  file = $1
  line = $2
  sub(/^[^\t]*\t/, "")
  count = split($0, word, / +/)
  for (i = 1; i <= count; ++i) {
    if (word[i] == "") continue
    if (word[i] == last && last ~ /^[A-Za-z][a-z]+$/) print file ":" line, last
    last = word[i]
  }
}')

while read -r word; do
  offend "$words: $word is used nowhere"
done < <(awk -F '\t' 'NR == FNR { used[$1]; next } !($1 in used) { print $2 }' \
  <(grep -oE "[[:alpha:]']+" "$work/text" | sed 's/.*/\L&/') \
  <(paste <(sed 's/.*/\L&/' "$work/words") "$work/words"))

echo "${#documents[@]} documents, ${#headers[@]} headers, ${#places[@]} lines: $offences wrong"
((offences == 0))
