#!/usr/bin/env bash
# The shared library exports what its header declares, and nothing else; the module of Fortran has an interface for each
# function and the value of each enumerator.
# Usage: check_exports.sh LIBRARY HEADER MODULE
set -euo pipefail
library="$1" header="$2" module="$3"

declared="$(sed 's|/\*.*||' "$header" | grep -oE '\bmicroslip_[a-z_]+\(' | grep -v '\*' | tr -d '(' | sort -u)"
exported="$(nm -D --defined-only "$library" | awk '{print $3}' | sort -u)"
if ! diff <(echo "$declared") <(echo "$exported"); then
  echo "left: declared in $header; right: exported by $library" >&2
  exit 1
fi

interfaces="$(grep -oE '^ *(function|subroutine) microslip_[a-z_]+\(.*' "$module" | grep -oE 'microslip_[a-z_]+\(' |
  tr -d '(' | grep -vE '^microslip_(strlen|text)$' | sort -u)"
if ! diff <(echo "$declared") <(echo "$interfaces"); then
  echo "left: declared in $header; right: an interface in $module" >&2
  exit 1
fi
values() { grep -oE 'MICROSLIP_[A-Z_]+ = [0-9]+' "$1" | sort -u; }
if ! diff <(values "$header") <(values "$module"); then
  echo "left: enumerators of $header; right: constants of $module" >&2
  exit 1
fi
echo "$(wc -l <<<"$exported") functions"
