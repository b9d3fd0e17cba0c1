#!/usr/bin/env bash
# Doxygen accepts the public headers without a warning, and no page names a folder of this machine. The
# pages are left in FOLDER/html.
# Usage: check_api.sh DOXYGEN DOXYFILE FOLDER
set -euo pipefail
doxygen="$1" doxyfile="$2" folder="$3"

command -v "$doxygen" >/dev/null || { echo "skipped: no doxygen, scripts/setup installs it"; exit 77; }

rm -rf "$folder"
mkdir -p "$folder"
status=0
said="$( (cat "$doxyfile" && printf 'OUTPUT_DIRECTORY = "%s"\n' "$folder") | "$doxygen" - 2>&1)" || status=$?
if [[ -n $said || $status -ne 0 ]]; then
  printf '%s\n' "$said" >&2
  echo "Doxygen has $(wc -l <<<"$said") lines to say and ends with $status." >&2
  exit 1
fi

headers="$(grep -c '\.hpp"' "$doxyfile" || true)"
((headers > 0)) || { echo "$doxyfile names no header." >&2; exit 1; }

here="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
if grep -rlF "$here" "$folder/html"; then
  echo "These pages hold the path $here." >&2
  exit 1
fi
echo "$headers headers, $(find "$folder/html" -name '*.html' | wc -l) pages"
