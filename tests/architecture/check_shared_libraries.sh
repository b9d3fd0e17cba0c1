#!/usr/bin/env bash
# Checks the libraries that a program is linked with: at most MOST shared libraries, none of which matches PATTERN.
# Usage: check_shared_libraries.sh PROGRAM MOST PATTERN
set -euo pipefail
program="$1" most="$2" pattern="$3"

libraries="$(ldd "$program" | grep -o 'lib[^ ]*\.so[^ ]*' | xargs -n1 basename | sort -u)"
echo "$libraries"
count="$(wc -l <<<"$libraries")"
if ((count > most)); then
  echo "$program needs $count shared libraries, more than $most" >&2
  exit 1
fi
if grep -E "$pattern" <<<"$libraries"; then
  echo "$program must not need these" >&2
  exit 1
fi
