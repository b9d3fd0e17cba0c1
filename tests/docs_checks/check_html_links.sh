#!/usr/bin/env bash
# Each local link of the pages in a folder leads to a file there, and its #anchor to an id on that page.
# Usage: check_html_links.sh FOLDER
set -euo pipefail
[[ -d $1 ]] || { echo "skipped: no pages in $1, Doxygen has not run"; exit 77; }
cd "$1"

mapfile -t pages < <(find . -name '*.html' -type f -printf '%P\n' | sort)
[[ ${#pages[@]} -gt 0 ]] || { echo "no page in $PWD" >&2; exit 1; }
find . -type f -printf '%P\n' | awk '
  NR == FNR && FILENAME == "-" { there[$0]; next }
  FNR == 1 { folder = FILENAME; sub(/[^\/]*$/, "", folder) }
  {
    text = $0
    while (match(text, / (id|name|href|src)="[^"]*"/)) {
      found = substr(text, RSTART + 1, RLENGTH - 2)
      text = substr(text, RSTART + RLENGTH)
      value = found
      sub(/^[a-z]*="/, "", value)
      if (found ~ /^(id|name)/) {
        anchors[FILENAME "#" value]
      } else if (value !~ /^(https?:|mailto:|javascript:|#$)/) {
        page = value
        sub(/#.*/, "", page)
        page = page == "" ? FILENAME : folder page
        while (sub(/[^\/]+\/\.\.\//, "", page)) {}
        links[page (value ~ /#/ ? substr(value, index(value, "#")) : "")] = FILENAME ":" FNR
        ++count
      }
    }
  }
  END {
    for (link in links) {
      page = link
      sub(/#.*/, "", page)
      if (!(page in there)) wrong = "is not there: " link
      else if (link ~ /#/ && !(link in anchors)) wrong = "no such anchor: " link
      else continue
      print links[link] ": " wrong | "cat 1>&2"
      ++offences
    }
    print ARGC - 2 " pages, " count " links: " offences + 0 " wrong"
    exit offences > 0
  }' - "${pages[@]}"
