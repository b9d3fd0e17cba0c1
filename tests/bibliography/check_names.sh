#!/usr/bin/env bash
# Fails where docs/theory.md or docs/faq.md names a test, a header or a warning of an identification that does not
# exist. Usage: check_names.sh ROOT
set -euo pipefail
cd "$1"
pages=(docs/theory.md docs/faq.md)
failed=0
fail() { echo "$1" >&2; failed=1; }

# names PATTERN: what stands between backquotes and fits, each once.
names() { grep -ohE "\`$1\`" "${pages[@]}" | tr -d '`' | sort -u; }

while IFS=. read -r suite name; do
  grep -rqE "TEST(_F|_P)?\($suite, $name\)" tests || fail "no test $suite.$name"
done < <(names '[A-Z][A-Za-z]+\.[A-Z][A-Za-z]+')

while read -r header; do
  [[ -f src/microslip/$header ]] || fail "no header src/microslip/$header"
done < <(names '[a-z]+/[a-z_0-9]+\.hpp')

# Codes of warnings: the first column of the table of diagnostics.
count=0
while read -r code; do
  count=$((count + 1))
  grep -rqE "\"$code\"" src/microslip/identify || fail "no warning $code"
done < <(awk '/^## / { on = /diagnostics/ } on && /^\| `/ { split($0, cells, "|"); print cells[2] }' docs/theory.md |
         grep -oE '[a-z]+(_[a-z]+)*')
((count > 0)) || fail "docs/theory.md: no table of diagnostics"
exit $failed
