#!/usr/bin/env bash
# The shared library exports what its header declares, and nothing else.
# Usage: check_exports.sh LIBRARY HEADER
set -euo pipefail
library="$1" header="$2"

declared="$(sed 's|/\*.*||' "$header" | grep -oE '\bmicroslip_[a-z_]+\(' | grep -v '\*' | tr -d '(' | sort -u)"
exported="$(nm -D --defined-only "$library" | awk '{print $3}' | sort -u)"
if ! diff <(echo "$declared") <(echo "$exported"); then
  echo "left: declared in $header; right: exported by $library" >&2
  exit 1
fi
echo "$(wc -l <<<"$exported") functions"
